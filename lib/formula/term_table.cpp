#include "lib/formula/term_table.hpp"

#include <algorithm>

#include "lib/formula/facts.hpp"

namespace stationary::expression {
namespace {

class TableMaker {
 public:
  TableMaker(Expression& e, std::span<const int> coordinates, std::span<const Interval> parameters)
      : coordinates_(coordinates.begin(), coordinates.end()) {
    roots_.push_back(at_principal_axes(e.graph, e.root));
    for (const Condition& each : e.conditions) {
      // Which of xi and zeta is lambda no sum of terms says; those the tape looks after.
      if (e.graph.is_coefficient(each.node) ||
          occurs(e.graph, each.node, {Variable::lambda, Variable::mu}))
        continue;
      roots_.push_back(condition_at_principal_axes(e.graph, each.node));
      positive_.push_back(each.positive);
    }
    forms_.emplace(e.graph, roots_, parameters);
  }

  TermTable make() {
    out_.coordinates = coordinates_;
    const NormalSum potential = forms_->of(roots_[0]);
    std::vector<NormalSum> force;
    for (const int i : coordinates_) force.push_back(forms_->derivative(potential, i));
    std::vector<std::vector<NormalSum>> slope(force.size());
    for (std::size_t i = 0; i < force.size(); ++i)
      for (std::size_t j = i; j < force.size(); ++j)
        slope[i].push_back(forms_->derivative(force[i], coordinates_[j]));
    add_domain();
    // All atoms are known now.
    for (const Atom& atom : forms_->atoms())
      out_.atoms.push_back({atom.kind, atom.function, atom.positive, entries(atom.sum)});
    for (std::size_t i = 0; i < force.size(); ++i) {
      out_.force.push_back(entries(force[i]));
      Monomial square;
      square.a[static_cast<std::size_t>(coordinates_[i])] = ExactNumber::whole(2);
      out_.pull.push_back(index(square));
      out_.slope.emplace_back();
      for (const NormalSum& each : slope[i]) out_.slope.back().push_back(entries(each));
    }
    return std::move(out_);
  }

 private:
  void add_domain() {
    for (std::size_t k = 0; k < positive_.size(); ++k) {
      try {
        const NormalSum sum = forms_->of(roots_[k + 1]);
        out_.domain.push_back({entries(sum), positive_[k]});
      } catch (const NotNormal&) {  // the tape looks after it
      }
    }
  }

  std::vector<TermEntry> entries(const NormalSum& sum) {
    std::vector<TermEntry> out;
    for (const NormalTerm& term : sum)
      out.push_back({index(term.monomial), term.coefficient.value, term.coefficient.key});
    return out;
  }

  int index(const Monomial& monomial) {
    const auto found = std::ranges::find_if(
        out_.terms, [&](const Monomial& each) { return NormalForms::same(each, monomial); });
    if (found != out_.terms.end()) return static_cast<int>(found - out_.terms.begin());
    out_.terms.push_back(monomial);
    return static_cast<int>(out_.terms.size()) - 1;
  }

  std::vector<int> coordinates_;
  std::vector<NodeId> roots_;  ///< the potential, then conditions
  std::vector<bool> positive_;
  std::optional<NormalForms> forms_;
  TermTable out_;
};

}  // namespace

std::shared_ptr<const TermTable> term_table(const Expression& expression,
                                            std::span<const int> coordinates,
                                            std::span<const Interval> parameters) {
  Expression e = expression;
  try {
    return std::make_shared<const TermTable>(TableMaker(e, coordinates, parameters).make());
  } catch (const std::length_error&) {  // NotNormal, TooLarge
    return nullptr;
  }
}

}  // namespace stationary::expression

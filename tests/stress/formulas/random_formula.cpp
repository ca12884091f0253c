#include "tests/stress/formulas/random_formula.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdio>
#include <initializer_list>
#include <utility>

#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary::stress {
namespace {

using support::Random;
using support::Real50;

template <class T>
T number(const std::string& text) {
  if constexpr (std::is_same_v<T, double>)
    return std::stod(text);
  else
    return T(text);
}

TermPointer made(Operation operation, std::vector<TermPointer> of, std::string spelling,
                 bool harmless = false) {
  return std::make_shared<const Term>(
      Term{operation, "", harmless, std::move(of), std::move(spelling)});
}

TermPointer number_term(const std::string& text) {
  return std::make_shared<const Term>(Term{Operation::number, text, false, {}, text});
}
TermPointer number_term(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", std::abs(value));
  const TermPointer size = number_term(std::string(text));
  if (value >= 0.0) return size;
  return std::make_shared<const Term>(Term{Operation::minus,
                                           "",
                                           false,
                                           {number_term(std::string("0")), size},
                                           "(-" + std::string(text) + ")"});
}

TermPointer binary(Operation operation, const char* sign, const TermPointer& x,
                   const TermPointer& y, bool harmless = false) {
  return made(operation, {x, y}, "(" + x->spelling + sign + y->spelling + ")", harmless);
}
TermPointer operator+(const TermPointer& x, const TermPointer& y) {
  return binary(Operation::plus, " + ", x, y);
}
TermPointer operator-(const TermPointer& x, const TermPointer& y) {
  return binary(Operation::minus, " - ", x, y);
}
TermPointer operator*(const TermPointer& x, const TermPointer& y) {
  return binary(Operation::times, "*", x, y);
}
TermPointer over(const TermPointer& x, const TermPointer& y, bool harmless = false) {
  return binary(Operation::over, "/", x, y, harmless);
}
TermPointer function(Operation operation, const char* name, const TermPointer& x,
                     bool harmless = false) {
  return made(operation, {x}, std::string(name) + "(" + x->spelling + ")", harmless);
}
TermPointer power(const TermPointer& x, const std::string& exponent, bool harmless = false) {
  return made(Operation::power, {x, number_term(exponent)}, x->spelling + "^(" + exponent + ")",
              harmless);
}
TermPointer called(const TermPointer& x, const char* spelling) {
  Term out = *x;
  out.spelling = spelling;
  return std::make_shared<const Term>(std::move(out));
}

/// What the formulas are made of.
struct Quantities {
  TermPointer alpha = made(Operation::alpha, {}, "alpha");
  TermPointer xi = made(Operation::xi, {}, "xi");
  TermPointer zeta = made(Operation::zeta, {}, "zeta");
  TermPointer rho = made(Operation::rho, {}, "rho");
  TermPointer t = called(xi + zeta, "t");
  TermPointer d = called(xi * zeta - alpha * alpha, "d");
  TermPointer I1 = called(xi * xi + zeta * zeta + number_term("2") * (alpha * alpha), "I1");
  TermPointer I2 = called((d * d) + (rho * rho) * I1, "I2");
  TermPointer I3 = called((d * rho) * (d * rho), "I3");
  TermPointer difference = made(Operation::sqrt, {t * t - number_term("4") * d}, "", true);
  TermPointer lambda = called(number_term("0.5") * (t + difference), "lambda");
  TermPointer mu = called(number_term("0.5") * (t - difference), "mu_");

  /// lambda^p + mu_^p.
  TermPointer power_sum(const std::string& p) const {
    return power(lambda, p, true) + power(mu, p, true);
  }
};

/// Decimals of few digits.
std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

class Grammar {
 public:
  explicit Grammar(Random& random) : random_(random) {}

  FormulaCase next() {
    FormulaCase out;
    for (std::string& each : out.inertia) each = decimal(random_.log_uniform(0.4, 2.5));
    if (out.inertia[0] == out.inertia[1]) out.inertia[1] += "1";
    out.branch = static_cast<char>(random_.integer(1, 3));
    out.nu = decimal(random_.log_uniform(0.1, chance(0.3) ? 12.0 : 1.5));
    out.anisotropic = chance(0.36);
    out.energy = base();
    if (out.anisotropic) out.energy = out.energy + fibre(out.branch == 3 && chance(0.3));
    const int extra = random_.integer(0, 2);
    for (int k = 0; k < extra; ++k)
      out.energy = out.energy + weight(0.2) * bounded(argument(out.anisotropic));
    if (chance(0.3)) {
      out.energy = out.energy + with_pole(out.anisotropic);
      out.has_pole = true;
    }
    if (chance(0.3)) {
      out.energy = out.energy + with_condition(out.anisotropic);
      out.has_condition = true;
    }
    if (chance(0.4)) out.domain = border();
    return out;
  }

 private:
  bool chance(double of) { return random_.uniform(0.0, 1.0) < of; }
  TermPointer weight(double size) {
    return number_term(size * random_.sign() * random_.log_uniform(0.1, 1.0));
  }
  TermPointer positive(double low, double high) {
    return number_term(decimal(random_.log_uniform(low, high)));
  }

  /// Grows without bound at both ends, least near 1.
  TermPointer base() {
    const TermPointer m = positive(0.5, 3.0);
    const TermPointer k = positive(0.5, 6.0);
    const TermPointer volume = q_.d * q_.rho;
    const TermPointer log_volume =
        function(Operation::log, chance(0.5) ? "log" : "ln", volume, true);
    switch (random_.integer(0, 5)) {
      case 0:
        return m * (q_.I1 + q_.rho * q_.rho) - number_term("2") * m * log_volume +
               k * (log_volume * log_volume);
      case 1:
        return m * (q_.I1 + q_.rho * q_.rho) + over(k, volume, true);
      case 2:
        return m * over(q_.I2, q_.I3, true) + k * function(Operation::sqrt, "sqrt", q_.I3, true);
      case 3: {
        const std::string p = decimal(random_.uniform(1.1, 3.5));
        return m * (q_.power_sum(p) + power(q_.rho, p, true)) - number_term(p) * m * log_volume;
      }
      case 4:
        return m * (q_.I1 + over(number_term("2"), q_.d, true)) +
               k * (q_.rho + over(number_term("1"), q_.rho, true));
      default:
        return m * (q_.I1 * q_.I1 + power(q_.rho, "4", true)) + k * over(q_.I1, q_.I3, true) +
               function(Operation::exp, "exp", number_term("0") - log_volume);
    }
  }

  TermPointer fibre(bool oblique) {
    const TermPointer k = positive(0.1, 2.0);
    const TermPointer along =
        oblique ? called(number_term("0.5") * (q_.xi * q_.xi + q_.zeta * q_.zeta) +
                             q_.alpha * q_.alpha + q_.alpha * (q_.xi + q_.zeta),
                         "(I1/2 + alpha*(xi + zeta))")
                : q_.xi * q_.xi + q_.alpha * q_.alpha;
    switch (random_.integer(0, 2)) {
      case 0:
        return k * power(along - number_term("1"), "2", true);
      case 1:
        return k * along;
      default:
        return k * function(Operation::exp, "exp", number_term("0.2") * along);
    }
  }

  TermPointer argument(bool anisotropic) {
    const TermPointer k = positive(0.2, 2.0);
    switch (random_.integer(0, anisotropic ? 7 : 5)) {
      case 0:
        return k * q_.d;
      case 1:
        return k * q_.rho;
      case 2:
        return k * (q_.I1 - q_.rho * q_.rho);
      case 3:
        return k * over(q_.rho, q_.d, true);
      case 4:
        return k * (q_.t * q_.t);
      case 5:
        return k * over(q_.I2, q_.I1, true);
      case 6:
        return k * q_.zeta;
      default:
        return k * (q_.alpha * q_.alpha);
    }
  }

  /// With all its derivatives where the argument is positive.
  TermPointer bounded(const TermPointer& x) {
    switch (random_.integer(0, 8)) {
      case 0:
        return function(Operation::sin, "sin", x);
      case 1:
        return function(Operation::cos, "cos", x);
      case 2:
        return function(Operation::tanh, "tanh", x);
      case 3:
        return function(Operation::atan, "atan", x);
      case 4:
        return function(Operation::exp, "exp", number_term("0") - x * x);
      case 5:
        return function(Operation::sqrt, "sqrt", number_term("1") + x * x, true);
      case 6:
        return power(number_term("1") + x * x, decimal(random_.uniform(-1.5, 0.9)), true);
      case 7: {
        const TermPointer a = positive(0.1, 2.0);
        const TermPointer b = positive(0.1, 2.0);
        const TermPointer least = made(chance(0.5) ? Operation::min : Operation::max, {a, b}, "");
        const char* name = least->operation == Operation::min ? "min(" : "max(";
        return called(least, (name + a->spelling + ", " + b->spelling + ")").c_str()) *
               function(Operation::tanh, "tanh", x);
      }
      default: {
        const TermPointer a = number_term("0") - positive(0.1, 2.0);
        return made(Operation::abs, {a}, "abs(" + a->spelling + ")") *
               function(Operation::sin, "sin", x);
      }
    }
  }

  /// A quantity less a number that it passes.
  TermPointer passing(bool anisotropic) {
    switch (random_.integer(0, anisotropic ? 5 : 4)) {
      case 0:
        return positive(1.3, 4.0) - q_.d;
      case 1:
        return q_.rho - positive(0.2, 0.8);
      case 2:
        return positive(3.5, 12.0) - (q_.I1 + q_.rho * q_.rho);
      case 3:
        return q_.d * q_.rho - positive(0.1, 0.8);
      case 4:
        return positive(3.0, 6.0) - q_.t;
      default:
        return positive(1.2, 3.0) - q_.xi;
    }
  }

  TermPointer with_pole(bool anisotropic) {
    const TermPointer x = passing(anisotropic);
    switch (random_.integer(0, 3)) {
      case 0:
        return over(weight(0.05), x);
      case 1:
        return over(positive(0.005, 0.1), power(x, "2", true));
      case 2:
        return weight(0.05) * power(x, "-3");
      default:
        return weight(0.02) * over(bounded(argument(anisotropic)), x);
    }
  }

  TermPointer with_condition(bool anisotropic) {
    const TermPointer x = passing(anisotropic);
    switch (random_.integer(0, 4)) {
      case 0:
        return number_term("0") - positive(0.02, 0.5) * function(Operation::log, "log", x);
      case 1:
        return weight(0.1) * function(Operation::sqrt, "sqrt", x);
      case 2: {
        const std::string p = decimal(random_.uniform(1.1, 3.9)) + "1";
        return weight(0.2) *
               made(Operation::power, {x, number_term(p)}, "pow(" + x->spelling + ", " + p + ")");
      }
      case 3:
        return weight(0.2) * (x * function(Operation::log, "ln", x));
      default: {
        // A tangent that stays on its branch: the poles are beyond what passes.
        const TermPointer y = over(argument(false), number_term("1000"), true);
        return weight(0.2) * function(Operation::tan, "tan", y, true) +
               positive(0.02, 0.2) * power(x, "2.5");
      }
    }
  }

  /// What must be positive besides, near enough to be met.
  TermPointer border() {
    switch (random_.integer(0, 3)) {
      case 0:
        return positive(1.02, 1.5) - q_.d * q_.rho;
      case 1:
        return q_.rho - positive(0.7, 0.97);
      case 2:
        return positive(3.1, 5.0) - (q_.I1 + q_.rho * q_.rho);
      default:
        return positive(2.05, 3.0) - q_.t;
    }
  }

  Random& random_;
  Quantities q_;
};

template <class T>
class Evaluation {
 public:
  Evaluation(const std::array<T, 4>& q, Evaluated<T>& out) : q_(q), out_(out) {}

  Jet<T> operator()(const Term& term) {
    using std::abs, std::atan, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt,
        std::tan, std::tanh;
    const auto of = [&](std::size_t k) { return (*this)(*term.of[k]); };
    switch (term.operation) {
      case Operation::number:
        return Jet<T>(number<T>(term.text));
      case Operation::alpha:
        return Jet<T>::variable(q_[0], 0);
      case Operation::xi:
        return Jet<T>::variable(q_[1], 1);
      case Operation::zeta:
        return Jet<T>::variable(q_[2], 2);
      case Operation::rho:
        return Jet<T>::variable(q_[3], 3);
      case Operation::plus:
        return of(0) + of(1);
      case Operation::minus:
        return of(0) - of(1);
      case Operation::times:
        return of(0) * of(1);
      case Operation::over: {
        const Jet<T> y = of(1);
        if (!term.harmless) denominator(y.value);
        const T r = T(1) / y.value;
        return of(0) * y.through(r, -r * r, T(2) * r * r * r);
      }
      case Operation::power: {
        const Jet<T> x = of(0);
        const std::string& text = term.of[1]->text;
        const T p = number<T>(text);
        const bool whole = text.find('.') == std::string::npos;
        if (!term.harmless && !whole) argument(x.value);
        if (!term.harmless && whole && p < T(0)) denominator(x.value);
        if (whole) {
          const int n = std::stoi(text);
          return x.through(raised(x.value, n), p * raised(x.value, n - 1),
                           p * (p - T(1)) * raised(x.value, n - 2));
        }
        const T f = pow(x.value, p);
        return x.through(f, p * f / x.value, p * (p - T(1)) * f / (x.value * x.value));
      }
      case Operation::sqrt: {
        const Jet<T> x = of(0);
        if (!term.harmless) argument(x.value);
        const T f = sqrt(x.value);
        return x.through(f, T(1) / (T(2) * f), T(-1) / (T(4) * f * x.value));
      }
      case Operation::exp: {
        const Jet<T> x = of(0);
        const T f = exp(x.value);
        return x.through(f, f, f);
      }
      case Operation::log: {
        const Jet<T> x = of(0);
        if (!term.harmless) argument(x.value);
        return x.through(log(x.value), T(1) / x.value, T(-1) / (x.value * x.value));
      }
      case Operation::sin: {
        const Jet<T> x = of(0);
        const T f = sin(x.value);
        return x.through(f, cos(x.value), -f);
      }
      case Operation::cos: {
        const Jet<T> x = of(0);
        const T f = cos(x.value);
        return x.through(f, -sin(x.value), -f);
      }
      case Operation::tan: {
        const Jet<T> x = of(0);
        const T f = tan(x.value);
        return x.through(f, T(1) + f * f, T(2) * f * (T(1) + f * f));
      }
      case Operation::tanh: {
        const Jet<T> x = of(0);
        const T f = tanh(x.value);
        return x.through(f, T(1) - f * f, T(-2) * f * (T(1) - f * f));
      }
      case Operation::atan: {
        const Jet<T> x = of(0);
        const T g = T(1) / (T(1) + x.value * x.value);
        return x.through(atan(x.value), g, T(-2) * x.value * g * g);
      }
      case Operation::abs:
        return Jet<T>(abs(of(0).value));
      case Operation::min:
        return Jet<T>(std::min(of(0).value, of(1).value));
      default:
        return Jet<T>(std::max(of(0).value, of(1).value));
    }
  }

 private:
  static T raised(const T& x, int n) {
    T out(1);
    for (int k = 0; k < std::abs(n); ++k) out *= x;
    return n < 0 ? T(T(1) / out) : out;
  }
  void argument(const T& x) {
    if (!(x > T(0))) out_.defined = false;
    if (x < out_.nearest) out_.nearest = x;
  }
  void denominator(const T& x) {
    if (x == T(0)) out_.defined = false;
    out_.positive.push_back(x > T(0));
    const T size = x > T(0) ? x : T(-x);
    if (size < out_.nearest) out_.nearest = size;
  }

  const std::array<T, 4>& q_;
  Evaluated<T>& out_;
};

}  // namespace

template <class T>
Evaluated<T> evaluated(const Term& term, const std::array<T, 4>& q) {
  Evaluated<T> out;
  out.energy = Evaluation<T>(q, out)(term);
  return out;
}
template Evaluated<double> evaluated(const Term&, const std::array<double, 4>&);
template Evaluated<Real50> evaluated(const Term&, const std::array<Real50, 4>&);

std::string FormulaCase::text(bool with_domain) const {
  std::string out = "[body]\nJ = [" + inertia[0] + ", " + inertia[1] + ", " + inertia[2] +
                    "]\n[potential]\ncoupled = { expression = \"" + energy->spelling + "\"";
  if (domain && with_domain) out += ", domain = \"" + domain->spelling + " > 0\"";
  constexpr std::array names{"i", "ii", "iii"};
  return out + " }\n[motion]\nbranch = \"" + names[static_cast<std::size_t>(branch - 1)] +
         "\"\nnu = " + nu + "\n";
}

FormulaCase random_formula_case(Random& random) { return Grammar(random).next(); }

}  // namespace stationary::stress

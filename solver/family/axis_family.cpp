#include "solver/family/axis_family.hpp"

#include "solver/family/anisotropic_family.hpp"
#include "solver/family/model_family.hpp"

namespace stationary {
namespace {

template <class Model, int N>
AnyFamily model_family(const Problem& problem, const Model& model,
                       const AxisFamilyOptions& options) {
  return std::make_unique<ModelFamily<Model, N>>(problem.body(), problem.branch(), model, options,
                                                 problem);
}

}  // namespace

AnyFamily axis_family(const Problem& problem, const AxisFamilyOptions& options, bool alpha_free) {
  if (!problem.potential().is_isotropic())
    return anisotropic_family(problem.body(), problem.potential().anisotropic(), problem.branch(),
                              alpha_free, options);
  const bool constant = problem.thickness_rule() == ThicknessRule::constant &&
                        options.parameter.kind != FamilyParameter::Kind::thickness &&
                        options.parameter.kind != FamilyParameter::Kind::shared;
  return problem.potential().visit_parts([&](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    // A thickness of which there may be several, a formula's, is carried along by each sheet. Where
    // all are one type it is asked whether it is: steps depend on how many unknowns there are.
    if constexpr (requires { model.plane; } && (few_types || !several_thicknesses<Model>))
      if (constant && problem.potential().is_built_in())
        return model_family<Model, 2>(problem, model, options);
    return model_family<Model, 3>(problem, model, options);
  });
}

}  // namespace stationary

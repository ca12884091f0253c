// Every model's domain, by name and by value: each inequality is enforced and named; the run-time
// class gives back what it was made of.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "lib/material/models/orthotropic_saint_venant_kirchhoff.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/bodies/models.hpp"

namespace stationary {
namespace {

using namespace support;

using Kind = ModelDescription::Kind;

void make(const ModelDescription& model, const std::vector<double>& coefficients) {
  switch (model.kind) {
    case Kind::planar:
      Potential::planar(model.name, coefficients);
      break;
    case Kind::thickness:
      Potential::thickness(model.name, coefficients);
      break;
    case Kind::coupled:
      Potential::coupled(model.name, coefficients);
      break;
    case Kind::fibre:
    case Kind::whole:
      FAIL() << "no model of its own";
  }
}

/// The message refused with, or empty.
std::string refusal(const ModelDescription& model, const std::vector<double>& coefficients) {
  try {
    make(model, coefficients);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ModelDescriptions, ListEveryModelOnceUnderItsName) {
  const auto& all = model_descriptions();
  EXPECT_EQ(all.size(), std::variant_size_v<PlanarPotential> +
                            std::variant_size_v<ThicknessPotential> +
                            std::variant_size_v<CoupledPotential>);
  std::set<std::string_view> names;
  for (const auto& model : all) {
    EXPECT_TRUE(names.insert(model.name).second) << model.name;
    EXPECT_FALSE(model.formula.empty());
    EXPECT_FALSE(model.parameters.empty());
    EXPECT_FALSE(model.domain.empty());
    // Every parameter occurs in the formula, and in some inequality.
    for (const std::string& parameter : model.parameters) {
      EXPECT_NE(model.formula.find(parameter), std::string_view::npos) << model.name << parameter;
      bool bounded = false;
      for (const std::string& inequality : model.domain)
        bounded = bounded || inequality.find(parameter) != std::string_view::npos;
      EXPECT_TRUE(bounded) << model.name << " " << parameter;
    }
  }
}

TEST(PotentialDomain, UnitCoefficientsAreInside) {
  for (const auto& model : model_descriptions())
    EXPECT_NO_THROW(make(model, std::vector<double>(model.parameters.size(), 1.0))) << model.name;
}

TEST(PotentialDomain, EachInequalityIsEnforcedAndNamed) {
  // Lowering one coefficient at a time from inside must break each inequality at some point.
  for (const auto& model : model_descriptions()) {
    std::set<std::string> named;
    for (std::size_t k = 0; k < model.parameters.size(); ++k) {
      for (const double value : {0.0, -0.5, -1.0, -2.0, -100.0}) {
        std::vector<double> coefficients(model.parameters.size(), 1.0);
        coefficients[k] = value;
        const std::string message = refusal(model, coefficients);
        if (!message.empty()) named.insert(message);
      }
    }
    for (const std::string& inequality : model.domain)
      EXPECT_TRUE(named.contains(inequality)) << model.name << ": " << inequality;
    EXPECT_EQ(named.size(), model.domain.size()) << model.name;
  }
}

TEST(PotentialDomain, EachCoefficientMustBeFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& model : model_descriptions()) {
    for (std::size_t k = 0; k < model.parameters.size(); ++k) {
      for (const double value : {infinity, -infinity, std::nan("")}) {
        std::vector<double> coefficients(model.parameters.size(), 1.0);
        coefficients[k] = value;
        EXPECT_EQ(refusal(model, coefficients), std::string(model.parameters[k]) + " finite")
            << model.name;
      }
    }
  }
}

TEST(PotentialDomain, BoundariesAreOutside) {
  const std::array<double, 2> on_the_edge{1.0, -1.0};
  const std::array<double, 2> just_inside{1.0, std::nextafter(-1.0, 0.0)};
  for (const char* name : {"biot", "biot-log", "neo-hookean", "hencky", "saint-venant-kirchhoff"}) {
    EXPECT_THROW(Potential::planar(name, on_the_edge), std::invalid_argument) << name;
    EXPECT_NO_THROW(Potential::planar(name, just_inside)) << name;
  }
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_NO_THROW(Potential::planar("reciprocal-determinant", std::array{smallest, 1.0}));
  EXPECT_THROW(Potential::planar("reciprocal-determinant", std::array{0.0, 1.0}),
               std::invalid_argument);
  EXPECT_NO_THROW(Potential::coupled("neo-hookean-3d", std::array{3.0, -1.999}));
  EXPECT_THROW(Potential::coupled("neo-hookean-3d", std::array{3.0, -2.0}), std::invalid_argument);
  using Inside = std::array<bool, 4>;
  const auto orthotropic = [](double c11, double c22, double c12, double c66) {
    return OrthotropicSaintVenantKirchhoff<>{c11, c22, c12, c66}.in_domain();
  };
  EXPECT_EQ(orthotropic(4.0, 1.0, 1.9, smallest), (Inside{true, true, true, true}));
  EXPECT_EQ(orthotropic(4.0, 1.0, 2.0, 0.0), (Inside{true, true, false, false}));
  EXPECT_EQ(orthotropic(0.0, 1.0, 0.0, 1.0), (Inside{false, true, false, true}));
  EXPECT_EQ(orthotropic(1.0, 0.0, 0.0, 1.0), (Inside{true, false, false, true}));
}

TEST(PotentialDomain, NamesAndCountsAreChecked) {
  for (const auto& model : model_descriptions()) {
    for (const std::size_t count : {model.parameters.size() - 1, model.parameters.size() + 1}) {
      const std::string message = refusal(model, std::vector<double>(count, 1.0));
      EXPECT_EQ(message, std::string(model.name) + " takes " +
                             std::to_string(model.parameters.size()) + " coefficients");
    }
  }
  const std::array<double, 2> one{1.0, 1.0};
  for (const char* name : {"", "Biot", "biot ", "neo-hookean-3d", "harmonic", "rubber"})
    EXPECT_THROW(Potential::planar(name, one), std::invalid_argument) << name;
  EXPECT_THROW(Potential::thickness("biot", one), std::invalid_argument);
  EXPECT_THROW(Potential::coupled("biot", one), std::invalid_argument);
  try {
    Potential::planar("rubber", one);
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"rubber\""), std::string::npos);
  }
}

TEST(PotentialDomain, ConstructorsEnforceItToo) {
  const ReciprocalQuadratic<> thickness{1.0, 1.0};
  EXPECT_THROW(Potential(Biot<>{-1.0, 2.0}, thickness), std::invalid_argument);
  EXPECT_THROW(Potential(Biot<>{1.0, 2.0}, ReciprocalQuadratic<>{0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(Potential(CoupledPotential(NeoHookean3d<>{0.0, 1.0})), std::invalid_argument);
}

TEST(Potential, GivesBackItsParts) {
  const Potential separable(BiotLog<>{1.0, 0.6}, Harmonic<>{2.0, 0.8});
  EXPECT_TRUE(separable.is_separable());
  EXPECT_EQ(std::get<BiotLog<>>(separable.plane()).lambda, 0.6);
  EXPECT_EQ(std::get<Harmonic<>>(separable.thickness()).rest, 0.8);
  EXPECT_THROW(separable.coupled(), std::bad_variant_access);
  const Potential coupled(CoupledPotential(NeoHookean3d<>{1.0, 0.5}));
  EXPECT_FALSE(coupled.is_separable());
  EXPECT_EQ(std::get<NeoHookean3d<>>(coupled.coupled()).lambda, 0.5);
  EXPECT_THROW(coupled.plane(), std::bad_variant_access);
  EXPECT_THROW(coupled.thickness(), std::bad_variant_access);
}

TEST(Potential, ByNameKeepsTheOrderOfCoefficients) {
  const auto plane = Potential::planar("hencky", std::array{1.5, -0.25});
  EXPECT_EQ(std::get<Hencky<>>(plane).mu, 1.5);
  EXPECT_EQ(std::get<Hencky<>>(plane).lambda, -0.25);
  const auto thickness = Potential::thickness("reciprocal-quadratic", std::array{0.5, 3.0});
  EXPECT_EQ(std::get<ReciprocalQuadratic<>>(thickness).a, 0.5);
  EXPECT_EQ(std::get<ReciprocalQuadratic<>>(thickness).b, 3.0);
}

}  // namespace
}  // namespace stationary

// Random anisotropic potentials from fixed seeds: every planar model with fibres, the orthotropic
// one with and without, coupled ones; some of them even in alpha.
#pragma once

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "lib/material/anisotropic_potential.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::support {

struct Anisotropic {
  AnisotropicPotential V;
  std::string text;
};

/// kind: runs through the models, whatever it is.
inline Anisotropic random_anisotropic(Random& random, int kind) {
  std::vector<Fibre> fibres{{random.log_uniform(0.1, 2.0), random.uniform(-90.0, 90.0)}};
  switch (random.integer(0, 4)) {
    case 0:
      fibres[0].degrees = 90.0 * random.integer(0, 1);
      break;
    case 1:
      fibres.push_back({fibres[0].k, -fibres[0].degrees});
      break;
    case 2:
      fibres.push_back({random.log_uniform(0.1, 2.0), random.uniform(-90.0, 90.0)});
      break;
    default:
      break;
  }
  const double mu = random.log_uniform(0.5, 2.0);
  const double lambda = random.uniform(0.0, 2.0);
  const ThicknessPotential thickness =
      kind % 2 == 0 ? ThicknessPotential(ReciprocalQuadratic<>{random.log_uniform(0.5, 2.0), 3.0})
                    : ThicknessPotential(Harmonic<>{random.log_uniform(2.0, 5.0), 0.9});
  std::ostringstream text;
  text.precision(17);
  text << "kind " << kind % 8 << ", mu " << mu << ", lambda " << lambda;
  for (const Fibre& fibre : fibres) text << ", fibre " << fibre.k << " at " << fibre.degrees;
  const auto plane = [&](const AnisotropicPotential::Plane& model) {
    return Anisotropic{AnisotropicPotential(model, thickness, fibres), text.str()};
  };
  switch (kind % 8) {
    case 0:
      return plane(NeoHookean<>{mu, lambda});
    case 1:
      return plane(Biot<>{mu, lambda});
    case 2:
      return plane(BiotLog<>{mu, lambda});
    case 3:
      return plane(Hencky<>{mu, lambda});
    case 4:
      return plane(SaintVenantKirchhoff<>{mu, lambda});
    case 5:
      return plane(ReciprocalDeterminant<>{mu, 1.0 + lambda});
    case 6:
      return plane(
          OrthotropicSaintVenantKirchhoff<>{2.0 + mu, 2.0 + lambda, 0.5 * lambda, 0.3 * mu});
    default:
      return {AnisotropicPotential(NeoHookean3d<>{mu, lambda}, fibres), text.str()};
  }
}

}  // namespace stationary::support

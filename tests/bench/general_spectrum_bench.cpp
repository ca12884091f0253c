// What the general spectrum costs (with energies, class and bounds) beside Eigen's QR algorithm on
// the 11x11 matrix of the Lie-Poisson equations (eigenvalues alone, its matrix given), in turns, by
// the processor's time: of tilted and oblique motions, of a fibred body about axis 3, whose leaf has
// parts, V_qq included; and of a heavy body about an axis in no plane, whose leaf no symmetry
// divides and is given. Prints microseconds, medians of 25, and their ratio.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "lib/stability/general_spectrum.hpp"
#include "solver/kind/kind.hpp"
#include "solver/motion/oriented_stability.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/solve.hpp"
#include "solver/solve/tilted_equilibrium.hpp"

namespace stationary {
namespace {

struct Sample {
  Body body;
  Potential potential;
  BasicStretch<DoubleDouble> q;
  Vector3<DoubleDouble> nu;
};

using SpectrumOf = std::function<Spectrum(const Sample&)>;

using Matrix11 = Eigen::Matrix<double, 11, 11>;

/// d(z')/dz of z = (pi, q, p) before the leaf.
Matrix11 linearized(const Sample& at) {
  const Stretch q{double(at.q.alpha), double(at.q.xi), double(at.q.zeta), double(at.q.rho)};
  const Vector3<double> nu(double(at.nu[0]), double(at.nu[1]), double(at.nu[2]));
  Eigen::Matrix<double, 7, 11> B = Eigen::Matrix<double, 7, 11>::Zero();
  B.topLeftCorner<3, 3>().setIdentity();
  B.bottomRightCorner<4, 4>().setIdentity();
  B.middleCols<4>(3) = -steady_momenta_jacobian(at.body, q, nu);
  Matrix11 H = B.transpose() * mass_matrix(at.body, q).ldlt().solve(B);
  Matrix4<double> V_qq;
  if (const auto* whole = at.potential.body_model()) {
    V_qq = whole->derivatives<2>(q).hessian;
  } else if (at.potential.is_isotropic()) {
    at.potential.visit_parts(
        [&](const auto& model) { V_qq = potential_derivatives<2>(model, q).hessian; });
  } else {
    V_qq = potential_derivatives<2>(at.potential.anisotropic().model(), q).hessian;
  }
  H.block<4, 4>(3, 3) += V_qq - centrifugal_matrix(at.body, nu);
  const auto crossed_with = [](const Vector3<double>& a) {  // the matrix of x -> a x x
    Matrix3<double> out;
    out << 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0;
    return out;
  };
  const Vector3<double> pi = locked_inertia(at.body, q) * nu;
  Matrix11 out;
  out.topRows<3>() = -crossed_with(pi) * H.topRows<3>();
  out.topLeftCorner<3, 3>() += crossed_with(nu);
  out.middleRows<4>(3) = H.bottomRows<4>();
  out.bottomRows<4>() = -H.middleRows<4>(3);
  return out;
}

/// Seconds of this processor's time that a pass takes.
template <class Pass>
double seconds(const Pass& pass) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  pass();
  return now() - start;
}

void print(const std::string& what, const std::vector<Sample>& motions,
           const SpectrumOf& spectrum) {
  constexpr int repeats = 25;
  constexpr int passes = 20;
  std::vector<Matrix11> matrices;
  for (const Sample& at : motions) matrices.push_back(linearized(at));
  std::array<std::vector<double>, 2> each;
  double used = 0.0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    each[0].push_back(seconds([&] {
      for (int pass = 0; pass < passes; ++pass)
        for (const Sample& at : motions) used += spectrum(at).growth;
    }));
    each[1].push_back(seconds([&] {
      for (int pass = 0; pass < passes; ++pass)
        for (const Matrix11& matrix : matrices)
          used += Eigen::EigenSolver<Matrix11>(matrix, false).eigenvalues()[0].real();
    }));
  }
  std::array<double, 2> microseconds;
  for (std::size_t k = 0; k < 2; ++k) {
    std::ranges::nth_element(each[k], each[k].begin() + repeats / 2);
    microseconds[k] = 1e6 * each[k][repeats / 2] / static_cast<double>(passes * motions.size());
  }
  std::printf("%-28s %9.2f %9.2f %8.2f   (%zu motions, checksum %g)\n", what.c_str(),
              microseconds[0], microseconds[1], microseconds[0] / microseconds[1], motions.size(),
              used);
}

Vector3<DoubleDouble> widened(const Vector3<double>& x) { return {x[0], x[1], x[2]}; }
BasicStretch<DoubleDouble> widened(const Stretch& q) { return {q.alpha, q.xi, q.zeta, q.rho}; }

}  // namespace
}  // namespace stationary

int main() {
  using namespace stationary;
  const std::array plane{1.0, 2.0};
  const std::array axial{1.0, 3.0};
  const Body body(1.0, 1.7, 0.6);
  std::vector<Sample> tilted;
  const Potential isotropic(Potential::planar("neo-hookean", plane),
                            Potential::thickness("reciprocal-quadratic", axial));
  for (int k = 0; k < 16; ++k) {
    const double nu = 0.7485 + 0.0008 * k;
    const Equilibrium found = solve_tilted(body, isotropic, {TiltPlane::one_three, nu});
    if (found.status == SolveStatus::solved)
      tilted.push_back({body, isotropic, widened(found.q), widened(found.nu)});
  }
  const Potential fibred(
      AnisotropicPotential(BiotLog<>{1.0, 2.0}, ReciprocalQuadratic<>{1.0, 3.0}, {{0.5, 25.0}}));
  SolveOptions near;
  near.search = false;
  std::vector<Sample> oblique;
  std::vector<Sample> third;
  for (int k = 1; k <= 16; ++k) {
    const double nu = 0.02 * k;
    const Equilibrium aside = solve_oblique(body, fibred, {nu, Branch::i}, near);
    if (aside.status == SolveStatus::solved)
      oblique.push_back({body, fibred, widened(aside.q), widened(aside.nu)});
    const Equilibrium along = solve(Problem(body, fibred, Branch::iii), nu, near);
    if (along.status == SolveStatus::solved)
      third.push_back({body, fibred, widened(along.q), widened(along.nu)});
  }
  const OrientedModels models(fibred.anisotropic());
  BodyModel<> heavy = Potential(Potential::planar("biot", std::array{0.3755, 3.004}),
                                Potential::thickness("harmonic", std::array{1.0, 1.5321}))
                          .as_body();
  heavy.gravitates = true;
  heavy.g = 2.0;
  heavy.J = {body.J1, body.J2, body.J3};
  near.start = Stretch{0.26, 1.05, 0.75, 0.92};
  std::vector<Sample> whole;
  for (int k = 0; k < 16; ++k) {
    const Potential V(heavy);
    const Equilibrium found = kind_of(body, V, SpatialRotation{0.5026 + 1e-5 * k})->solve(near);
    if (found.status == SolveStatus::solved)
      whole.push_back({body, V, widened(found.q), widened(found.nu)});
  }
  const SpectrumOf undivided = [](const Sample& at) {
    return general_spectrum(at.body, at.potential, at.q, at.nu, 0x1p-53);
  };
  const auto oriented = [&](Branch branch, bool about_axis) {
    return [&models, spin = OrientedSpin{body, branch, about_axis}](const Sample& at) {
      return oriented_stability(spin, models, at.q, at.nu, 0x1p-53);
    };
  };
  std::printf("%-28s %9s %9s %8s\n", "microseconds", "general", "QR 11x11", "ratio");
  print("tilted (reversible)", tilted, undivided);
  print("oblique (reversible)", oblique, oriented(Branch::i, false));
  print("(iii), fibred (by parts)", third, oriented(Branch::iii, true));
  std::vector<Leaf> leaves;
  for (const Sample& at : whole) leaves.push_back(motion_leaf(body, at.potential, at.q, at.nu));
  print("in no plane (whole)", whole, [&](const Sample& at) {
    return general_spectrum({MaterialSymmetry::none, 0x1p-53},
                            leaves[static_cast<std::size_t>(&at - whole.data())]);
  });
}

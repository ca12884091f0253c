// Spectra of bodies with gravity or a held volume against motion in time: X = (Phi1, Phi2, rho), the
// third column of Phi being rho n, n the unit normal of (Phi1, Phi2), with the multiplier P of
// d rho = C,
//
//   Dy^T J (Dy X'' + D^2 y[X', X']) = -grad V + P grad(d rho),   (d rho)'' = 0.
//
// Nothing here is the library's: gravity is quadrature, and no angular momentum, stretch or
// elimination occurs. The program is asked for the motion, its pressure and its spectrum.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using Vector3 = Eigen::Vector3d;
using Vector7 = Eigen::Matrix<double, 7, 1>;
using Vector14 = Eigen::Matrix<double, 14, 1>;
using Complex = std::complex<double>;

/// Derivatives of V in I1 = |Phi1|^2 + |Phi2|^2, d and rho.
struct Slopes {
  double of_trace = 0.0;
  double of_d = 0.0;
  double of_rho = 0.0;
};
using Elastic = std::function<Slopes(double I1, double d, double rho)>;

struct BodyInSpace {
  double J[3];
  double g = 0.0;
  bool holds_volume = true;
  Elastic elastic = [](double, double, double) { return Slopes{}; };
  double fibre = 0.0;  ///< k
  double degrees = 0.0;
};

/// F_T, F_D, F_z of F = (1/2) int_0^inf du [(u^2 + T u + D)(u + z)]^(-1/2), by the trapezoidal rule
/// in ln u, which converges geometrically.
std::array<double, 3> pull_of_gravity(double T, double D, double z) {
  std::array<double, 3> out{};
  constexpr double h = 0.35;
  for (double x = -42.0; x < 30.0; x += h) {
    const double u = std::exp(x);
    const double plane = u * u + T * u + D;
    const double axis = u + z;
    const double own = h * u / std::sqrt(plane * axis);
    out[0] -= 0.25 * own * u / plane;
    out[1] -= 0.25 * own / plane;
    out[2] -= 0.25 * own / axis;
  }
  return out;
}

class Motion {
 public:
  explicit Motion(const BodyInSpace& body) : body_(body) {}

  struct Acceleration {
    Vector7 of;
    double pressure;
  };

  Acceleration accelerated(const Vector14& state) const {
    const Vector3 a = state.segment<3>(0);
    const Vector3 b = state.segment<3>(3);
    const double rho = state[6];
    const Vector3 a1 = state.segment<3>(7);
    const Vector3 b1 = state.segment<3>(10);
    const double rho1 = state[13];
    const Vector3 N = a.cross(b);
    const double d = N.norm();
    const double f = rho / d;

    // dy/dX, column by column.
    Eigen::Matrix<double, 9, 7> Dy = Eigen::Matrix<double, 9, 7>::Zero();
    Dy.topLeftCorner<6, 6>().setIdentity();
    Vector7 d_slope = Vector7::Zero();
    for (int k = 0; k < 6; ++k) {
      Vector3 unit = Vector3::Zero();
      unit[k % 3] = 1.0;
      const Vector3 turned = k < 3 ? unit.cross(b) : a.cross(unit);
      d_slope[k] = N.dot(turned) / d;
      Dy.col(k).tail<3>() = f * turned - f * d_slope[k] / d * N;
    }
    Dy.col(6).tail<3>() = N / d;

    // (rho n)'' and d'' along the straight line X + t X'.
    const Vector3 N1 = a1.cross(b) + a.cross(b1);
    const Vector3 N2 = 2.0 * a1.cross(b1);
    const double d1 = N.dot(N1) / d;
    const double d2 = (N1.dot(N1) + N.dot(N2) - d1 * d1) / d;
    const double f1 = rho1 / d - rho * d1 / (d * d);
    const double f2 =
        -2.0 * rho1 * d1 / (d * d) - rho * d2 / (d * d) + 2.0 * rho * d1 * d1 / (d * d * d);
    Eigen::Matrix<double, 9, 1> curve = Eigen::Matrix<double, 9, 1>::Zero();
    curve.tail<3>() = f2 * N + 2.0 * f1 * N1 + f * N2;

    Eigen::Matrix<double, 9, 1> J;
    for (int k = 0; k < 9; ++k) J[k] = body_.J[k / 3];
    const Eigen::Matrix<double, 7, 7> M = Dy.transpose() * J.asDiagonal() * Dy;
    const Vector7 force = -slope(a, b, d, rho, d_slope) - Dy.transpose() * J.asDiagonal() * curve;
    const auto solved = M.ldlt();
    const Vector7 free = solved.solve(force);
    if (!body_.holds_volume) return {free, 0.0};
    Vector7 normal = rho * d_slope;
    normal[6] += d;
    const Vector7 pushed = solved.solve(normal);
    const double left = normal.dot(free) + rho * d2 + 2.0 * rho1 * d1;
    const double P = -left / normal.dot(pushed);
    return {free + P * pushed, P};
  }

  Vector14 after(const Vector14& start, double time) const {
    namespace odeint = boost::numeric::odeint;
    using State = std::vector<double>;
    State x(start.data(), start.data() + 14);
    const auto field = [this](const State& at, State& rate, double) {
      const Vector14 state = Eigen::Map<const Vector14>(at.data());
      const Vector7 second = accelerated(state).of;
      std::copy(at.begin() + 7, at.end(), rate.begin());
      std::copy(second.data(), second.data() + 7, rate.begin() + 7);
    };
    odeint::integrate_adaptive(
        odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<State>()), field, x,
        0.0, time, 0.05);
    return Eigen::Map<const Vector14>(x.data());
  }

  /// d after/d start: central differences at two steps, extrapolated.
  Eigen::MatrixXd tangent(const Vector14& start, double time) const {
    const auto difference = [&](int k, double h) -> Vector14 {
      Vector14 ahead = start;
      Vector14 behind = start;
      ahead[k] += h;
      behind[k] -= h;
      return (after(ahead, time) - after(behind, time)) / (2.0 * h);
    };
    Eigen::MatrixXd out(14, 14);
    for (int k = 0; k < 14; ++k)
      out.col(k) = (4.0 * difference(k, 5e-4) - difference(k, 1e-3)) / 3.0;
    return out;
  }

 private:
  /// grad V.
  Vector7 slope(const Vector3& a, const Vector3& b, double d, double rho,
                const Vector7& d_slope) const {
    const double aa = a.squaredNorm();
    const double bb = b.squaredNorm();
    const Slopes V = body_.elastic(aa + bb, d, rho);
    Vector7 out = V.of_d * d_slope;
    out.segment<3>(0) += 2.0 * V.of_trace * a;
    out.segment<3>(3) += 2.0 * V.of_trace * b;
    out[6] += V.of_rho;
    if (body_.fibre != 0.0) {  // (k/2) (|c Phi1 + s Phi2|^2 - 1)^2
      const double c = std::cos(body_.degrees * M_PI / 180.0);
      const double s = std::sin(body_.degrees * M_PI / 180.0);
      const Vector3 along = c * a + s * b;
      const Vector3 pull = 2.0 * body_.fibre * (along.squaredNorm() - 1.0) * along;
      out.segment<3>(0) += c * pull;
      out.segment<3>(3) += s * pull;
    }
    if (body_.g == 0.0) return out;
    const double* const J = body_.J;
    const auto F = pull_of_gravity(J[0] * aa + J[1] * bb, J[0] * J[1] * d * d, J[2] * rho * rho);
    out.segment<3>(0) -= body_.g * F[0] * 2.0 * J[0] * a;
    out.segment<3>(3) -= body_.g * F[0] * 2.0 * J[1] * b;
    out -= body_.g * F[1] * 2.0 * J[0] * J[1] * d * d_slope;
    out[6] -= body_.g * F[2] * 2.0 * J[2] * rho;
    return out;
  }

  BodyInSpace body_;
};

Elastic neo_hookean(double mu) {
  return [mu](double, double, double rho) { return Slopes{0.5 * mu, 0.0, mu * rho}; };
}
Elastic reciprocal(double c, double k, double a, double b) {
  return [=](double, double d, double rho) {
    return Slopes{0.5 * k, -c / (d * d), -a / (rho * rho) + b * rho};
  };
}
Elastic saint_venant_kirchhoff(double mu, double lambda, double a, double b) {
  return [=](double I1, double d, double rho) {
    return Slopes{0.5 * mu * (I1 - 1.0) + 0.25 * lambda * (I1 - 2.0), -mu * d,
                  -a / (rho * rho) + b * rho};
  };
}

/// V = mu (I1 - 2 t + 2) + (lambda/2) (t - 2)^2 with t^2 = I1 + 2 d, and of rho (slope(rho)).
Elastic biot(double mu, double lambda, const std::function<double(double)>& slope) {
  return [=](double I1, double d, double rho) {
    const double t = std::sqrt(I1 + 2.0 * d);
    const double of_t = lambda * (t - 2.0) - 2.0 * mu;
    return Slopes{mu + 0.5 * of_t / t, of_t / t, slope(rho)};
  };
}

/// (k/2)(t - t0)^2 + (b/2)(d - d0)^2 beside a thickness.
Elastic of_trace_and_area(double k, double t0, double b, double d0,
                          const std::function<double(double)>& slope) {
  return [=](double I1, double d, double rho) {
    const double t = std::sqrt(I1 + 2.0 * d);
    const double of_t = k * (t - t0);
    return Slopes{0.5 * of_t / t, of_t / t + b * (d - d0), slope(rho)};
  };
}

struct Moving {
  const char* name;
  const char* verdict;
  BodyInSpace body;
  std::string text;  ///< of the case, but for the body
  double time = 1.7;
};

std::string case_of(const Moving& moving) {
  std::string out = "[body]\nJ = [" + std::to_string(moving.body.J[0]) + ", " +
                    std::to_string(moving.body.J[1]) + ", " + std::to_string(moving.body.J[2]) +
                    "]\n";
  if (moving.body.holds_volume) out += "volume = 1\n";
  if (moving.body.g != 0.0) out += "[gravity]\ng = " + std::to_string(moving.body.g) + "\n";
  return out + moving.text;
}

std::string spin(const char* branch, const char* nu, const char* start = "") {
  std::string out = std::string("[motion]\nbranch = \"") + branch + "\"\nnu = " + nu + "\n";
  if (*start != '\0') out += std::string("[solve]\nstart = [0.0, ") + start + "]\n";
  return out;
}
std::string tilted(const char* plane, const char* nu, const char* start) {
  return std::string("[motion]\nbranch = \"tilted\"\nplane = \"") + plane + "\"\nnu = " + nu +
         "\n[solve]\nstart = [0.0, " + start + "]\n";
}
std::string out_of_plane(const char* nu, const char* start) {
  return std::string("[motion]\nbranch = \"tilted\"\nplane = \"123\"\nnu = ") + nu +
         "\n[solve]\nstart = [" + start + "]\n";
}
std::string two_polar(const char* s3, const char* p_theta, const char* start) {
  return std::string("[motion]\nbranch = \"two-polar\"\ns3 = ") + s3 + "\np_theta = " + p_theta +
         "\n[solve]\nstart = [0.0, " + start + "]\n";
}

const std::string reciprocal_text =
    "[potential]\nplane = { model = \"reciprocal-determinant\", c = 1, k = 2 }\n"
    "thickness = { model = \"reciprocal-quadratic\", a = 1, b = 3 }\n";
const std::string svk_text =
    "[potential]\nplane = { model = \"saint-venant-kirchhoff\", mu = 1.2, lambda = 0.7 }\n"
    "thickness = { model = \"reciprocal-quadratic\", a = 1, b = 3 }\n";
std::string neo_hookean_text(const char* mu) {
  return std::string("[potential]\ncoupled = { expression = \"p/2*(I1 + rho^2 - 3)\", p = ") + mu +
         " }\n";
}

std::vector<Moving> sheared_motions() {
  const BodyInSpace stiff{{1.0, 1.7, 0.6}, 0.0, true, biot(1.0, 8.0, [](double rho) {
                            return 3.0 * rho - 1.0 / (rho * rho);
                          })};
  BodyInSpace heavy = stiff;
  heavy.g = 2.0;
  const BodyInSpace fibred{{1.0, 1.7, 0.6},
                           0.0,
                           true,
                           biot(1.0, 0.6, [](double rho) { return 2.0 * (rho - 1.0); }),
                           0.4,
                           30.0};
  BodyInSpace heavy_fibred = fibred;
  heavy_fibred.g = 1.5;
  BodyInSpace free = heavy_fibred;
  free.holds_volume = false;
  free.g = 0.5;
  const std::string stiff_text =
      "[potential]\nplane = { model = \"biot\", mu = 1, lambda = 8 }\n"
      "thickness = { model = \"reciprocal-quadratic\", a = 1, b = 3 }\n";
  const std::string fibred_text =
      "[potential]\nplane = { model = \"biot\", mu = 1, lambda = 0.6 }\n"
      "thickness = { model = \"harmonic\", k = 2, rest = 1 }\n"
      "fibre = { k = 0.4, degrees = 30 }\n";
  // W_t = 0 at xi + zeta = 1.8.
  const auto heavy_biot = [](double mu, double rest) {
    return BodyInSpace{
        {1.0, 1.7, 0.6}, 2.0, false, biot(mu, 8.0 * mu, [=](double rho) { return rho - rest; })};
  };
  const BodyInSpace heavy_written{
      {1.0, 1.7, 0.6}, 2.0, true, of_trace_and_area(4.0, 2.0083, 3.0, 0.9094, [](double rho) {
        return rho - 1.3;
      })};
  const std::string written =
      "[potential]\nplane = { expression = \"2*(t - 2.0083)^2 + 1.5*(d - 0.9094)^2\" }\n"
      "thickness = { model = \"harmonic\", k = 1, rest = 1.3 }\n";
  const auto heavy_text = [](const char* mu, const char* lambda, const char* rest) {
    return std::string("[potential]\nplane = { model = \"biot\", mu = ") + mu +
           ", lambda = " + lambda +
           " }\nthickness = { model = \"harmonic\", k = 1, rest = " + rest + " }\n";
  };
  const auto heavy_motion = [](const char* branch, const char* nu, const char* start) {
    return std::string("[motion]\nbranch = \"") + branch + "\"\nnu = " + nu +
           "\n[solve]\nstart = [" + start + "]\n";
  };
  const std::string soft = heavy_text("0.3755", "3.004", "1.5321");
  const std::string stiffer = heavy_text("0.4081", "3.2648", "1.5096");
  const std::string oblique =
      "[motion]\nbranch = \"oblique\"\naxis = \"1\"\nnu = 0.4\n"
      "[solve]\nstart = [0.009, 0.935, 1.087, 0.984]\n";
  return {
      {"held body about an axis in no plane", "oscillatory", stiff,
       stiff_text + out_of_plane("2.41013162982928209566", "0.53, 1.13, 0.67, 2.1"), 0.8},
      {"heavy body about an axis in no plane", "oscillatory", heavy,
       stiff_text + out_of_plane("2.41", "0.605, 0.7735, 1.0265, 2.34"), 0.8},
      {"held body with a fibre about axis 3", "stable", fibred, fibred_text + spin("iii", "0.6")},
      {"held body with a fibre about an oblique axis", "unstable", fibred, fibred_text + oblique},
      {"heavy held body with a fibre about axis 3", "stable", heavy_fibred,
       fibred_text + spin("iii", "0.6")},
      {"heavy body with a fibre about axis 3", "stable", free, fibred_text + spin("iii", "0.6")},
      {"heavy held body about axis 3, sheared", "unstable", heavy_written,
       written + heavy_motion("iii", "0.455", "0.29, 1.17, 0.84, 1.116")},
      {"heavy body about axis 3, sheared", "unstable", heavy_biot(0.3755, 1.5321),
       soft + heavy_motion("iii", "0.5605", "0.4, 0.97, 0.83, 0.73")},
      {"heavy held body about an oblique axis", "stable", heavy_written,
       written + heavy_motion("oblique", "0.4", "0.38, 0.905, 1.103, 1.171")},
      {"heavy body about an oblique axis", "unstable", heavy_biot(0.4081, 1.5096),
       stiffer + heavy_motion("oblique", "0.450879", "0.26, 1.05, 0.75, 1")},
      {"heavy body about an axis in no plane", "oscillatory", heavy_biot(0.3755, 1.5321),
       soft + out_of_plane("0.5026", "0.26, 1.05, 0.75, 0.92")},
      {"body about an axis in no plane", "oscillatory",
       BodyInSpace{
           {1.0, 1.7, 0.6},
           0.0,
           false,
           of_trace_and_area(4.0, 2.2, 3.0, 0.9107786, [](double rho) { return rho - 1.2261429; })},
       "[potential]\nplane = { expression = \"2*(t - 2.2)^2 + 1.5*(d - 0.9107786)^2\" }\n"
       "thickness = { model = \"harmonic\", k = 1, rest = 1.2261429 }\n" +
           out_of_plane("1.0", "0.25, 1.0, 1.2, 2.177")}};
}

std::vector<Moving> motions() {
  const BodyInSpace fluid{{1.0, 1.0, 1.0}, 4.0};
  const BodyInSpace plate{{1.0, 1.7, 0.6}, 0.0, true, reciprocal(1.0, 2.0, 1.0, 3.0)};
  BodyInSpace heavy = plate;
  heavy.g = 1.0;
  heavy.holds_volume = false;
  const BodyInSpace elastic{{1.0, 1.7, 0.6}, 2.0, true, neo_hookean(1.0)};
  return {{"held plate about axis 1", "unstable", plate, reciprocal_text + spin("i", "0.5")},
          {"held plate about axis 2", "unstable",
           BodyInSpace{{1.3, 0.8, 1.1}, 0.0, true, saint_venant_kirchhoff(1.2, 0.7, 1.0, 3.0)},
           svk_text + spin("ii", "0.4")},
          {"heavy elastic plate about axis 1", "unstable", elastic,
           neo_hookean_text("1") + spin("i", "0.75", "0.741, 1.462, 0.923")},
          {"heavy compressible plate about axis 1", "unstable", heavy,
           reciprocal_text + spin("i", "0.5", "0.764, 0.816, 0.655")},
          {"spheroid about axis 1, e = 0.92", "unstable", fluid,
           spin("i", "0.6694504866551428921577702", "0.53555, 1.36647, 1.36647")},
          {"spheroid about axis 3, e = 0.98", "oscillatory", fluid,
           spin("iii", "0.614831563210100719013282", "1.71284, 1.71284, 0.34085")},
          {"irrotational ellipsoid, b/a = 0.3", "unstable", fluid,
           two_polar("1.50462433947561414308586", "0.0", "2.0534, 0.61602, 0.79055")},
          {"held body about a tilted axis", "unstable",
           BodyInSpace{{0.6, 0.9, 1.1}, 0.0, true, neo_hookean(1.0)},
           neo_hookean_text("1") + tilted("13", "0.97", "0.911, 1.63, 0.673")},
          {"heavy body about a tilted axis", "unstable",
           BodyInSpace{{1.0, 1.7, 1.3}, 2.0, true, neo_hookean(1.0)},
           neo_hookean_text("1") + tilted("13", "0.55", "1.016, 1.105, 0.8907")},
          {"held plate about axis 3", "stable", plate, reciprocal_text + spin("iii", "0.5")},
          {"heavy elastic plate about axis 3", "stable", elastic,
           neo_hookean_text("1") + spin("iii", "0.75", "0.950, 1.367, 0.770")},
          {"Jacobi's ellipsoid, b/a = 0.65", "stable", fluid,
           spin("iii", "0.5895180264839983585672417", "1.49911, 0.97442, 0.68457")},
          {"elastic Riemann ellipsoid", "stable",
           BodyInSpace{{1.0, 1.0, 1.0}, 4.0, true, neo_hookean(0.05)},
           neo_hookean_text("0.05") + two_polar("2.525315866649440390876779",
                                                "2.41135376405575751944027", "1.6, 1.1, 0.56818")}};
}

double cell(const Row& row, const char* column) {
  const auto at = row.find(column);
  return at == row.end() || at->second.empty() ? 0.0 : number(at->second);
}

/// (Phi1, Phi2, rho) and velocities of Phi = R(omega t) S R(theta_dot t) or of a turn about an axis
/// of S.
struct Steady {
  Vector14 start;
  Vector3 spin;
  double own;  ///< theta_dot
};
Steady steady_of(const Row& row) {
  const bool polar = row.at("branch") == "two-polar";
  const Vector3 axes(cell(row, polar ? "lambda" : "xi"), cell(row, polar ? "mu" : "zeta"),
                     cell(row, "rho"));
  Steady out{Vector14::Zero(), Vector3(cell(row, "nu1"), cell(row, "nu2"), cell(row, "nu3")), 0.0};
  if (polar) {
    out.spin = Vector3(0.0, 0.0, cell(row, "omega"));
    out.own = cell(row, "theta_dot");
  }
  const double alpha = polar ? 0.0 : cell(row, "alpha");
  const Vector3 a(axes[0], alpha, 0.0);
  const Vector3 b(alpha, axes[1], 0.0);
  out.start.segment<3>(0) = a;
  out.start.segment<3>(3) = b;
  out.start[6] = axes[2];
  // S R(theta) has the columns a cos + b sin, b cos - a sin.
  out.start.segment<3>(7) = out.spin.cross(a) + out.own * b;
  out.start.segment<3>(10) = out.spin.cross(b) - out.own * a;
  return out;
}

/// What a state becomes in the frames that turn with the motion.
Eigen::MatrixXd turned_back(const Steady& motion, double time) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Identity(14, 14);
  const double angle = motion.spin.norm() * time;
  const Vector3 about = motion.spin.norm() > 0.0 ? motion.spin.normalized() : Vector3::UnitZ();
  const Eigen::Matrix3d back = Eigen::AngleAxisd(-angle, about).toRotationMatrix();
  const double c = std::cos(motion.own * time);
  const double s = std::sin(motion.own * time);
  for (const int at : {0, 7}) {
    out.block<3, 3>(at, at) = c * back;
    out.block<3, 3>(at, at + 3) = -s * back;
    out.block<3, 3>(at + 3, at) = s * back;
    out.block<3, 3>(at + 3, at + 3) = c * back;
  }
  return out;
}

TEST(WholeBodyDynamics, SpectraAreThoseOfTheMotionInSpace) {
  int unstable = 0;
  int stable = 0;
  std::vector<Moving> all = motions();
  for (const Moving& each : sheared_motions()) all.push_back(each);
  for (const Moving& moving : all) {
    SCOPED_TRACE(moving.name);
    const TemporaryDirectory directory;
    const Outcome outcome =
        run_program({"solve", directory.file("case.toml", case_of(moving)), "-o", "-"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Row row = only_row(outcome.out);
    EXPECT_EQ(row.at("class"), moving.verdict);
    const Motion motion(moving.body);
    const Steady steady = steady_of(row);
    if (moving.body.holds_volume) {
      EXPECT_NEAR(motion.accelerated(steady.start).pressure, number(row.at("pressure")), 1e-12);
    }
    const double growth = number(row.at("growth"));
    const double time = moving.time;
    const Eigen::MatrixXd back = turned_back(steady, time);
    EXPECT_LE((back * motion.after(steady.start, time) - steady.start).norm(),
              1e-11 * std::exp(growth * time));

    const Eigen::VectorXcd multipliers = (back * motion.tangent(steady.start, time)).eigenvalues();
    int modes = 0;
    for (int k = 1; k <= 5; ++k) {
      const std::string n = std::to_string(k);
      if (!row.contains("re" + n) || row.at("re" + n).empty()) continue;
      const Complex s(number(row.at("re" + n)), number(row.at("im" + n)));
      if (s == 0.0) continue;  // of the material symmetry: a chain, known to half the digits
      ++modes;
      for (const Complex& each : {s, -s, std::conj(s), -std::conj(s)}) {
        const Complex expected = std::exp(each * time);
        double nearest = INFINITY;
        for (const Complex& multiplier : multipliers)
          nearest = std::min(nearest, std::abs(multiplier - expected));
        EXPECT_LE(nearest, 1e-7 * (1.0 + std::abs(expected))) << s;
      }
    }
    EXPECT_GE(modes, 2);
    // And nothing else grows, but for chains of symmetry.
    double largest = 0.0;
    for (const Complex& multiplier : multipliers) largest = std::max(largest, std::abs(multiplier));
    EXPECT_NEAR(largest / std::exp(growth * time), 1.0, growth > 0.0 ? 1e-7 : 5e-3);
    ++(growth > 0.0 ? unstable : stable);
  }
  EXPECT_GE(unstable, 5);
  EXPECT_GE(stable, 3);
}

}  // namespace
}  // namespace stationary::testing

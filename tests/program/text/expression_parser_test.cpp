// The language of expressions: what is right has the value C++ gives it, what is wrong is refused
// at its character with what was found, what is allowed and what may have been meant.
#include "solver/program/text/expression_parser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using namespace support;

const std::vector<std::string> parameters{"k", "n"};
constexpr double k = 0.7;
constexpr double n = 3.0;

/// Where the right ones are evaluated, and what their names mean there.
const Stretch q{0.2, 1.3, 0.8, 1.1};
const double alpha = q.alpha;
const double xi = q.xi;
const double zeta = q.zeta;
const double rho = q.rho;
const double t = xi + zeta;
const double d = xi * zeta - alpha * alpha;
const double I1 = xi * xi + zeta * zeta + 2.0 * alpha * alpha;
const double lambda = 0.5 * (t + std::hypot(xi - zeta, 2.0 * alpha));
const double mu = d / lambda;
constexpr double pi = 3.14159265358979323846;
constexpr double e = 2.71828182845904523536;

struct Right {
  const char* text;
  double value;
};

TEST(ExpressionParser, RightExpressionsHaveTheirValue) {
  const std::vector<Right> right{
      {"t", t},
      {"  d\n", d},
      {"rho", rho},
      {"I1", I1},
      {"((t))", t},
      {"t + d - rho", t + d - rho},
      {"t - d - rho", t - d - rho},
      {"t - (d - rho)", t - (d - rho)},
      {"t/d/rho", t / d / rho},
      {"t/(d*rho)", t / (d * rho)},
      {"t - -d", t + d},
      {"--t", t},
      {"+t", t},
      {"-t^2", -t * t},
      {"(-t)^3", -t * t * t},
      {"2*-t", -2.0 * t},
      {"2^3^2*t", 512.0 * t},
      {"(2^3)^2*t", 64.0 * t},
      {"2^-2*t", 0.25 * t},
      {"t^-2^2", 1.0 / (t * t * t * t)},
      {"t^0.5", std::sqrt(t)},
      {"t^-1.5", std::pow(t, -1.5)},
      {"t^0 + d^1", 1.0 + d},
      {"d^7", std::pow(d, 7.0)},
      {"d^n", std::pow(d, n)},
      {"n^t", std::pow(n, t)},
      {"t^d", std::pow(t, d)},
      {"pow(t, -k)", std::pow(t, -k)},
      {"(t + d)*(t - d)", (t + d) * (t - d)},
      {"exp(-(t - 2)^2)", std::exp(-(t - 2.0) * (t - 2.0))},
      {"log(d) + sqrt(1 + d*t)", std::log(d) + std::sqrt(1.0 + d * t)},
      {"sin(pi*d) - cos(e*d)", std::sin(pi * d) - std::cos(e * d)},
      {"tan(t/4) + tanh(rho)", std::tan(t / 4.0) + std::tanh(rho)},
      {"atan(rho/d)", std::atan(rho / d)},
      {"abs(-k)*t", k * t},
      {"min(k, n)*t + max(k, n)*d", k * t + n * d},
      {"1e-3*t + .5*d + 2.*rho + 1.5E+2", 1e-3 * t + 0.5 * d + 2.0 * rho + 150.0},
      {"lambda + mu_", t},
      {"lambda*mu_", d},
      {"lambda_^k + mu_^k", std::pow(lambda, k) + std::pow(mu, k)},
      {"log(lambda)^2 + log(mu_)^2",
       std::log(lambda) * std::log(lambda) + std::log(mu) * std::log(mu)},
      {"xi*zeta - alpha^2", d},
      {"xi^2 + alpha", xi * xi + alpha},
      {"k/2*(I1 - 2 - 2*log(d)) + n/2*log(d)^2",
       k / 2.0 * (I1 - 2.0 - 2.0 * std::log(d)) + n / 2.0 * std::log(d) * std::log(d)}};
  for (const Right& each : right) {
    const double actual = written_value(each.text, parameters, {k, n}, q);
    // Both sides round, each operation by 2^-53.
    EXPECT_NEAR(actual, each.value, 1e-15 * (3.0 + std::abs(each.value))) << each.text;
  }
}

struct Wrong {
  const char* text;
  std::size_t offset;
  const char* found;
  const char* allowed;
  const char* remedy;
};

constexpr const char* an_operand = R"(a number, a name, "(" or a sign)";
constexpr const char* a_name =
    "a variable (alpha, xi, zeta, rho, t, d, I1, lambda, mu_, I2, I3, pi or e) or a parameter (k "
    "or n)";
constexpr const char* a_function =
    "a function (sqrt, exp, log, sin, cos, tan, tanh, atan, abs, pow, min or max; ln is log)";
constexpr const char* more = "an operator or the end";
constexpr const char* a_number = "a number that a double can hold";

TEST(ExpressionParser, WrongExpressionsAreRefusedAtTheirCharacter) {
  const std::vector<Wrong> wrong{
      {"", 0, "the end", an_operand, ""},
      {"   ", 3, "the end", an_operand, ""},
      {"t +", 3, "the end", an_operand, ""},
      {"t + * d", 4, R"("*")", an_operand, ""},
      {"(t", 2, "the end", "an operator or \")\"", ""},
      {"t)", 1, "\")\"", more, ""},
      {"((t)", 4, "the end", "an operator or \")\"", ""},
      {"t d", 2, R"("d")", more, R"(a product is written with "*")"},
      {"2t", 1, R"("t")", more, R"(a product is written with "*")"},
      {"t**2", 2, R"("*")", an_operand, R"(a power is written with "^")"},
      {"t^^2", 2, R"("^")", an_operand, ""},
      {"*t", 0, R"("*")", an_operand, ""},
      {"t,d", 1, R"(",")", more, ""},
      {"t\n+\n)", 4, "\")\"", an_operand, ""},
      {"pow(t, d", 8, "the end", "an operator, \",\" or \")\"", ""},
      {"pow(t)", 0, "pow of 1 argument", "two arguments", ""},
      {"pow(t, d, k)", 0, "pow of 3 arguments", "two arguments", ""},
      {"sqrt(t, d)", 0, "sqrt of 2 arguments", "one argument", ""},
      {"sqrt()", 5, "\")\"", an_operand, ""},
      {"log t", 0, R"("log")", R"("(" after the name of a function)", ""},
      {"1 + lgo(d)", 4, R"("lgo(")", a_function, R"(did you mean "log"?)"},
      {"t(3)", 0, R"("t(")", a_function, R"(a product is written with "*")"},
      {"xii", 0, R"("xii")", a_name, R"(did you mean "xi"?)"},
      {"d*Lambda", 2, R"("Lambda")", a_name, R"(did you mean "lambda"?)"},
      {"mu", 0, R"("mu")", a_name, R"(did you mean "mu_"?)"},
      {"stiffness*t", 0, R"("stiffness")", a_name,
       "a parameter is given beside the expression: stiffness = 1.0"},
      {"1/0", 1, "a division by 0", "a divisor that is not 0", ""},
      {"t/(d - d)", 1, "a division by 0", "a divisor that is not 0", ""},
      {"d*0^-1", 3, "a division by 0", "a divisor that is not 0", ""},
      {"d*pow(t - t, -0.5)", 2, "a division by 0", "a divisor that is not 0", ""},
      {"t + abs(d)", 4, R"("abs" of a variable)", R"("abs" of numbers and parameters alone)",
       "abs has no second derivative where its argument is 0"},
      {"min(t, d)", 0, R"("min" of a variable)", R"("min" of numbers and parameters alone)",
       "min has no derivative where its arguments are equal"},
      {"max(k, rho)", 0, R"("max" of a variable)", R"("max" of numbers and parameters alone)",
       "max has no derivative where its arguments are equal"},
      {"lg(d)", 0, R"("lg(")", a_function, R"(did you mean "log"?)"},
      {"1e999*t", 0, R"("1e999")", a_number, ""},
      {"1e-999*t", 0, R"("1e-999")", a_number, ""},
      {"t & d", 2, R"("&")", more, ""},
      {"t = d", 2, R"("=")", more, ""},
      {"\xc3\xa9*t", 0, "\"\xc3\xa9\"", an_operand, ""},
      {"t + \x01", 4, R"("\x01")", an_operand, ""},
      {"λ + mu_", 0, R"("λ")", an_operand, "write lambda"},
      {"lambda + μ", 9, R"("μ")", an_operand, "write mu_"},
      {"\u00b5", 0, "\"\u00b5\"", an_operand, "write mu_"},
      {"2ξ", 1, R"("ξ")", more, "write xi"},
      {"ζ", 0, R"("ζ")", an_operand, "write zeta"},
      {"α^2", 0, R"("α")", an_operand, "write alpha"},
      {"1/ϱ", 2, R"("ϱ")", an_operand, "write rho"},
      {"1/ρ", 2, R"("ρ")", an_operand, "write rho"},
      {"d − 1", 2, R"("−")", more, R"(write "-")"},
      {"d²", 1, R"("²")", more, R"(write "^2")"},
      {"d³", 1, R"("³")", more, R"(write "^3")"},
      {"2·d", 1, R"("·")", more, R"(write "*")"},
      {"2×d", 1, R"("×")", more, R"(write "*")"},
      {"1.2.3*t", 3, R"(".")", more, ""},
      {"t^9999", 1, R"("^")", "whole powers up to 4096", ""},
      {"(t^3000)^3", 8, R"("^")", "whole powers up to 4096", ""}};
  for (const Wrong& each : wrong) {
    try {
      parse_expression(each.text, parameters, ExpressionSlot::coupled);
      ADD_FAILURE() << each.text << " was taken";
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.offset(), each.offset) << each.text;
      EXPECT_EQ(error.found(), each.found) << each.text;
      EXPECT_EQ(error.allowed(), each.allowed) << each.text;
      EXPECT_EQ(error.remedy(), each.remedy) << each.text;
    }
  }
}

/// A parameter has taken a name of the stretch, so that the message speaks of both.
TEST(ExpressionParser, AForeignSignMayMeanAParameter) {
  const auto remedy = [](const char* text, const std::vector<std::string>& names) {
    try {
      parse_expression(text, names, ExpressionSlot::plane);
    } catch (const ExpressionError& error) {
      return error.remedy();
    }
    return std::string();
  };
  EXPECT_EQ(remedy("μ", {"mu"}), "write mu_, or mu for the parameter");
  EXPECT_EQ(remedy("λ", {"lambda"}), "write lambda_, or lambda for the parameter");
}

TEST(ExpressionParser, ASlotKnowsItsVariables) {
  struct Stranger {
    ExpressionSlot slot;
    const char* text;
    const char* allowed;
    const char* remedy;
  };
  const Stranger strangers[] = {
      {ExpressionSlot::plane, "rho",
       "a variable (alpha, xi, zeta, t, d, I1, lambda, mu_, pi or e) or a parameter (k or n)",
       "rho does not occur in a potential of the plane; write one expression of both as `coupled`"},
      {ExpressionSlot::thickness, "mu_", "a variable (rho, pi or e) or a parameter (k or n)",
       "mu_ does not occur in a potential of the thickness; write one expression of both as "
       "`coupled`"}};
  for (const Stranger& each : strangers) {
    try {
      parse_expression(each.text, parameters, each.slot);
      ADD_FAILURE() << each.text << " was taken";
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.allowed(), each.allowed);
      EXPECT_EQ(error.remedy(), each.remedy);
    }
  }
  EXPECT_THROW(parse_expression("t*rho", parameters, ExpressionSlot::plane), ExpressionError);
  EXPECT_THROW(parse_expression("t*rho", parameters, ExpressionSlot::thickness), ExpressionError);
  EXPECT_NO_THROW(parse_expression("k*rho^2", parameters, ExpressionSlot::thickness));
  EXPECT_EQ(expression_variables(ExpressionSlot::thickness),
            (std::vector<std::string_view>{"rho", "pi", "e"}));
}

TEST(ExpressionParser, AParameterHidesAVariableAndSaysSo) {
  const std::vector<std::string> names{"mu", "lambda", "spare"};
  const auto parsed =
      parse_expression("mu*(lambda_ + mu_) + lambda*d", names, ExpressionSlot::plane);
  EXPECT_EQ(parsed.notes,
            (std::vector<std::string>{"lambda is the parameter here, not the variable (the larger "
                                      "principal stretch is lambda_)"}));
  EXPECT_EQ(parsed.unused, std::vector<std::string>{"spare"});
  EXPECT_NEAR(written_value("mu*(lambda_ + mu_) + lambda*d", names, {2.0, 3.0, 0.0}, q),
              2.0 * t + 3.0 * d, 1e-15 * 12.0);
}

TEST(ExpressionParser, AParameterHidesOnlyWhatTheSlotHas) {
  const std::vector<std::string> names{"t", "e"};
  EXPECT_EQ(parse_expression("t/rho + e", names, ExpressionSlot::thickness).notes,
            std::vector<std::string>{"e is the parameter here, not the constant"});
  EXPECT_EQ(parse_expression("t/d + e", names, ExpressionSlot::plane).notes.size(), 2U);
}

/// A hidden variable is not offered; the stretch keeps one name.
TEST(ExpressionParser, HiddenNamesAreNotOffered) {
  const std::vector<std::string> names{"lambda", "d"};
  try {
    parse_expression("nothing", names, ExpressionSlot::plane);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.allowed(),
              "a variable (alpha, xi, zeta, t, I1, lambda_, mu_, pi or e) or a parameter (lambda "
              "or d)");
  }
  const std::vector<std::string> taken{"mu_"};
  EXPECT_THROW(parse_expression("d", taken, ExpressionSlot::plane), ExpressionError);
  EXPECT_THROW(parse_expression("d", taken, ExpressionSlot::coupled), ExpressionError);
  EXPECT_NO_THROW(parse_expression("mu_*rho", taken, ExpressionSlot::thickness));
}

TEST(ExpressionParser, OneLineSaysAll) {
  try {
    parse_expression("k*lgo(d)", parameters, ExpressionSlot::plane);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(std::string(error.what()), std::string("byte 3: found \"lgo(\", allowed: ") +
                                             a_function + "; did you mean \"log\"?");
  }
}

TEST(ExpressionParser, DepthAndLengthAreBounded) {
  const auto parse = [](const std::string& text) {
    return parse_expression(text, parameters, ExpressionSlot::plane);
  };
  const std::string open(64, '(');
  const std::string close(64, ')');
  EXPECT_NO_THROW(parse(open + "t" + close));
  EXPECT_THROW(parse("(" + open + "t" + close + ")"), ExpressionError);
  EXPECT_THROW(parse(std::string(10000, '(')), ExpressionError);
  EXPECT_THROW(parse(std::string(3000, '(')), ExpressionError);
  EXPECT_NO_THROW(parse(std::string(4000, '-') + "t"));
  std::string tower = "t";
  for (int i = 0; i < 2000; ++i) tower += "^1";
  EXPECT_NO_THROW(parse(tower));
  const std::vector<std::string> many(33, "k");
  EXPECT_THROW(parse_expression("t", many, ExpressionSlot::plane), ExpressionError);
}

}  // namespace
}  // namespace stationary

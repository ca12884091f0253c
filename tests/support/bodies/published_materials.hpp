// Compressible materials from the literature as formulas of the whole body, each in several
// spellings that are one function.
#pragma once

#include <string>
#include <vector>

namespace stationary::support {

struct PublishedMaterial {
  std::string name;
  std::vector<std::string> parameters;
  std::vector<double> values;
  std::vector<std::string> spellings;
};

inline const std::vector<PublishedMaterial>& published_materials() {
  static const std::vector<PublishedMaterial> all{
      {"Gent, compressible",
       {"Jm", "k", "mu"},
       {30.0, 3.0, 1.0},
       {"-mu*Jm/2*log(1 - (I1 + rho^2 - 3)/Jm) - mu*log(d*rho) + k/2*log(d*rho)^2",
        "-mu*Jm/2*(log(Jm + 3 - I1 - rho^2) - log(Jm)) - mu*(log(d) + log(rho)) + "
        "k/2*(log(d) + log(rho))^2",
        "-mu*Jm/2*log((Jm - lambda^2 - mu_^2 - rho^2 + 3)/Jm) - mu/2*log(I3) + k/8*log(I3)^2",
        "mu*Jm/2*log(Jm/(Jm + 3 - (xi^2 + zeta^2 + 2*alpha^2 + rho^2))) + "
        "log(rho*(xi*zeta - alpha^2))*(k/2*log(rho*(xi*zeta - alpha^2)) - mu)",
        "-mu*(Jm/2)*log(1 - (t^2 - 2*d + rho^2 - 3)/Jm) - mu*log(d*rho)*(1 - "
        "k/(2*mu)*log(d*rho))"}},
      {"Blatz-Ko, solid rubber",
       {"b", "mu"},
       {0.8, 1.0},
       {"mu/2*(I1 + rho^2 - 3 + ((d*rho)^(-2*b) - 1)/b)",
        "mu/2*(I1 + rho^2 - 3) + mu/(2*b)*(I3^(-b) - 1)",
        "mu/2*(lambda^2 + mu_^2 + rho^2 - 3 + (exp(-2*b*log(d*rho)) - 1)/b)",
        "mu/2*(t^2 - 2*d + rho^2) + mu/(2*b)*d^(-2*b)/rho^(2*b) - mu*(3/2 + 1/(2*b))"}},
      {"Blatz-Ko, foam",
       {"mu"},
       {1.0},
       {"mu/2*((d^2 + rho^2*I1)/(d*rho)^2 + 2*d*rho - 5)", "mu/2*(I1/d^2 + 1/rho^2 + 2*d*rho - 5)",
        "mu/2*(I2/I3 + 2*sqrt(I3) - 5)",
        "mu/2*(lambda^-2 + mu_^-2 + rho^-2 + 2*lambda*mu_*rho - 5)",
        "mu*(((t^2 - 2*d)*rho^2 + d^2)/(2*d^2*rho^2) + d*rho) - 5*mu/2"}},
      {"Ciarlet-Geymonat",
       {"a", "b", "c"},
       {0.4, 0.1, 0.3},
       {"a*(I1 + rho^2 - 3) + b*(d^2 + rho^2*I1 - 3) + c*((d*rho)^2 - 1) - "
        "(a + 2*b + c)*log((d*rho)^2)",
        "a*(I1 + rho^2) + b*I2 + c*I3 - (a + 2*b + c)*log(I3) - 3*a - 3*b - c",
        "a*(lambda^2 + mu_^2 + rho^2 - 3) + b*(lambda^2*mu_^2 + rho^2*(lambda^2 + mu_^2) - 3) + "
        "c*(lambda^2*mu_^2*rho^2 - 1) - 2*(a + 2*b + c)*(log(lambda*mu_) + log(rho))",
        "a*(t^2 - 2*d + rho^2) + d^2*(b + c*rho^2) + b*rho^2*(t^2 - 2*d) - 2*(a + c)*log(d*rho) - "
        "4*b*log(d*rho)"}},
      {"Yeoh",
       {"c1", "c2", "c3", "k"},
       {0.5, -0.02, 0.003, 4.0},
       {"c1*((I1 + rho^2)*(d*rho)^(-2/3) - 3) + c2*((I1 + rho^2)*(d*rho)^(-2/3) - 3)^2 + "
        "c3*((I1 + rho^2)*(d*rho)^(-2/3) - 3)^3 + k/2*(d*rho - 1)^2",
        "((I1 + rho^2)/I3^(1/3) - 3)*(c1 + ((I1 + rho^2)/I3^(1/3) - 3)*(c2 + "
        "c3*((I1 + rho^2)/I3^(1/3) - 3))) + k/2*(sqrt(I3) - 1)^2",
        "c1*(exp(-2/3*log(d*rho))*(lambda^2 + mu_^2 + rho^2) - 3) + "
        "c2*(3 - exp(-2/3*log(d*rho))*(lambda^2 + mu_^2 + rho^2))^2 - "
        "c3*(3 - exp(-2/3*log(d*rho))*(lambda^2 + mu_^2 + rho^2))^3 + k/2*(1 - d*rho)^2",
        "c1*((t^2 - 2*d + rho^2)/(d*rho)^(2/3) - 3) + c2*((t^2 - 2*d + rho^2)/(d*rho)^(2/3) - 3)^2 "
        "+ c3*((t^2 - 2*d + rho^2)/(d*rho)^(2/3) - 3)^3 + k/2*((d*rho)^2 - 2*d*rho + 1)"}},
      {"Arruda-Boyce",
       {"N", "k", "mu"},
       {8.0, 5.0, 1.0},
       {"mu*(((I1 + rho^2)*(d*rho)^(-2/3) - 3)/2 + (((I1 + rho^2)*(d*rho)^(-2/3))^2 - 9)/(20*N) + "
        "11*(((I1 + rho^2)*(d*rho)^(-2/3))^3 - 27)/(1050*N^2) + "
        "19*(((I1 + rho^2)*(d*rho)^(-2/3))^4 - 81)/(7000*N^3) + "
        "519*(((I1 + rho^2)*(d*rho)^(-2/3))^5 - 243)/(673750*N^4)) + "
        "k/2*(((d*rho)^2 - 1)/2 - log(d*rho))",
        "mu*((I1 + rho^2)/I3^(1/3)/2 + (I1 + rho^2)^2/I3^(2/3)/(20*N) + "
        "11/1050*(I1 + rho^2)^3/I3/N^2 + 19/7000*(I1 + rho^2)^4/I3^(4/3)/N^3 + "
        "519/673750*(I1 + rho^2)^5/I3^(5/3)/N^4) + k/4*(I3 - 1 - log(I3))",
        "mu*(lambda^2 + mu_^2 + rho^2)*(d*rho)^(-2/3)*(1/2 + "
        "(lambda^2 + mu_^2 + rho^2)*(d*rho)^(-2/3)*(1/(20*N) + "
        "(lambda^2 + mu_^2 + rho^2)*(d*rho)^(-2/3)*(11/(1050*N^2) + "
        "(lambda^2 + mu_^2 + rho^2)*(d*rho)^(-2/3)*(19/(7000*N^3) + "
        "(lambda^2 + mu_^2 + rho^2)*(d*rho)^(-2/3)*519/(673750*N^4))))) + "
        "k/2*((d*rho)^2/2 - log(d) - log(rho))",
        "mu/2*((t^2 - 2*d + rho^2)*exp(-2/3*log(d*rho)) + "
        "((t^2 - 2*d + rho^2)*exp(-2/3*log(d*rho)))^2/(10*N) + "
        "11*((t^2 - 2*d + rho^2)*exp(-2/3*log(d*rho)))^3/(525*N^2) + "
        "19*((t^2 - 2*d + rho^2)*exp(-2/3*log(d*rho)))^4/(3500*N^3) + "
        "519*((t^2 - 2*d + rho^2)*exp(-2/3*log(d*rho)))^5/(336875*N^4)) + "
        "k/4*((d*rho)^2 - 2*log(d*rho))"}},
      {"Fung",
       {"b", "c", "k"},
       {0.7, 1.0, 3.0},
       {"c/(2*b)*(exp(b*(I1 + rho^2 - 3)) - 1) - c*log(d*rho) + k/2*log(d*rho)^2",
        "c/(2*b)*exp(b*I1)*exp(b*rho^2)*exp(-3*b) - log(d*rho)*(c - k/2*log(d*rho))",
        "c/(2*b)*(exp(b*(lambda^2 + mu_^2 + rho^2 - 3)) - 1) - c/2*log(I3) + k/8*log(I3)^2",
        "c/b/2*(exp(b*((t^2 - 2*d) + rho^2 - 3)) - 1) - c*(log(d) + log(rho)) + "
        "k/2*(log(d) + log(rho))^2"}},
      {"Ogden",
       {"k", "m1", "m2", "p1", "p2"},
       {3.0, 0.6, -0.1, 1.3, -2.2},
       {"m1/p1*(lambda^p1 + mu_^p1 + rho^p1 - 3) + m2/p2*(lambda^p2 + mu_^p2 + rho^p2 - 3) - "
        "(m1 + m2)*log(d*rho) + k/2*log(d*rho)^2",
        "m1*(lambda^p1 + mu_^p1 + rho^p1)/p1 + m2*(lambda^p2 + mu_^p2 + rho^p2)/p2 - "
        "(m1 + m2)/2*log(I3) + k/8*log(I3)^2",
        "m1/p1*(exp(p1*log(lambda)) + exp(p1*log(mu_)) + exp(p1*log(rho))) + "
        "m2/p2*(exp(p2*log(lambda)) + exp(p2*log(mu_)) + exp(p2*log(rho))) - "
        "(m1 + m2)*log(lambda*mu_*rho) + k/2*log(lambda*mu_*rho)^2",
        "m1/p1*(lambda^p1 + lambda^(-p1)*d^p1 + rho^p1) + "
        "m2/p2*(d^p2/mu_^p2 + mu_^p2 + rho^p2) - (m1 + m2)*(log(d) + log(rho)) + "
        "k/2*(log(d) + log(rho))^2"}},
      {"Mooney-Rivlin, compressible",
       {"c1", "c2", "k"},
       {0.4, 0.1, 2.0},
       {"c1*(I1 + rho^2 - 3) + c2*(d^2 + rho^2*I1 - 3) - 2*(c1 + 2*c2)*log(d*rho) + "
        "k/2*(d*rho - 1)^2",
        "c1*(I1 + rho^2) + c2*I2 - (c1 + 2*c2)*log(I3) + k/2*(sqrt(I3) - 1)^2",
        "c1*(lambda^2 + mu_^2 + rho^2) + c2*(lambda^2*mu_^2 + mu_^2*rho^2 + rho^2*lambda^2) - "
        "2*(c1 + 2*c2)*(log(lambda*mu_) + log(rho)) + k/2*(1 - d*rho)^2",
        "c1*(t^2 - 2*d + rho^2) + c2*(d^2 + rho^2*(t^2 - 2*d)) - 2*c1*log(d*rho) - "
        "4*c2*log(d*rho) + k/2*((d*rho)^2 - 2*d*rho)"}},
      {"Simo-Pister",
       {"lame", "mu"},
       {2.0, 1.0},
       {"mu/2*(I1 + rho^2 - 3) - mu*log(d*rho) + lame/2*log(d*rho)^2",
        "mu/2*(I1 + rho^2 - log(I3)) + lame/8*log(I3)^2",
        "mu/2*(lambda^2 + mu_^2 + rho^2 - 3) + "
        "(log(lambda*mu_) + log(rho))*(lame/2*log(lambda*mu_*rho) - mu)",
        "mu/2*(t^2 - 2*d + rho^2 - 3 - 2*log(d*rho)) + lame/2*(log(d) + log(rho))*log(d*rho)"}},
      {"Saint Venant-Kirchhoff",
       {"lame", "mu"},
       {2.0, 1.0},
       {"mu/4*(I1^2 - 2*d^2 - 2*I1 + 2 + (rho^2 - 1)^2) + lame/8*(I1 + rho^2 - 3)^2",
        "mu/4*((lambda^2 - 1)^2 + (mu_^2 - 1)^2 + (rho^2 - 1)^2) + "
        "lame/8*(lambda^2 + mu_^2 + rho^2 - 3)^2",
        "mu/4*((I1 + rho^2)^2 - 2*I2 - 2*(I1 + rho^2) + 3) + lame/8*((I1 + rho^2) - 3)^2",
        "mu/4*((t^2 - 2*d)^2 - 2*d^2 - 2*(t^2 - 2*d) + rho^4 - 2*rho^2) + "
        "lame/8*(t^2 - 2*d + rho^2)^2 - 3*lame/4*(t^2 - 2*d + rho^2)"}},
      {"Hencky",
       {"lame", "mu"},
       {1.2, 1.0},
       {"mu*(log(lambda)^2 + log(mu_)^2 + log(rho)^2) + lame/2*log(d*rho)^2",
        "mu*(log(lambda)^2 + log(mu_)^2 + log(rho)^2) + lame/8*log(I3)^2",
        "mu/4*(log(lambda^2)^2 + log(mu_^2)^2 + log(rho^2)^2) + "
        "lame/2*(log(lambda) + log(mu_) + log(rho))^2",
        "mu*(log(d)^2 - 2*log(lambda)*log(mu_) + log(rho)^2) + "
        "lame/2*(log(d)^2 + 2*log(d)*log(rho) + log(rho)^2)"}}};
  return all;
}

}  // namespace stationary::support

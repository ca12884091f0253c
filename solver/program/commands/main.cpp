// stationary: stationary ellipsoids of an affinely-rigid body, from a case file.
#include "solver/program/commands/program.hpp"

int main(int argc, char** argv) {
  using namespace stationary::cli;
  return run_program({"stationary", "Stationary ellipsoids of an affinely-rigid body",
                      [](CLI::App& program, Session& session) {
                        add_solve(program, session);
                        add_continue(program, session);
                        add_atlas(program, session);
                        add_map(program, session);
                        add_curve(program, session);
                        add_sensitivity(program, session);
                        add_study(program, session);
                        add_check(program, session);
                        add_models(program, session);
                        add_plot(program, session);
                        add_explore(program, session);
                      },
                      nullptr},
                     argc, argv);
}

// What most rooms of the solver and the program begin with, for a build of WebAssembly from nothing.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/kind/kind.hpp"
#include "solver/motion/family.hpp"
#include "solver/program/case/case_file.hpp"

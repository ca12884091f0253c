// What every table's metadata say of the run that made it.
#pragma once

#include "solver/program/rows/metadata.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

/// input: the case; null where it is none by itself (Metadata::source).
inline Metadata metadata_of(const Run& run, const Case* input) {
  Metadata out;
  out.version = STATIONARY_VERSION;
  out.command_line = run.command_line;
  out.threads = run.threads;
  out.input = input;
  return out;
}

}  // namespace stationary::cli

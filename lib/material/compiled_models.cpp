// The evaluations that every solver, search and proof comes by, compiled once.
#include "lib/material/anisotropic_potential.hpp"
#include "lib/material/gravitating/body_terms.hpp"
#include "lib/material/gravitating/elastic_part.hpp"
#include "lib/material/models/any_model.hpp"

namespace stationary {

STATIONARY_COMPILED_KINDS(template)
STATIONARY_COMPILED_TERMS(template)
STATIONARY_COMPILED_PARTS(template)
STATIONARY_COMPILED_MODELS(template)

}  // namespace stationary

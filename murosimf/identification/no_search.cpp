// Replaces the search where NLopt is missing.
#include "murosimf/identification/search.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {

void check_search() {
  throw SetupError("fits are off in this build: NLopt was missing (Debian and Ubuntu: libnlopt-dev)");
}

Found search(const Objective& /*objective*/, const SearchOptions& /*options*/, const Progress& /*progress*/) {
  check_search();
  return {};
}

Found refine(const Found& /*found*/, const Objective& /*objective*/, int /*evaluations*/,
             const std::function<bool()>& /*stop*/) {
  check_search();
  return {};
}

}  // namespace murosimf::identification

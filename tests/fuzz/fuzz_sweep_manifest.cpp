// Experiments in shards: what runs there are.
#include "murosimf/studies/sweep_manifest.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".json", [](const auto& file) {
    const studies::SweepManifest manifest = studies::read_manifest(file);
    const studies::Sweep nothing = studies::merged(manifest);
    if (nothing.runs.empty() || studies::missing_runs(nothing) != nothing.runs.size()) std::abort();
    if (studies::to_csv(nothing).empty()) std::abort();
  });
  return 0;
}

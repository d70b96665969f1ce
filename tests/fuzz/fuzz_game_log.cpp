// Records of what came from outside in a run.
#include "murosimf/league/game_log.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".gamelog", [](const auto& file) {
    const std::string text = league::GameLog::read(file).to_text();
    if (league::GameLog::parse(text, "again").to_text() != text) std::abort();
  });
  return 0;
}

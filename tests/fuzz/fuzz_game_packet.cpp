// Packets of a GameController, from anywhere in a network.
#include "murosimf/league/game_packet.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  try {
    const league::GameState game = league::read_game_packet({reinterpret_cast<const char*>(data), size});
    if (size < 118 || game.state > 4 || game.secondary_state > 9) std::abort();
  } catch (const SetupError& error) {
    if (*error.what() == '\0') std::abort();
  }
  return 0;
}

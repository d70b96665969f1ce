#include "murosimf/viewer/input.h"

#include <chrono>
#include <set>
#include <string>

namespace murosimf::viewer {
namespace {

/// Events already assigned to a picture.
struct Given {
  std::set<std::string> keys;
  std::set<int> buttons;
  bool moved = false, turned = false;

  [[nodiscard]] bool takes(const Input& input) {
    if (const auto* key = std::get_if<KeyInput>(&input)) return key->again || keys.insert(key->chord.key).second;
    if (const auto* button = std::get_if<ButtonInput>(&input)) {
      if (turned || (moved && button->pressed)) return false;
      return buttons.insert(button->button).second;
    }
    if (std::holds_alternative<MoveInput>(input)) return buttons.empty() && !turned && (moved = true);
    if (std::holds_alternative<WheelInput>(input)) return buttons.empty() && (turned = true);
    return keys.empty();
  }
};

}  // namespace

double input_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Not all at once: a frame takes each key and button once, so that a quick press and release are both seen.
std::vector<Input> InputQueue::next() {
  Given given;
  std::vector<Input> inputs;
  while (!inputs_.empty() && given.takes(inputs_.front())) {
    inputs.push_back(std::move(inputs_.front()));
    inputs_.pop_front();
  }
  return inputs;
}

}  // namespace murosimf::viewer

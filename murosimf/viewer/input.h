/// input.h - keys and mouse of a window as events, and the queue that distributes them to pictures.
#pragma once

#include <deque>
#include <variant>
#include <vector>

#include "murosimf/viewer/key_map.h"
#include "murosimf/viewer/orbit_camera.h"

namespace murosimf::viewer {

struct KeyInput {
  KeyChord chord;
  bool pressed = false, again = false;  ///< again: it is held, and repeats
};
struct ButtonInput {
  int button = 0;  ///< 0 left, 1 right, 2 middle
  bool pressed = false;
  double time = 0;  ///< [s] by input_clock(), time of arrival
};
struct MoveInput {
  Pixel place;  ///< of the window
};
struct WheelInput {
  double clicks = 0;
};
struct TextInput {
  unsigned int letter = 0;  ///< Unicode
};
using Input = std::variant<KeyInput, ButtonInput, MoveInput, WheelInput, TextInput>;

/// [s] of ButtonInput::time
[[nodiscard]] double input_clock();

/// Events in their order, distributed over pictures.
///
/// Panels read the state of keys and buttons once per picture. Events that would be lost this way wait for the next picture: a key or a
/// button that changes twice, a pointer that moves after a button has changed, a button that is pressed where the pointer has just arrived
/// (items under it are known after a picture only), letters after a key. So a click of any length counts, however long a picture takes.
class InputQueue {
 public:
  void add(const std::vector<Input>& inputs) { inputs_.insert(inputs_.end(), inputs.begin(), inputs.end()); }
  /// Events of the next picture.
  [[nodiscard]] std::vector<Input> next();
  [[nodiscard]] bool empty() const { return inputs_.empty(); }

 private:
  std::deque<Input> inputs_;
};

}  // namespace murosimf::viewer

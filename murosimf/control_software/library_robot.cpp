#include "murosimf/control_software/library_robot.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {

LibraryRobot::LibraryRobot(const Setup& setup, RobotPort& port, SayLine say, OptionValues options, std::uint64_t seed)
    : port_(&port),
      say_(std::move(say)),
      options_(std::move(options)),
      name_(setup.entity().name()),
      team_(setup.entity().options().team),
      model_(setup.model().name()) {
  robot_.simulator = this;
  robot_.name = name_.c_str();
  robot_.team = team_.c_str();
  robot_.model = model_.c_str();
  robot_.period = seconds(setup.period());
  robot_.seed = seed;
  robot_.signal = signal;
  robot_.command = command;
  robot_.label = label;
  robot_.number_option = number_option;
  robot_.truth_option = truth_option;
  robot_.vector_option = vector_option;
  robot_.text_option = text_option;
  robot_.say = LibraryRobot::say;
  robot_.use_messages = use_messages;
  robot_.send = send;
  robot_.receive = receive;
  robot_.picture = picture;
  robot_.draw = draw;
}

/// After creation: only then it is known which options the software asks for.
void LibraryRobot::check_options(const std::string& owner) const {
  const std::vector<std::string_view> known(asked_.begin(), asked_.end());
  if (!wrong_option_.empty()) throw SetupError(fmt::format("{}: {}", owner, wrong_option_));
  for (const auto& [name, value] : options_) {
    if (asked_.contains(name)) continue;
    if (known.empty()) throw SetupError(fmt::format("{} has no options, so '{}' cannot be set", owner, name));
    throw SetupError(unknown_name(fmt::format("option of {},", owner), name, known));
  }
}

/// Returns the result of look(); null if it throws, and keeps the reason.
template <class Look>
auto* LibraryRobot::found(const Look& look) noexcept {
  decltype(look()) result = nullptr;
  try {
    result = look();
  } catch (const SetupError& error) {
    not_found_ = error.what();
  }
  return result;
}

const murosimf_signal* LibraryRobot::signal(const murosimf_robot* robot, const char* name) noexcept {
  return of(robot).found([&] { return of(robot).port_->signal(name); });
}

murosimf_command* LibraryRobot::command(const murosimf_robot* robot, const char* name) noexcept {
  return of(robot).found([&] { return of(robot).port_->command(name); });
}

const char* LibraryRobot::label(const murosimf_robot* robot, const char* name, std::size_t i) noexcept {
  const std::vector<std::string>* labels = of(robot).port_->labels(name);
  return labels && i < labels->size() ? (*labels)[i].c_str() : nullptr;
}

/// The first wrong option is kept: software cannot be told by an exception.
template <class T>
const T* LibraryRobot::option(const char* name) {
  asked_.insert(name);
  const auto found = options_.find(name);
  if (found == options_.end()) return nullptr;
  const T* value = std::get_if<T>(&found->second);
  if (!value && wrong_option_.empty()) {
    wrong_option_ = fmt::format("the option '{}' is a {}; it must be a {}", name, type_name(found->second),
                                type_name(OptionValue(T{})));
  }
  return value;
}

int LibraryRobot::number_option(const murosimf_robot* robot, const char* name, double* value) noexcept {
  const double* given = of(robot).option<double>(name);
  if (given) *value = *given;
  return given ? 1 : 0;
}

int LibraryRobot::truth_option(const murosimf_robot* robot, const char* name, int* value) noexcept {
  const bool* given = of(robot).option<bool>(name);
  if (given) *value = *given ? 1 : 0;
  return given ? 1 : 0;
}

int LibraryRobot::vector_option(const murosimf_robot* robot, const char* name, double value[3]) noexcept {
  const Vec3d* given = of(robot).option<Vec3d>(name);
  if (!given) return 0;
  value[0] = given->x;
  value[1] = given->y;
  value[2] = given->z;
  return 1;
}

const char* LibraryRobot::text_option(const murosimf_robot* robot, const char* name) noexcept {
  const std::string* given = of(robot).option<std::string>(name);
  return given ? given->c_str() : nullptr;
}

void LibraryRobot::say(const murosimf_robot* robot, const char* text) noexcept {
  if (text) of(robot).say_(text);
}

int LibraryRobot::use_messages(const murosimf_robot* robot) noexcept {
  const auto open = [&]() -> TeamRadio* {
    of(robot).port_->radio().open();
    return &of(robot).port_->radio();
  };
  return of(robot).found(open) ? 1 : 0;
}

int LibraryRobot::send(const murosimf_robot* robot, const void* bytes, std::size_t size) noexcept {
  const std::string_view text(size > 0 ? static_cast<const char*>(bytes) : "", size);
  return of(robot).port_->radio().send(text) ? 1 : 0;
}

const murosimf_picture* LibraryRobot::picture(const murosimf_robot* robot, const char* name) noexcept {
  return of(robot).found([&] { return of(robot).port_->picture(name); });
}

int LibraryRobot::draw(const murosimf_robot* robot, const char* group, int of_robot, const murosimf_shape* shapes,
                       std::size_t count) noexcept {
  DrawnGroup drawn{.name = group ? group : "", .of_robot = of_robot != 0};
  for (std::size_t i = 0; i < std::min(count, drawing::SketchPad::most_shapes + 1); ++i) {
    const murosimf_shape& shape = shapes[i];
    DrawnShape& one = drawn.shapes.emplace_back();
    one.kind = static_cast<DrawnShape::Kind>(shape.kind);
    for (std::size_t k = 0; k < std::min(shape.count, drawing::SketchPad::most_points + 1); ++k) {
      one.points.push_back({shape.points[3 * k], shape.points[3 * k + 1], shape.points[3 * k + 2]});
    }
    one.size = shape.size;
    one.color = {shape.color[0], shape.color[1], shape.color[2]};
    one.opacity = shape.opacity;
    if (shape.text) one.words = shape.text;
  }
  return of(robot).port_->draw(std::move(drawn)) ? 1 : 0;
}

/// Copies the bytes into a read-only row. The row grows by doubling, so that its number of mappings stays logarithmic.
const std::byte* LibraryRobot::shown(const std::string& bytes) {
  if (!message_ || bytes.size() > room_) {
    room_ = std::max({bytes.size(), 2 * room_, std::size_t{1500}});
    message_ = &port_->rows().add("message", fmt::format("{} bytes", room_), 0, room_, GuardedRow::Use::read);
  }
  std::ranges::copy(std::as_bytes(std::span(bytes)), message_->body<std::byte>());
  return message_->shown_body<const std::byte>();
}

int LibraryRobot::receive(const murosimf_robot* robot, murosimf_message* message) noexcept {
  const TeamMessage* received = of(robot).port_->radio().receive();
  if (!received) return 0;
  *message = {of(robot).shown(received->bytes), received->bytes.size(), received->sender.c_str(),
              received->sent.count()};
  return 1;
}

}  // namespace murosimf::control_software

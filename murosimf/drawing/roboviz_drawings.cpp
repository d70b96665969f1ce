#include "murosimf/drawing/roboviz_drawings.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::drawing {
namespace {

constexpr double meters_per_pixel = 0.004;
constexpr double text_height = 0.12;  // [m]
constexpr std::size_t longest_name = 255;
constexpr double farthest = 1e4;  // [m]

struct Damaged : std::runtime_error {
  Damaged() : std::runtime_error("damaged") {}
};

}  // namespace

class RobovizDrawings::Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  [[nodiscard]] bool any() const { return !left_.empty(); }

  int byte() { return static_cast<unsigned char>(bytes(1)[0]); }
  double number() {
    std::string_view text = bytes(6);
    // Numbers are padded by blanks, zeros and plus signs, differently by different agents.
    while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.remove_suffix(1);
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc{} || end.ptr != text.data() + text.size()) throw Damaged();
    if (!std::isfinite(value) || std::abs(value) > farthest) throw Damaged();
    return value;
  }
  Vec3d point() {
    // Not in one initializer with y: numbers must be read in the order of the packet.
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Color color() {
    const double red = byte() / 255.0, green = byte() / 255.0;
    return {red, green, byte() / 255.0};
  }
  std::string text() {
    const std::size_t end = left_.find('\0');
    if (end == std::string_view::npos || end > longest_name) throw Damaged();
    std::string found;
    for (const char c : left_.substr(0, end)) {  // other bytes than printable ASCII might be no valid text
      found += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? '?' : c;
    }
    left_.remove_prefix(end + 1);
    return found;
  }

 private:
  std::string_view bytes(std::size_t count) {
    if (left_.size() < count) throw Damaged();
    const std::string_view found = left_.substr(0, count);
    left_.remove_prefix(count);
    return found;
  }

  std::string_view left_;
};

bool RobovizDrawings::take(std::string_view packet) {
  try {
    Reader in(packet);
    if (!in.any()) return false;
    all_had_place_ = true;
    while (in.any()) read_command(in);
    return all_had_place_;
  } catch (const Damaged&) {
    return false;
  }
}

void RobovizDrawings::read_command(Reader& in) {
  switch (in.byte()) {
    case 0:
      if (in.byte() != 0) throw Damaged();
      return swap(in.text());
    case 1: return read_shape(in);
    case 2: return read_text(in);
    case 3: (void)in.byte(); return;
    default: throw Damaged();
  }
}

void RobovizDrawings::read_shape(Reader& in) {
  DrawnShape shape;
  switch (in.byte()) {
    case 0: {
      const double x = in.number();
      shape = {.kind = DrawnShape::circle, .points = {{x, in.number(), 0.005}}, .size = in.number()};
      (void)in.number();  // thickness: circles have the least visible one
      break;
    }
    case 1: {
      const Vec3d from = in.point();
      shape = {.kind = DrawnShape::line, .points = {from, in.point()}, .size = meters_per_pixel * in.number()};
      break;
    }
    case 2:
      shape = {.kind = DrawnShape::dots, .points = {in.point()}};
      shape.size = meters_per_pixel * in.number();
      break;
    case 3:
      shape = {.kind = DrawnShape::sphere, .points = {in.point()}};
      shape.size = in.number();
      break;
    case 4: {
      shape.kind = DrawnShape::polygon;
      const int corners = in.byte();
      shape.color = in.color();
      shape.opacity = in.byte() / 255.0;
      if (corners < 3) throw Damaged();
      for (int i = 0; i < corners; ++i) shape.points.push_back(in.point());
      return add(in.text(), std::move(shape));
    }
    default: throw Damaged();
  }
  if (shape.size < 0) throw Damaged();
  shape.color = in.color();
  add(in.text(), std::move(shape));
}

void RobovizDrawings::read_text(Reader& in) {
  switch (in.byte()) {
    case 0: {
      DrawnShape shape{.kind = DrawnShape::text, .points = {in.point()}, .size = text_height};
      shape.color = in.color();
      shape.words = in.text();
      return add(in.text(), std::move(shape));
    }
    case 1: {
      const int agent = in.byte();
      MUROSIMF_ASSERT(agent >= 0 && agent < 256);
      const Color color = in.color();
      notes_[agent] = {.team = agent / 128, .number = agent % 128, .color = color, .text = in.text()};
      ++changes_;
      return;
    }
    case 2: changes_ += notes_.erase(in.byte()); return;
    default: throw Damaged();
  }
}

bool RobovizDrawings::has_place(const std::string& set, const DrawnShape& shape) const {
  const std::size_t more = shape.points.size();
  if (points_ + more > most_in_all) return false;
  const auto known = sets_.find(set);
  if (known == sets_.end()) return sets_.size() < most_sets;
  return known->second.drawn.size() < most_shapes && known->second.points + more <= most_points;
}

/// Adds a shape. One beyond the limits is dropped; a later swap may make room again.
void RobovizDrawings::add(const std::string& set, DrawnShape shape) {
  if (!has_place(set, shape)) {
    all_had_place_ = false;
    return;
  }
  Set& into = sets_[set];
  into.points += shape.points.size();
  points_ += shape.points.size();
  into.drawn.push_back(std::move(shape));
  MUROSIMF_ASSERT(points_ <= most_in_all);
}

void RobovizDrawings::swap(const std::string& begin) {
  for (auto set = sets_.lower_bound(begin); set != sets_.end() && set->first.starts_with(begin);) {
    // All sets with names that begin so: an agent may swap its sets one by one or at once.
    if (set->second.shown.empty() && set->second.drawn.empty()) {
      set = sets_.erase(set);  // unused between two swaps
      continue;
    }
    set->second.shown = std::exchange(set->second.drawn, {});
    MUROSIMF_ASSERT(points_ >= set->second.shown_points);
    points_ -= set->second.shown_points;
    set->second.shown_points = std::exchange(set->second.points, 0);
    ++changes_;
    ++set;
  }
}

ExternalDrawings RobovizDrawings::shown() const {
  ExternalDrawings all{.groups = {}, .notes = {}, .changes = changes_};
  for (const auto& [name, set] : sets_) {
    if (!set.shown.empty()) all.groups.push_back({.name = name, .shapes = set.shown});
  }
  for (const auto& [agent, note] : notes_) all.notes.push_back(note);
  return all;
}

}  // namespace murosimf::drawing

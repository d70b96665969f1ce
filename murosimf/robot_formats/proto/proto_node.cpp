#include "murosimf/robot_formats/proto/proto_node.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::proto {
namespace {

/// The field if it has a value; null otherwise. Throws SetupError unless it has `count` numbers.
const Field* numbers_of(const Node& node, std::string_view name, std::size_t count) {
  const Field* field = node.find(name);
  if (!field || field->empty()) return nullptr;
  if (field->numbers.size() == count && field->texts.empty() && field->nodes.empty()) return field;
  node.fail(fmt::format("{} of {} has {} numbers; write {}", name, node.type, field->numbers.size(), count), field);
}

Mat3d rotation_of(const Node& node) {
  const Field* field = numbers_of(node, "rotation", 4);
  if (!field) return {};
  const Vec3d axis{field->numbers[0], field->numbers[1], field->numbers[2]};
  const double angle = field->numbers[3], length = norm(axis);
  if (angle == 0) return {};  // files often have an axis of zeros with it
  if (!(length > 1e-9))
    node.fail(fmt::format("the axis of rotation of {} has no direction; write one", node.type), field);
  return rotation((1.0 / length) * axis, angle);
}

}  // namespace

const Field* Node::find(std::string_view name) const {
  const auto found = std::ranges::find(fields, name, &Field::name);
  return found == fields.end() ? nullptr : &*found;
}

const std::vector<NodePtr>& Node::children(std::string_view name) const {
  static const std::vector<NodePtr> none;
  const Field* field = find(name);
  return field ? field->nodes : none;
}

NodePtr Node::child(std::string_view name) const {
  const auto& all = children(name);
  return all.empty() ? nullptr : all[0];
}

double Node::number(std::string_view name, double fallback) const {
  const Field* field = numbers_of(*this, name, 1);
  return field ? field->numbers[0] : fallback;
}

double Node::positive(std::string_view name, double fallback) const {
  const double value = number(name, fallback);
  if (!(value > 0)) fail(fmt::format("{} of {} is {}; it must be more than 0", name, type, value), find(name));
  return value;
}

double Node::at_least_zero(std::string_view name, double fallback) const {
  const double value = number(name, fallback);
  if (value < 0) fail(fmt::format("{} of {} is {}; it must be at least 0", name, type, value), find(name));
  return value;
}

Vec3d Node::vector(std::string_view name, const Vec3d& fallback) const {
  const Field* field = numbers_of(*this, name, 3);
  return field ? Vec3d{field->numbers[0], field->numbers[1], field->numbers[2]} : fallback;
}

std::string Node::text(std::string_view name, const std::string& fallback) const {
  const Field* field = find(name);
  if (!field || field->empty()) return fallback;
  if (field->texts.size() != 1) fail(fmt::format("{} of {} is no string; write it in quotes", name, type), field);
  return field->texts[0];
}

bool Node::flag(std::string_view name, bool fallback) const {
  const Field* field = find(name);
  if (!field || field->empty()) return fallback;
  if (field->word.empty()) fail(fmt::format("{} of {} is neither TRUE nor FALSE", name, type), field);
  return field->word == "TRUE";
}

Transformd Node::pose() const { return {vector("translation", {}), rotation_of(*this)}; }

void Node::fail(const std::string& message, const Field* field) const {
  throw SetupError(files::one_line(fmt::format("{}: {}", field ? field->where : where, message)));
}

}  // namespace murosimf::robot_formats::proto

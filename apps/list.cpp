// `murosimf list`: names of levels, laws, controllers, sensors, parts, lenses and properties.
#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/standard_output.h"
#include "murosimf/collision/pair_law.h"
#include "murosimf/geometry/any_tree.h"
#include "murosimf/io/camera_info.h"
#include "murosimf/io/registry.h"
#include "murosimf/io/sensor_table.h"
#include "murosimf/io/sensor_types.h"
#include "murosimf/model/properties.h"
#include "murosimf/motion/integrator.h"
#include "murosimf/motion/servo_law.h"

namespace murosimf::app {
namespace {

template <class Entry>
std::string names_and_meanings(std::span<const Entry> entries) {
  std::string text;
  for (const Entry& entry : entries) text += fmt::format("{:<22} {}\n", entry.name, entry.meaning);
  return text;
}

/// With the keys that only some types have.
std::string sensors_text() {
  std::string text;
  for (const io::SensorType& type : io::sensor_types()) {
    const bool both = !type.numbers.empty() && !type.objects.empty();
    const std::string keys = fmt::format("{}{}{}", type.numbers, both ? " " : "", type.objects);
    text += fmt::format("{:<22} {}{}\n", type.name, type.meaning, keys.empty() ? "" : "; keys: " + keys);
  }
  return text;
}

std::string properties_text() {
  std::string text =
      fmt::format("{:<30} {:<9} {:<7} {:<22} {:<28} {}\n", "property", "kind", "of", "unit", "frame", "meaning");
  for (const auto& [info, constant] : properties::catalog()) {
    text += fmt::format("{:<30} {:<9} {:<7} {:<22} {:<28} {}\n", info.name, constant ? "constant" : "variable",
                        info.scope == Scope::base ? "base" : "object", info.unit, info.frame, info.meaning);
  }
  return text;
}

}  // namespace

int list(const std::string& what) {
  std::string text;
  if (what == "levels") text = names_and_meanings(io::levels());
  if (what == "contacts") text = names_and_meanings(io::contacts());
  if (what == "body_contacts") text = names_and_meanings(collision::pair_laws());
  if (what == "volumes") {
    for (const auto& name : geometry::volume_names()) text += fmt::format("{}\n", name);
  }
  if (what == "integrators") text = names_and_meanings(motion::integrators());
  if (what == "servo_laws") text = names_and_meanings(motion::servo_laws());
  if (what == "controllers") text = names_and_meanings(io::controllers());
  if (what == "sensors") text = sensors_text();
  if (what == "parts") {
    for (const auto& name : io::sensor_parts()) text += fmt::format("{}\n", name);
  }
  if (what == "lenses") {
    for (const auto& name : io::lens_names()) text += fmt::format("{}\n", name);
  }
  if (what == "properties") text = properties_text();
  write_standard_output(text);
  return 0;
}

}  // namespace murosimf::app

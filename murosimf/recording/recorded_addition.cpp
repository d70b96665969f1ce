#include "murosimf/recording/recorded_addition.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/dynamics/integrator.h"
#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/find_entry.h"

namespace murosimf::recording {
namespace {

using nlohmann::json;
using scene_file::BodySpec;
using scene_file::RobotSpec;

/// To or from JSON: one list of keys for both.
class Keys {
 public:
  Keys(json& object, bool loads) : object_(object), loads_(loads) {}

  template <class T>
  void operator()(const char* key, T& value) {
    if (loads_) {
      read(object_.at(key), value);
    } else {
      object_[key] = written(value);
    }
  }

 private:
  template <class T>
  static json written(const T& value) {
    return value;
  }
  static json written(const Vec3d& v) { return {v.x, v.y, v.z}; }
  static json written(const Color& color) { return {color.red, color.green, color.blue, color.alpha}; }
  static json written(const OptionValues& values) {
    json all = json::object();
    for (const auto& [name, value] : values) {
      all[name] = std::visit([](const auto& one) { return written(one); }, value);
    }
    return all;
  }
  static json written(const dynamics::Integrator& integrator) {
    const auto all = dynamics::integrators();
    const auto found = std::ranges::find(all, integrator, &dynamics::IntegratorEntry::integrator);
    MUROSIMF_ASSERT(found != all.end());
    return std::string(found->name);
  }
  static json written(const std::optional<Shape>& shape) {
    if (!shape) return nullptr;
    json one{{"kind", shape_name(*shape)}};
    std::visit([&](const auto& form) { write_form(one, form); }, *shape);
    return one;
  }
  static void write_form(json& one, const Sphere& form) { one["radius"] = form.radius; }
  static void write_form(json& one, const Box& form) { one["half_size"] = written(form.half_size); }
  static void write_form(json& one, const Ellipsoid& form) { one["semi_axes"] = written(form.semi_axes); }
  template <class Round>  // Capsule, Cylinder
  requires requires(Round form) { form.half_length; }
  static void write_form(json& one, const Round& form) {
    one["radius"] = form.radius;
    one["half_length"] = form.half_length;
  }
  template <class Other>  // Plane, Convex
  requires(!requires(Other form) { form.half_length; }) static void write_form(json& one, const Other&) {
    throw SetupError(
        fmt::format("a body that is a {} cannot be recorded when it comes to a run", one["kind"].get<std::string>()));
  }

  template <class T>
  static void read(const json& from, T& value) {
    from.get_to(value);
  }
  static void read(const json& from, Vec3d& v) {
    v = {from.at(0).get<double>(), from.at(1).get<double>(), from.at(2).get<double>()};
  }
  static void read(const json& from, Color& color) {
    color = {from.at(0).get<double>(), from.at(1).get<double>(), from.at(2).get<double>(), from.at(3).get<double>()};
  }
  static void read(const json& from, OptionValues& values) {
    for (const auto& [name, value] : from.items()) values[name] = option_of(value);
  }
  static OptionValue option_of(const json& value) {
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) return value.get<double>();
    if (value.is_string()) return value.get<std::string>();
    Vec3d v;
    read(value, v);
    return v;
  }
  static void read(const json& from, dynamics::Integrator& integrator) {
    integrator = find_entry(dynamics::integrators(), "integrator", from.get<std::string>()).integrator;
  }
  static void read(const json& from, std::optional<Shape>& shape) {
    if (from.is_null()) return;
    const std::string kind = from.at("kind").get<std::string>();
    const auto number = [&](const char* key) { return from.at(key).get<double>(); };
    const auto vector = [&](const char* key) {
      Vec3d v;
      read(from.at(key), v);
      return v;
    };
    if (kind == shape_name(Sphere{})) {
      shape = Sphere{number("radius")};
    } else if (kind == shape_name(Box{})) {
      shape = Box{vector("half_size")};
    } else if (kind == shape_name(Ellipsoid{})) {
      shape = Ellipsoid{vector("semi_axes")};
    } else if (kind == shape_name(Capsule{})) {
      shape = Capsule{number("radius"), number("half_length")};
    } else if (kind == shape_name(Cylinder{})) {
      shape = Cylinder{number("radius"), number("half_length")};
    } else {
      throw SetupError(fmt::format("there is no such shape of a body: '{}'", kind));
    }
  }

  json& object_;
  bool loads_;
};

void visit(RobotSpec& robot, Keys keys) {
  keys("name", robot.name);
  keys("team", robot.team);
  keys("model", robot.model);
  keys("level", robot.level);
  keys("contact", robot.contact);
  keys("controller", robot.controller);
  keys("rate", robot.rate);
  keys("control_rate", robot.control_rate);
  keys("options", robot.options);
  keys("level_options", robot.level_options);
  keys("contact_options", robot.contact_options);
  keys("servo_law", robot.servo_law);
  keys("motion", robot.motion);
  keys("joint_reference", robot.joint_reference);
  keys("integrator", robot.integrator);
  keys("base_rigid", robot.base_rigid);
  keys("fixed_base", robot.fixed_base);
  keys("position", robot.position);
  keys("heading", robot.heading);
  keys("roll", robot.roll);
  keys("pitch", robot.pitch);
  keys("body", robot.body);
  keys("xacro", robot.xacro);
  keys("keyframe", robot.keyframe);
  keys("command", robot.command);
  keys("present", robot.present);
  keys("accelerations", robot.accelerations);
}

void visit(BodySpec& body, Keys keys) {
  keys("name", body.name);
  keys("shape", body.shape);
  keys("center", body.center);
  keys("model", body.model);
  keys("mass", body.mass);
  keys("material", body.material);
  keys("drag", body.drag);
  keys("lift", body.lift);
  keys("color", body.color);
  keys("position", body.position);
  keys("heading", body.heading);
  keys("roll", body.roll);
  keys("pitch", body.pitch);
  keys("velocity", body.velocity);
  keys("angular_velocity", body.angular_velocity);
  keys("jitters", body.jitters);
  keys("contact", body.contact);
  keys("present", body.present);
}

const char* key_of(const RobotSpec&) { return "robot"; }
const char* key_of(const BodySpec&) { return "body"; }

template <class Spec>
RecordedAddition parsed(json& document) {
  Spec spec;
  spec.where = "an addition of the recorded run";
  visit(spec, Keys(document.at(key_of(spec)), true));
  RecordedAddition addition{.what = std::move(spec)};
  addition.time = Duration(document.at("time_ns").get<Duration::rep>());
  document.at("in_state").get_to(addition.in_state);
  document.at("channels").get_to(addition.channels);
  document.at("names").get_to(addition.names);
  if (addition.time < Duration{}) throw SetupError("an addition came before the run");
  return addition;
}

}  // namespace

std::string to_json(const RecordedAddition& addition) {
  json document{{"schema", files::json_schema("addition")},
                {"time_ns", addition.time.count()},
                {"in_state", addition.in_state},
                {"channels", addition.channels},
                {"names", addition.names}};
  std::visit(
      [&](auto spec) {
        json written = json::object();
        visit(spec, Keys(written, false));
        document[key_of(spec)] = std::move(written);
      },
      addition.what);
  return files::json_text(std::move(document));
}

/// Recordings come from others: every missing or wrong key is an error of the file.
RecordedAddition parse_addition(const std::string& text) {
  try {
    json document = json::parse(text);
    if (document.at("schema") != files::json_schema("addition")) {
      throw SetupError("another version of the program has written what came to the run");
    }
    return document.contains("robot") ? parsed<RobotSpec>(document) : parsed<BodySpec>(document);
  } catch (const json::exception&) {
    throw SetupError("what it says of what came to the run is damaged");
  }
}

/// Numbers of attachments have no zeros before them: their order in the file counts.
std::vector<RecordedAddition> recorded_additions(const McapReader& file) {
  std::vector<RecordedAddition> all;
  for (const AttachmentIndex& one : file.contents().attachments) {
    if (!one.name.starts_with(additions_prefix)) continue;
    all.push_back(with_context(file.file().string(), [&] { return parse_addition(file.attachment(one).data); }));
  }
  return all;
}

void add_to(scene::Scene& scene, const RecordedAddition& addition) {
  std::visit([&](const auto& spec) { (void)scene.add(spec); }, addition.what);
}

}  // namespace murosimf::recording

#include "murosimf/scene/model_constants.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/component_files/servo_description.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene {
namespace {

constexpr std::string_view servo_word = "servo";

const std::array joint_numbers{properties::joint_damping,          properties::joint_armature,
                               properties::joint_friction,         properties::joint_stiffness,
                               properties::joint_spring_reference, properties::joint_rate_limit};

bool is_of_servo(const scene_file::PropertySetting& setting) {
  return setting.object == servo_word || setting.object.ends_with(".servo");
}

const Property<double>* joint_number(std::string_view name) {
  const auto found = std::find_if(joint_numbers.begin(), joint_numbers.end(),
                                  [&](const Property<double>& property) { return property.name == name; });
  return found == joint_numbers.end() ? nullptr : &*found;
}

void require_numbers(const scene_file::PropertySetting& setting, std::size_t count) {
  if (setting.numbers.size() != count) {
    throw SetupError(fmt::format("'{}' takes {} number{}, not {}", setting.property, count, count == 1 ? "" : "s",
                                 setting.numbers.size()));
  }
  if (!std::all_of(setting.numbers.begin(), setting.numbers.end(), [](double x) { return std::isfinite(x); })) {
    throw SetupError(fmt::format("'{}' must be finite", setting.property));
  }
}

/// The constants of one model during the changes.
class Changes {
 public:
  Changes(const Model& model, std::vector<std::string>& diagnostics)
      : model_(model), constants_(model.constants()), diagnostics_(diagnostics) {}

  /// The property decides how many numbers there are, and which objects may have it.
  void take(const scene_file::PropertySetting& setting) {
    if (is_of_servo(setting)) return take_servo(setting);
    if (const auto* property = joint_number(setting.property)) return take_joint_number(setting, *property);
    if (setting.property == properties::joint_range.name) return take_range(setting);
    for (const int object : massive_objects(setting)) {
      if (setting.property == properties::mass.name) take_mass(setting, object);
      if (setting.property == properties::center_of_mass.name) take_center(setting, object);
      if (setting.property == properties::inertia.name) take_inertia(setting, object);
    }
  }
  [[nodiscard]] Model result() const { return model_.with(constants_); }

 private:
  [[nodiscard]] const std::string& name(int object) const { return model_.objects()[object].name; }

  [[nodiscard]] std::vector<int> massive_objects(const scene_file::PropertySetting& setting) const {
    std::vector<int> objects = scene_file::objects_meant(model_, setting.object, setting.property);
    const bool one = objects.size() == 1;
    std::erase_if(objects, [&](int object) { return !constants_.find(properties::mass, object); });
    if (objects.empty() && one) {
      std::vector<std::string_view> heavy;
      for (const int i : model_.having(properties::mass)) heavy.push_back(name(i));
      throw SetupError(fmt::format("'{}' of model '{}' has no mass that could change; these have: {}", setting.object,
                                   model_.name(), fmt::join(heavy, ", ")));
    }
    return objects;
  }

  void take_mass(const scene_file::PropertySetting& setting, int object) {
    require_numbers(setting, 1);
    const double before = *constants_.find(properties::mass, object), mass = setting.numbers[0];
    if (!(mass > 0)) throw SetupError(fmt::format("mass {} kg of '{}': it must be above 0", mass, name(object)));
    constants_.set(properties::mass, object, mass);
    std::string inertia;
    if (const SymMat3d* I = constants_.find(properties::inertia, object)) {
      constants_.set(properties::inertia, object, (mass / before) * *I);
      inertia = fmt::format(", its inertia scaled by {:.4g}", mass / before);
    }
    const bool is_name = model_.find_object(setting.object).has_value();  // not a pattern
    diagnostics_.push_back(fmt::format("{}: mass {:.4g} kg instead of {:.4g} kg{}",
                                       is_name ? setting.object : name(object), mass, before, inertia));
  }

  void take_center(const scene_file::PropertySetting& setting, int object) {
    require_numbers(setting, 3);
    constants_.set(properties::center_of_mass, object, {setting.numbers[0], setting.numbers[1], setting.numbers[2]});
  }

  void take_inertia(const scene_file::PropertySetting& setting, int object) {
    require_numbers(setting, ValueTraits<SymMat3d>::numbers);
    SymMat3d I;
    MUROSIMF_ASSERT(setting.numbers.size() == ValueTraits<SymMat3d>::numbers);
    for (std::size_t i = 0; i < setting.numbers.size(); ++i) ValueTraits<SymMat3d>::set(I, i, setting.numbers[i]);
    constants_.set(properties::inertia, object, I);
  }

  void take_joint_number(const scene_file::PropertySetting& setting, const Property<double>& property) {
    require_numbers(setting, 1);
    const bool signed_number = property.name == properties::joint_spring_reference.name;
    if (!signed_number && setting.numbers[0] < 0) {
      throw SetupError(fmt::format("'{}' is {}; it must be at least 0", property.name, setting.numbers[0]));
    }
    for (const int joint : scene_file::objects_meant(model_, setting.object, property.name)) {
      constants_.set(property, joint, setting.numbers[0]);
    }
  }

  /// The new range of all joints that are meant.
  void take_range(const scene_file::PropertySetting& setting) {
    require_numbers(setting, 2);
    const Vec3d range{setting.numbers[0], setting.numbers[1], 0};
    if (range.x > range.y) throw SetupError(fmt::format("the range from {} to {} is empty", range.x, range.y));
    for (const int joint : scene_file::objects_meant(model_, setting.object, setting.property)) {
      constants_.set(properties::joint_range, joint, range);
    }
  }

  void take_servo(const scene_file::PropertySetting& setting) {
    require_numbers(setting, 1);
    // "shin.servo" -> "shin"; "servo" alone -> "", which means all joints
    const std::size_t cut = setting.object.size() - std::min(setting.object.size(), servo_word.size() + 1);
    const std::string object = setting.object.substr(0, cut);
    int changed = 0;
    for (const int joint : scene_file::objects_meant(model_, object, servo_word)) {
      const Servo* servo = constants_.find(properties::servo, joint);
      if (!servo) continue;
      constants_.set(properties::servo, joint, changed_servo(*servo, setting, name(joint)));
      ++changed;
    }
    if (changed == 0) {
      throw SetupError(object.empty() ? fmt::format("model '{}' has no servos", model_.name())
                                      : fmt::format("'{}' of model '{}' has no servo", object, model_.name()));
    }
  }

  static Servo changed_servo(const Servo& servo, const scene_file::PropertySetting& setting, const std::string& joint) {
    component_files::ServoDescription description(servo);
    toml::table table;
    table.insert(setting.property, setting.numbers[0]);
    try {
      description.take(table);
      return description.finish(joint, table.source());
    } catch (const SetupError& error) {
      throw SetupError(without_place(error.what()));
    }
  }

  /// Removes the place of the description's table, which is in no file.
  static std::string without_place(const std::string& message) {
    const std::size_t end = message.find(": ");
    return message.starts_with("scene:") && end != std::string::npos ? message.substr(end + 2) : message;
  }

  const Model& model_;
  ConstantTable constants_;
  std::vector<std::string>& diagnostics_;
};

}  // namespace

bool is_constant(const scene_file::PropertySetting& setting) {
  const auto& p = setting.property;
  return is_of_servo(setting) || joint_number(p) || p == properties::joint_range.name || p == properties::mass.name ||
         p == properties::center_of_mass.name || p == properties::inertia.name;
}

ModelPtr with_constants(const Model& model, const std::vector<scene_file::PropertySetting>& settings,
                        std::vector<std::string>& diagnostics) {
  Changes changes(model, diagnostics);
  // masses first: a given inertia then replaces the scaled one, whatever the order of the settings
  std::vector<scene_file::PropertySetting> ordered = settings;
  std::stable_partition(ordered.begin(), ordered.end(), [](const scene_file::PropertySetting& setting) {
    return setting.property == properties::mass.name;
  });
  MUROSIMF_ASSERT(!ordered.empty());
  for (const scene_file::PropertySetting& setting : ordered)
    with_context(setting.where, [&] { changes.take(setting); });
  return with_context(ordered.back().where, [&] { return std::make_shared<const Model>(changes.result()); });
}

}  // namespace murosimf::scene

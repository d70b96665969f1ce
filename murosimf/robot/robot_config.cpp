#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/step_table_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/component_files/sensor_toml.h"
#include "murosimf/component_files/servo_description.h"
#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_feedback.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/motion_file.h"

namespace murosimf::robot {
namespace {

/// Fills a RobotConfig from the tables of one file.
class Reader {
 public:
  explicit Reader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] RobotConfig read(const toml::table& root) {
    for (const auto& [key, value] : root) {
      if (key == "soles") {
        read_soles(table_of(key, value));
      } else if (key == "sole_sizes") {
        read_sole_sizes(table_of(key, value));
      } else if (key == "frames") {
        read_other_names(table_of(key, value), table_.frames);
      } else if (key == "joints") {
        read_other_names(table_of(key, value), table_.joints);
      } else if (key == "rate_limits") {
        read_rate_limits(table_of(key, value));
      } else if (key == "rest_positions") {
        read_rest_positions(table_of(key, value));
      } else if (key == "linkages") {
        read_names("linkages", "commanded", table_of(key, value), table_.commanded);
      } else if (key == "surfaces") {
        read_surfaces(table_of(key, value));
      } else if (key == "meshes") {
        read_names("meshes", "part_per_group", table_of(key, value), table_.part_per_group);
      } else if (key == "servos") {
        for (const auto& [name, servo] : table_of(key, value)) read_servo(name, table_of(name, servo));
      } else if (key == "sensors") {
        table_.sensors = component_files::read_sensor_tables(table_of(key, value));
      } else if (key == "walk") {
        read_numbers("walk", locomotion::walk_options(), table_of(key, value), table_.walk);
      } else if (key == "balance") {
        read_balance(table_of(key, value));
      } else if (key == "motions") {
        read_motions(table_of(key, value));
      } else {
        unknown("table", key,
                {"soles", "sole_sizes", "frames", "joints", "rate_limits", "rest_positions", "linkages", "surfaces",
                 "meshes", "servos", "sensors", "walk", "balance", "motions"});
      }
    }
    return table_;
  }

 private:
  [[noreturn]] void unknown(std::string_view kind, const toml::key& key,
                            const std::vector<std::string_view>& known) const {
    files::fail_at(key.source(), unknown_name(kind, key.str(), known));
  }

  const toml::table& table_of(const toml::key& key, const toml::node& node) const {
    if (const auto* table = node.as_table()) return *table;
    files::fail_at(key.source(), fmt::format("'{}' must be a table, like [{}]", key.str(), key.str()));
  }
  [[nodiscard]] TableName name_of(std::string_view key, const toml::node& node) const {
    const auto text = node.value_exact<std::string>();
    if (!text || text->empty()) files::fail_at(node.source(), fmt::format("'{}' must be a name in quotes", key));
    return {*text, files::where(node.source())};
  }

  void read_soles(const toml::table& soles) {
    const std::vector<std::string_view> feet{"left", "right", "front_left", "front_right", "hind_left", "hind_right"};
    for (const auto& [key, value] : soles) {
      if (std::ranges::find(feet, key.str()) == feet.end()) unknown("sole", key, feet);
      table_.soles.push_back(name_of(key, value));
    }
  }

  void read_sole_sizes(const toml::table& sizes) {
    for (const auto& [key, value] : sizes) {
      const auto numbers = value.is_array() ? files::numbers_of(value) : std::nullopt;
      const auto fits = [](double size) { return std::isfinite(size) && size > 0; };
      if (!numbers || numbers->size() != 2 || !std::ranges::all_of(*numbers, fits)) {
        files::fail_at(value.source(),
                       fmt::format("the size of sole '{}' must be [length, width], both more than 0", key.str()));
      }
      const Sole sole{0.5 * numbers->front(), 0.5 * numbers->back()};
      table_.sole_sizes[std::string(key.str())] = {sole, files::where(key.source())};
      // Half sizes inside, whole ones in files.
    }
  }

  void read_other_names(const toml::table& names, std::map<std::string, TableName>& others) {
    for (const auto& [key, value] : names) others[std::string(key.str())] = name_of(key, value);
  }

  void read_rate_limits(const toml::table& limits) {
    for (const auto& [key, value] : limits) {
      const auto numbers = value.is_array() ? std::nullopt : files::numbers_of(value);
      if (!numbers || !std::isfinite(numbers->front()) || numbers->front() < 0) {
        files::fail_at(value.source(), fmt::format("the largest rate of '{}' must be a number from 0", key.str()));
      }
      table_.rate_limits[std::string(key.str())] = {numbers->front(), files::where(key.source())};
    }
  }

  void read_rest_positions(const toml::table& positions) {
    for (const auto& [key, value] : positions) {
      const auto numbers = value.is_array() ? std::nullopt : files::numbers_of(value);
      if (!numbers || !std::isfinite(numbers->front()))
        files::fail_at(value.source(), fmt::format("the rest position of '{}' must be a number", key.str()));
      table_.rest_positions[std::string(key.str())] = {numbers->front(), files::where(key.source())};
    }
  }

  void read_surfaces(const toml::table& surfaces) {
    for (const auto& [key, value] : surfaces) {
      if (key == "default") {
        table_.default_surface = name_of(key, value).name;
      } else {
        table_.surfaces[std::string(key.str())] = {name_of(key, value).name, files::where(key.source())};
      }
    }
  }

  /// A table with only one key, a list of names.
  void read_names(const char* section, const char* only, const toml::table& table, std::vector<TableName>& to) {
    for (const auto& [key, value] : table) {
      if (key != only) unknown(fmt::format("key of [{}]", section), key, {only});
      const toml::array* names = value.as_array();
      if (!names) files::fail_at(key.source(), fmt::format("{} must be a list of names, like [\"torso\"]", only));
      for (const toml::node& name : *names) to.push_back(name_of(only, name));
    }
  }

  void read_number(std::string_view of, const std::vector<OptionInfo>& options, const toml::key& key,
                   const toml::node& value, OptionValues& numbers_read) {
    const std::string name(key.str());
    const OptionInfo* option = find_option(options, name);
    if (!option) unknown(fmt::format("number of the {}", of), key, option_names(options));
    const auto numbers = value.is_array() ? std::nullopt : files::numbers_of(value);
    if (!numbers) files::fail_at(value.source(), fmt::format("'{}' must be a number", name));
    with_context(files::where(value.source()), [&] { check_option(*option, numbers->front()); });
    numbers_read[name] = numbers->front();
  }

  void read_numbers(std::string_view of, const std::vector<OptionInfo>& options, const toml::table& table,
                    OptionValues& numbers_read) {
    for (const auto& [key, value] : table) read_number(of, options, key, value, numbers_read);
  }

  void read_balance(const toml::table& balance) {
    for (const auto& [key, value] : balance) {
      if (key == "steps") {
        const TableName file = name_of("steps", value);
        table_.steps = with_context(file.where, [&] {
          return read_step_table(files::find_data_file(file.name, "models", ".csv", folder_));
        });
      } else {
        read_number("balance", locomotion::balanced_walk_options(), key, value, table_.balance);
      }
    }
  }

  void read_motions(const toml::table& motions) {
    for (const auto& [key, value] : motions) {
      const auto [motion, place] = name_of(key.str(), value);
      table_.motions[std::string(key.str())] = {with_context(place,
                                                             [&] { return read_motion(find_motion(motion, folder_)); }),
                                                place};
    }
  }

  void read_servo(const toml::key& name, const toml::table& table) {
    // A ready-made servo first; the table's own numbers replace its.
    component_files::ServoDescription description{std::string(name.str())};
    if (const toml::node* type = table.get("type")) {
      const TableName ready_made = name_of("type", *type);
      description = with_context(ready_made.where,
                                 [&] { return component_files::read_servo_description(ready_made.name, folder_); });
    }
    description.take(table, {"type", "joints"});
    give_to_joints(description.finish(name.str(), name.source()), name, table);
  }

  void give_to_joints(const Servo& servo, const toml::key& name, const toml::table& table) {
    const toml::array* joints = table["joints"].as_array();
    if (!joints) files::fail_at(name.source(), fmt::format("servo '{}' needs joints = [\"...\"]", name.str()));
    for (const toml::node& node : *joints) {
      const auto [joint, place] = name_of("joints", node);
      const auto [entry, fresh] = table_.servos.emplace(joint, TableServo{servo, place});
      if (!fresh) {
        files::fail_at(node.source(), fmt::format("joint '{}' has servo '{}' already ({}); keep one", joint,
                                                  entry->second.servo.type, entry->second.where));
      }
    }
  }

  std::filesystem::path folder_;  ///< of the file: its names are searched for here
  RobotConfig table_;
};

void check_name(const TableName& entry, std::string_view kind, const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (std::ranges::find(names, entry.name) != names.end()) return;
  throw SetupError(fmt::format("{}: {}", entry.where, unknown_name(kind, entry.name, known)));
}

}  // namespace

const std::string& RobotConfig::surface(const std::string& body) const {
  const auto found = surfaces.find(body);
  return found == surfaces.end() ? default_surface : found->second.name;
}

RobotConfig read_robot_config(const std::filesystem::path& file) {
  return Reader(file.parent_path()).read(files::parse_toml_file(file));
}

RobotConfig read_table_beside(const std::filesystem::path& model_file) {
  auto file = model_file;
  file.replace_extension(".toml");
  std::error_code none;
  return std::filesystem::exists(file, none) ? read_robot_config(file) : RobotConfig{};
}

void check_names(const RobotConfig& table, const RobotNames& names) {
  std::vector<std::string> places = names.frames;
  places.insert(places.end(), names.bodies.begin(), names.bodies.end());
  std::vector<std::string> objects = places;
  objects.insert(objects.end(), names.joints.begin(), names.joints.end());
  for (const auto& [joint, servo] : table.servos) check_name({joint, servo.where}, "joint", names.joints);
  // Servos and other tables of the file were read before the robot was known: names are checked here.
  for (const auto& [joint, limit] : table.rate_limits) check_name({joint, limit.where}, "joint", names.joints);
  for (const auto& [joint, rest] : table.rest_positions) check_name({joint, rest.where}, "joint", names.joints);
  for (const auto& [body, surface] : table.surfaces) check_name({body, surface.where}, "body", names.bodies);
  for (const TableName& joint : table.commanded) check_name(joint, "joint", names.joints);
  for (const TableName& mesh : table.part_per_group) check_name(mesh, "mesh", names.meshes);
  for (const TableName& sole : table.soles) check_name(sole, "frame", places);
  for (const auto& [frame, size] : table.sole_sizes) check_name({frame, size.where}, "frame", places);
  for (const auto& [role, frame] : table.frames) check_name(frame, "frame", objects);
  for (const auto& [alias, joint] : table.joints) check_name(joint, "joint", names.joints);
}

}  // namespace murosimf::robot

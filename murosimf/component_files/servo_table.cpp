#include "murosimf/component_files/servo_table.h"

#include "murosimf/component_files/servo_description.h"
#include "murosimf/files/data_path.h"

namespace murosimf::component_files {

Servo read_servo(std::string_view type) { return read_servo_description(type, {}).finish(type, {}); }

std::vector<std::string> servo_types() { return files::data_file_names("servos", ".toml"); }

}  // namespace murosimf::component_files

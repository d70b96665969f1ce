#include "murosimf/components/servo_table.h"

#include "murosimf/files/data_path.h"
#include "murosimf/components/servo_draft.h"

namespace murosimf::io {

Servo read_servo(std::string_view type) { return read_servo_draft(type, {}).finish(type, {}); }

std::vector<std::string> servo_types() { return data_file_names("servos", ".toml"); }

}  // namespace murosimf::io

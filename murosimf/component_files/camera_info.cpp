#include "murosimf/component_files/camera_info.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_encoding.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::component_files {
namespace {

using imaging::Lens;
using imaging::LensSpec;

/// The fields of one file; every message has the file's name.
class Fields {
 public:
  explicit Fields(const std::filesystem::path& file) : file_(file.string()), root_(load(file_)) {
    if (!root_.IsMap()) fail(root_, "this is no camera calibration: there are no fields");
  }

  [[nodiscard]] bool has(const char* key) const { return static_cast<bool>(root_[key]); }
  [[nodiscard]] std::string where(const char* key) const { return where(root_[key]); }

  [[nodiscard]] std::string text(const char* key) const { return as<std::string>(root_, key, "a text"); }
  [[nodiscard]] int whole_number(const char* key) const { return as<int>(root_, key, "a whole number"); }

  /// The numbers of a matrix; `rows` and `cols` of the file must agree with them.
  [[nodiscard]] std::vector<double> numbers(const char* key) const {
    const YAML::Node matrix = field(root_, key);
    if (!matrix.IsMap()) fail(matrix, fmt::format("'{}' must have rows, cols and data", key));
    const YAML::Node data = field(matrix, "data");
    if (!data.IsSequence()) fail(data, fmt::format("data of '{}' must be a list of numbers", key));
    std::vector<double> found;
    for (const YAML::Node& node : data) found.push_back(number(node, key));
    // Rows and columns are checked as well: numbers copied from another matrix show there.
    const int rows = as<int>(matrix, "rows", "a whole number"), cols = as<int>(matrix, "cols", "a whole number");
    if (rows < 0 || cols < 0 || static_cast<double>(rows) * cols != static_cast<double>(found.size())) {
      fail(data, fmt::format("'{}' has {} numbers in data, but {} rows and {} cols", key, found.size(), rows, cols));
    }
    return found;
  }
  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count) const {
    std::vector<double> found = numbers(key);
    if (found.size() == count) return found;
    fail(root_[key], fmt::format("'{}' has {} numbers; it needs {}", key, found.size(), count));
  }

 private:
  static YAML::Node load(const std::string& file) {
    const std::string text = files::read_text_file(file, files::most_yaml_bytes);
    try {
      return YAML::Load(text);
    } catch (const YAML::ParserException& error) {
      throw SetupError(fmt::format("{}:{}: {}", file, error.mark.line + 1, error.msg));
    }
  }

  [[nodiscard]] std::string where(const YAML::Node& node) const {
    return fmt::format("{}:{}", file_, std::max(0, node.Mark().line) + 1);
  }
  [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const {
    throw SetupError(fmt::format("{}: {}", where(node), message));
  }
  [[nodiscard]] YAML::Node field(const YAML::Node& map, const char* key) const {
    const YAML::Node found = map[key];
    if (!found) fail(map, fmt::format("'{}' is missing", key));
    return found;
  }
  template <class T>
  [[nodiscard]] T as(const YAML::Node& map, const char* key, std::string_view what) const {
    const YAML::Node node = field(map, key);
    try {
      return node.as<T>();
    } catch (const YAML::Exception&) {
      fail(node, fmt::format("'{}' must be {}", key, what));
    }
  }
  [[nodiscard]] double number(const YAML::Node& node, const char* key) const {
    // Infinite and missing numbers are refused by one message.
    try {
      const auto value = node.as<double>();
      if (std::isfinite(value)) return value;
    } catch (const YAML::Exception&) {
    }
    fail(node, fmt::format("data of '{}' must be finite numbers", key));
  }

  std::string file_;
  YAML::Node root_;
};

void read_matrix(const Fields& fields, LensSpec& lens) {
  const std::vector<double> m = fields.numbers("camera_matrix", 9);
  lens.fx = m[0];
  lens.skew = m[1];
  lens.cx = m[2];
  lens.fy = m[4];
  lens.cy = m[5];
  if (m[3] == 0 && m[6] == 0 && m[7] == 0 && m[8] == 1) return;
  throw SetupError(
      fmt::format("{}: 'camera_matrix' must be [fx, skew, cx, 0, fy, cy, 0, 0, 1]", fields.where("camera_matrix")));
}

/// Throws the errors of Lens for the numbers read so far, with the line of `key`.
void check(const Fields& fields, const char* key, const LensSpec& lens) {
  with_context(fields.where(key), [&] { static_cast<void>(Lens(lens)); });
}

LensSpec read_lens(const Fields& fields) {
  LensSpec lens{.fx = 1, .fy = 1};
  // One number after the other, so that an error names the line that causes it.
  lens.width = fields.whole_number("image_width");
  check(fields, "image_width", lens);
  lens.height = fields.whole_number("image_height");
  check(fields, "image_height", lens);
  read_matrix(fields, lens);
  check(fields, "camera_matrix", lens);
  lens.model = fields.text("distortion_model");
  lens.coefficients = fields.numbers("distortion_coefficients");
  // An unknown model is reported at its own line, wrong coefficients at theirs.
  const bool known = std::ranges::find(imaging::lens_models(), lens.model) != imaging::lens_models().end();
  check(fields, known ? "distortion_coefficients" : "distortion_model", lens);
  return lens;
}

/// Writes a matrix; numbers with as many digits as they need.
void put_matrix(YAML::Emitter& out, const char* key, std::size_t rows, const std::vector<double>& numbers) {
  MUROSIMF_ASSERT(rows > 0 && numbers.size() % rows == 0);
  out << YAML::Key << key << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "rows" << YAML::Value << rows;
  out << YAML::Key << "cols" << YAML::Value << numbers.size() / rows;
  out << YAML::Key << "data" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const double number : numbers) out << fmt::format("{}", number);
  out << YAML::EndSeq << YAML::EndMap;
}

/// Uses the model and coefficients that other readers support for the same lens.
void make_common(LensSpec& lens) {
  struct Count {
    std::string_view model;
    std::size_t coefficients;
  };
  if (lens.model == "perspective") lens.model = "plumb_bob";
  for (const auto& [model, coefficients] :
       {Count{"plumb_bob", 5}, Count{"rational_polynomial", 8}, Count{"equidistant", 4}, Count{"ray_polynomial", 6}}) {
    if (lens.model == model) lens.coefficients.resize(coefficients);
  }
}

}  // namespace

CameraCalibration read_camera_info(const std::filesystem::path& file) {
  const Fields fields(file);
  CameraCalibration info{{}, read_lens(fields)};
  if (fields.has("camera_name")) info.name = fields.text("camera_name");
  // Checked although not used: errors there show that a file was changed by hand.
  if (fields.has("rectification_matrix")) static_cast<void>(fields.numbers("rectification_matrix", 9));
  if (fields.has("projection_matrix")) static_cast<void>(fields.numbers("projection_matrix", 12));
  return info;
}

std::string camera_info_yaml(const CameraCalibration& info) {
  LensSpec lens = info.lens;
  make_common(lens);
  YAML::Emitter out;
  out << YAML::BeginMap;
  out << YAML::Key << "image_width" << YAML::Value << lens.width;
  out << YAML::Key << "image_height" << YAML::Value << lens.height;
  out << YAML::Key << "camera_name" << YAML::Value << info.name;
  put_matrix(out, "camera_matrix", 3, {lens.fx, lens.skew, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1});
  out << YAML::Key << "distortion_model" << YAML::Value << lens.model;
  put_matrix(out, "distortion_coefficients", 1, lens.coefficients);
  put_matrix(out, "rectification_matrix", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  put_matrix(out, "projection_matrix", 3, {lens.fx, lens.skew, lens.cx, 0, 0, lens.fy, lens.cy, 0, 0, 0, 1, 0});
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace murosimf::component_files

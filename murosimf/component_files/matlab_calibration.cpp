#include "murosimf/component_files/matlab_calibration.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_encoding.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::component_files {
namespace {

using imaging::LensSpec;

constexpr std::array<std::string_view, 6> names_read{"fc", "cc", "alpha_c", "kc", "nx", "ny"};
constexpr std::string_view blanks = " \t\r";

struct Value {
  int line = 0;  // from 1
  std::string text;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Statements NAME = VALUE of the names that are read. A list continues until its bracket closes, also over lines.
class MatlabFile {
 public:
  explicit MatlabFile(const std::filesystem::path& file) : file_(file.string()) {
    const std::string text = files::read_text_file(file_, files::most_yaml_bytes);
    Value* open = nullptr;  // a list that continues in the next line
    int number = 0;
    for (std::size_t begin = 0; begin <= text.size(); ++number) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line = std::string_view(text).substr(begin, end - begin);
      open = take(line.substr(0, line.find('%')), number + 1, open);
      begin = end + 1;
    }
    if (open) fail_open(*open);
  }

  [[nodiscard]] bool has(std::string_view name) const { return values_.contains(name); }
  [[nodiscard]] std::string where(std::string_view name) const {
    MUROSIMF_ASSERT(has(name));
    return fmt::format("{}:{}", file_, values_.find(name)->second.line);
  }

  [[nodiscard]] std::vector<double> numbers(std::string_view name, std::size_t least, std::size_t most) const {
    const Value& value = find(name);
    std::vector<double> found;
    std::string_view rest = trimmed(value.text);
    if (rest.starts_with('[')) rest = trimmed(rest.substr(1, rest.find(']') - 1));
    while (!rest.empty()) found.push_back(next_number(name, value.line, rest));
    if (found.size() >= least && found.size() <= most) return found;
    fail(value.line, fmt::format("'{}' has {} numbers; it needs {}", name, found.size(),
                                 least == most ? fmt::format("{}", most) : fmt::format("{} or {}", least, most)));
  }
  [[nodiscard]] double number(std::string_view name) const { return numbers(name, 1, 1).front(); }
  [[nodiscard]] int whole_number(std::string_view name) const {
    const double value = number(name);
    if (value == std::floor(value) && std::abs(value) < 1e9) return static_cast<int>(value);
    fail(find(name).line, fmt::format("'{}' is {}; it must be a whole number", name, value));
  }

 private:
  /// The list that continues after this line, or null.
  Value* take(std::string_view line, int number, Value* open) {
    const std::size_t equals = line.find('=');
    // An assignment inside of a list means that its bracket is missing.
    if (open && equals != std::string_view::npos) fail_open(*open);
    if (open) return add(*open, line);
    if (equals == std::string_view::npos) return nullptr;
    const std::string_view name = trimmed(line.substr(0, equals));
    if (std::ranges::find(names_read, name) == names_read.end()) return nullptr;
    const auto [entry, is_new] = values_.emplace(name, Value{number, {}});
    if (!is_new) fail(number, fmt::format("'{}' is there twice, first in line {}", name, entry->second.line));
    return add(entry->second, line.substr(equals + 1));
  }
  static Value* add(Value& value, std::string_view text) {
    value.text += ' ';
    value.text += text;
    const bool is_list = value.text.find('[') != std::string::npos;
    return is_list && value.text.find(']') == std::string::npos ? &value : nullptr;
  }

  [[nodiscard]] const Value& find(std::string_view name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) throw SetupError(fmt::format("{}: '{}' is missing", file_, name));
    return found->second;
  }
  /// Removes a number from the front of `rest`, with the separators behind it.
  double next_number(std::string_view name, int line, std::string_view& rest) const {
    constexpr std::string_view between = " \t\r;,";
    const std::string_view word = rest.substr(0, rest.find_first_of(between));
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool good = error == std::errc{} && end == digits.data() + digits.size() && std::isfinite(number);
    if (!good) fail(line, fmt::format("'{}' must be finite numbers, not '{}'", name, word));
    rest.remove_prefix(word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(between), rest.size()));
    return number;
  }
  [[noreturn]] void fail_open(const Value& list) const { fail(list.line, "the list has no end: ']' is missing"); }
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw SetupError(fmt::format("{}:{}: {}", file_, line, message));
  }

  std::string file_;
  std::map<std::string, Value, std::less<>> values_;
};

/// Throws the errors of Lens for the numbers read so far, with the line of `name`.
void check(const MatlabFile& file, std::string_view name, const LensSpec& lens) {
  with_context(file.where(name), [&] { static_cast<void>(imaging::Lens(lens)); });
}

}  // namespace

CameraCalibration read_calib_results(const std::filesystem::path& path) {
  const MatlabFile file(path);
  LensSpec lens{.model = "perspective", .fx = 1, .fy = 1};
  // One number after the other, so that an error names the line that causes it.
  lens.width = file.whole_number("nx");
  check(file, "nx", lens);
  lens.height = file.whole_number("ny");
  check(file, "ny", lens);
  const std::vector<double> focal = file.numbers("fc", 2, 2), center = file.numbers("cc", 2, 2);
  MUROSIMF_ASSERT(focal.size() == 2 && center.size() == 2);
  lens.fx = focal[0];
  lens.fy = focal[1];
  check(file, "fc", lens);
  lens.cx = center[0];
  lens.cy = center[1];
  check(file, "cc", lens);
  if (file.has("alpha_c")) {
    // The toolbox gives the skew as a share of the focal length.
    lens.skew = file.number("alpha_c") * lens.fx;
    check(file, "alpha_c", lens);
  }
  lens.model = "plumb_bob";
  lens.coefficients = file.numbers("kc", 4, 5);
  check(file, "kc", lens);
  return {{}, lens};
}

CameraCalibration read_calibration(const std::filesystem::path& file) {
  return file.extension() == ".m" ? read_calib_results(file) : read_camera_info(file);
}

}  // namespace murosimf::component_files

#include "murosimf/viewer/script.h"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "murosimf/files/text_encoding.h"
#include "murosimf/model/error.h"
#include "murosimf/viewer/key_map.h"

namespace murosimf::viewer {
namespace {

using Kind = ScriptStep::Kind;

/// Syntax of the arguments of a word.
struct Grammar {
  std::string_view word;
  Kind kind;
  enum class Text { none, name, rest } text;
  std::size_t numbers;
  std::string_view form;
};

/// The last text is shown in errors.
constexpr std::array grammar{
    Grammar{"wait", Kind::wait, Grammar::Text::none, 1, "wait SECONDS"},
    Grammar{"until", Kind::until, Grammar::Text::none, 1, "until SECONDS"},
    Grammar{"settle", Kind::settle, Grammar::Text::none, 0, "settle"},
    Grammar{"key", Kind::key, Grammar::Text::name, 0, "key Ctrl+P"},
    Grammar{"click", Kind::click, Grammar::Text::name, 0, "click NAME, or click X Y"},
    Grammar{"double", Kind::double_click, Grammar::Text::name, 0, "double NAME"},
    Grammar{"press", Kind::press, Grammar::Text::rest, 0, "press TEXT"},
    Grammar{"drag", Kind::drag, Grammar::Text::name, 2, "drag NAME X Y"},
    Grammar{"push", Kind::push, Grammar::Text::name, 3, "push NAME X Y Z"},
    Grammar{"twist", Kind::twist, Grammar::Text::name, 3, "twist NAME X Y Z"},
    Grammar{"type", Kind::type, Grammar::Text::rest, 0, "type TEXT"},
    Grammar{"scrub", Kind::scrub, Grammar::Text::none, 1, "scrub SECONDS"},
    Grammar{"look", Kind::look, Grammar::Text::none, 3, "look AZIMUTH_DEG ELEVATION_DEG DISTANCE"},
    Grammar{"screenshot", Kind::screenshot, Grammar::Text::rest, 0, "screenshot FILE.png"},
    Grammar{"say", Kind::say, Grammar::Text::rest, 0, "say TEXT"},
};

/// The whole text must be the number: "1x" is an error.
double number_of(const std::string& text, const Grammar& form) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(number)) return number;
  throw SetupError(fmt::format("'{}' is no number; write: {}", text, form.form));
}

const Grammar& grammar_of(const std::string& word) {
  std::vector<std::string_view> words;
  for (const Grammar& one : grammar) {
    if (one.word == word) return one;
    words.push_back(one.word);
  }
  throw SetupError(unknown_name("word", word, words));
}

std::string without_comment(std::string line) {
  // a # within a word starts no comment: file names may contain one
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) line.resize(i);
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t' || line.back() == '\r')) line.pop_back();
  return line;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.-") == std::string::npos;
}

/// Words are checked when the script is read, not when the step is reached.
ScriptStep read_step(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  const Grammar& form = grammar_of(word);
  ScriptStep step{.kind = form.kind};
  if (form.text == Grammar::Text::rest) {
    std::getline(words >> std::ws, step.text);
    if (step.text.empty()) throw SetupError(fmt::format("something is missing; write: {}", form.form));
    return step;
  }
  if (form.text == Grammar::Text::name && !(words >> step.text)) {
    throw SetupError(fmt::format("something is missing; write: {}", form.form));
  }
  std::size_t numbers = form.numbers;
  if (form.kind == Kind::click && is_number(step.text)) {
    step.numbers.push_back(number_of(step.text, form));
    step.text.clear();
    numbers = 2;
  }
  std::string number;
  while (words >> number) step.numbers.push_back(number_of(number, form));
  if (step.numbers.size() != numbers) {
    throw SetupError(fmt::format("{} numbers, not {}; write: {}", numbers, step.numbers.size(), form.form));
  }
  const bool is_time = form.kind == Kind::wait || form.kind == Kind::until || form.kind == Kind::scrub;
  if (is_time && !(step.numbers[0] >= 0 && step.numbers[0] <= 1e6)) {
    throw SetupError(fmt::format("{} must be from 0 to 1e6 seconds", form.word));
  }
  if (form.kind == Kind::key) (void)read_chord(step.text);
  return step;
}

}  // namespace

/// Errors name the line of the script.
std::vector<ScriptStep> parse_script(std::string_view text, const std::string& name) {
  std::vector<ScriptStep> steps;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = without_comment(line);
    if (line.find_first_not_of(" \t") == std::string::npos) continue;
    const std::string where = fmt::format("{}:{}", name, number);
    steps.push_back(with_context(where, [&] { return read_step(line); }));
    steps.back().where = where;
  }
  return steps;
}

std::vector<ScriptStep> read_script(const std::filesystem::path& file) {
  constexpr std::uintmax_t most_bytes = 1'000'000;
  return parse_script(files::read_text_file(file, most_bytes), file.string());
}

}  // namespace murosimf::viewer

#include "benchmarks/peers/options.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <string_view>

namespace peers {

namespace {

double number(std::string_view option, std::string_view text, double most) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= 0 && value <= most)) {
    throw std::runtime_error(std::string(option) + ": '" + std::string(text) + "' is no number from 0 to " +
                             std::to_string(static_cast<int>(most)));
  }
  return value;
}

}  // namespace

Options read_options(std::span<char*> arguments, const std::vector<std::string>& settings) {
  Options options{.setting = settings.front()};
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string_view name = arguments[i];
    if (!name.starts_with("--")) {
      options.folder = name;
      continue;
    }
    if (name == "--observe") {
      options.observe = true;
      continue;
    }
    if (i + 1 == arguments.size()) throw std::runtime_error(std::string(name) + " needs a value");
    const std::string_view value = arguments[++i];
    if (name == "--warm")
      options.warm = number(name, value, 1000);
    else if (name == "--seconds")
      options.seconds = number(name, value, 1000);
    else if (name == "--worlds")
      options.worlds = static_cast<int>(number(name, value, 1e6));
    else if (name == "--threads")
      options.threads = static_cast<int>(number(name, value, 256));
    else if (name == "--setting")
      options.setting = value;
    else
      throw std::runtime_error("unknown option " + std::string(name));
  }
  if (options.folder.empty())
    throw std::runtime_error("usage: FOLDER [--setting S] [--warm s] [--seconds s] [--observe]");
  if (options.threads < 1 || options.worlds < 1 || options.seconds <= 0) {
    throw std::runtime_error("--threads, --worlds and --seconds must be above 0");
  }
  if (std::ranges::find(settings, options.setting) == settings.end()) {
    std::string known;
    for (const std::string& setting : settings) known += (known.empty() ? "" : ", ") + setting;
    throw std::runtime_error("unknown setting '" + options.setting + "'; known: " + known);
  }
  return options;
}

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace peers

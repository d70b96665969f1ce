#include "apps/command.h"

#include <charconv>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace murosimf::app {
namespace {

/// Whole numbers if `low` is one.
template <class Number>
CLI::Validator range(Number low, Number high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool good = error == std::errc{} && end == text.data() + text.size() && number >= low && number <= high;
    return good ? std::string{} : fmt::format("Value {} not in range {} to {}", text, low, high);
  };
  return {check, fmt::format("{} in [{} - {}]", CLI::detail::type_name<Number>(), low, high)};
}

}  // namespace

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::shows_default() const {
  option_->capture_default_str();
  return *this;
}

Option Option::within(std::int64_t low, std::int64_t high) const {
  option_->check(range(low, high));
  return *this;
}

Option Option::within(double low, double high) const {
  option_->check(range(low, high));
  return *this;
}

Option Option::one_of(const std::vector<std::string>& names) const {
  option_->check(CLI::IsMember(names));
  return *this;
}

Option Option::one_at_a_time() const {
  option_->allow_extra_args(false);
  return *this;
}

Option Option::separated_by(char separator) const {
  option_->delimiter(separator);
  // also if it takes one word only, or none (value_if_alone)
  option_->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return *this;
}

Option Option::needs(Option other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::excludes(Option other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::value_if_alone(const std::string& value) const {
  option_->expected(0, 1);
  option_->default_str(value);
  return *this;
}

Option Option::offers_list(const std::string& kind) const {
  (*offers_)[option_].list = kind;
  return *this;
}

Option Option::offers(const std::vector<std::string>& names) const {
  (*offers_)[option_].names = names;
  return *this;
}

Option Command::add(const std::string& name, std::string& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, std::vector<std::string>& values, const std::string& meaning) const {
  return {*app_->add_option(name, values, meaning), *offers_};
}

Option Command::add(const std::string& name, int& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, std::int64_t& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, std::optional<std::int64_t>& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, std::optional<std::uint64_t>& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, double& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, std::optional<double>& value, const std::string& meaning) const {
  return {*app_->add_option(name, value, meaning), *offers_};
}

Option Command::add(const std::string& name, bool& flag, const std::string& meaning) const {
  return {*app_->add_flag(name, flag, meaning), *offers_};
}

}  // namespace murosimf::app

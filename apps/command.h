/// command.h - options of the program's commands, independent of the parser (CLI11 takes seconds to compile).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace murosimf::app {

/// What shells complete the value of an option with, besides files.
struct Offer {
  std::string list;                ///< what `murosimf list` prints of it, like "scenes"; empty: nothing
  std::vector<std::string> names;  ///< or these
};
using Offers = std::map<const CLI::Option*, Offer>;

/// An option that was added; its members pass properties on to the parser. Copies are the same option.
class Option {
 public:
  Option(CLI::Option& option, Offers& offers) : option_(&option), offers_(&offers) {}

  Option required() const;
  /// --help shows the value that it has now.
  Option shows_default() const;
  /// Unlike the parser's own ranges, "nan" and numbers with too many digits are not within one.
  Option within(int low, int high) const { return within(std::int64_t{low}, std::int64_t{high}); }
  Option within(std::int64_t low, std::int64_t high) const;
  Option within(double low, double high) const;
  Option one_of(const std::vector<std::string>& names) const;
  /// A list: one value each time the option is given, instead of all that follow.
  Option one_at_a_time() const;
  /// A list: several values in one word.
  Option separated_by(char separator) const;
  Option needs(Option other) const;
  Option excludes(Option other) const;

  /// The value may be left out; this is its default then.
  Option value_if_alone(const std::string& value) const;

  /// Shells complete it with what `murosimf list KIND` prints.
  Option offers_list(const std::string& kind) const;
  /// Shells complete it with these.
  Option offers(const std::vector<std::string>& names) const;

 private:
  CLI::Option* option_;
  Offers* offers_;
};

/// Takes the options of one command. A name that begins with two dashes is an option, any other a positional argument. The
/// values must live as long as the command line; without the option they stay what they are.
class Command {
 public:
  Command(CLI::App& app, Offers& offers) : app_(&app), offers_(&offers) {}

  Option add(const std::string& name, std::string& value, const std::string& meaning) const;
  Option add(const std::string& name, std::vector<std::string>& values, const std::string& meaning) const;
  Option add(const std::string& name, int& value, const std::string& meaning) const;
  Option add(const std::string& name, std::int64_t& value, const std::string& meaning) const;
  Option add(const std::string& name, std::optional<std::int64_t>& value, const std::string& meaning) const;
  Option add(const std::string& name, std::optional<std::uint64_t>& value, const std::string& meaning) const;
  Option add(const std::string& name, double& value, const std::string& meaning) const;
  Option add(const std::string& name, std::optional<double>& value, const std::string& meaning) const;
  /// Takes no value: it is there, or not.
  Option add(const std::string& name, bool& flag, const std::string& meaning) const;

 private:
  CLI::App* app_;
  Offers* offers_;
};

}  // namespace murosimf::app

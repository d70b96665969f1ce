#include "murosimf/league/rule_names.h"

#include <array>
#include <cstddef>
#include <map>
#include <string_view>

#include <fmt/format.h>

namespace murosimf::league {
namespace {

using namespace std::string_view_literals;

constexpr std::array states{"initial"sv, "ready"sv, "set"sv, "playing"sv, "finished"sv};
constexpr std::array secondary_states{"normal play"sv,  "penalty shoot-out"sv, "overtime"sv,
                                      "timeout"sv,      "direct free kick"sv,  "indirect free kick"sv,
                                      "penalty kick"sv, "corner kick"sv,       "goal kick"sv,
                                      "throw-in"sv};

template <std::size_t count>
std::string name_in(const std::array<std::string_view, count>& names, int number, std::string_view kind) {
  const auto index = static_cast<std::size_t>(number);
  return number >= 0 && index < count ? std::string(names[index]) : fmt::format("{} {}", kind, number);
}

}  // namespace

std::string state_name(int state) { return name_in(states, state, "state"); }
std::string secondary_state_name(int state) { return name_in(secondary_states, state, "secondary state"); }

std::string penalty_name(int penalty) {
  static const std::map<int, std::string_view> names{{30, "ball manipulation"},
                                                     {31, "physical contact"},
                                                     {32, "illegal attack"},
                                                     {33, "illegal defense"},
                                                     {34, "pickup/incapable"},
                                                     {35, "service"},
                                                     {14, "substitute"},
                                                     {1, "illegal positioning"},
                                                     {2, "motion in set"},
                                                     {3, "motion in stop"},
                                                     {4, "local game stuck"},
                                                     {5, "incapable"},
                                                     {6, "pick-up"},
                                                     {7, "ball holding"},
                                                     {8, "leaving the field"},
                                                     {9, "playing with arms or hands"},
                                                     {10, "pushing"},
                                                     {11, "cautioned"},
                                                     {12, "sent off"},
                                                     {13, "substitute"}};
  const auto found = names.find(penalty);
  return found == names.end() ? fmt::format("penalty {}", penalty) : fmt::format("penalty, {}", found->second);
}

}  // namespace murosimf::league

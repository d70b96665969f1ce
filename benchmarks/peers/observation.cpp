#include "benchmarks/peers/observation.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace peers {

namespace {

double mean_distance(const std::vector<Vector>& from, const std::vector<Vector>& to) {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) sum += std::hypot(to[i][0] - from[i][0], to[i][1] - from[i][1]);
  return sum / static_cast<double>(from.size());
}

}  // namespace

void Observation::add(const View& view, std::span<const double> targets) {
  std::size_t joint = 0;
  std::vector<Vector> places;
  for (const View::Robot& robot : view.robots) {
    heights_ += robot.position[2];
    places.push_back(robot.position);
    for (const double q : robot.joints) squares_ += std::pow(q - targets[joint++], 2);
  }
  joints_ += joint;
  ++views_;
  contacts_ += view.contacts;
  depth_ = std::max(depth_, view.depth);
  gap_ = std::max(gap_, view.gap);
  places_.push_back(std::move(places));
  last_ = view;
}

nlohmann::json Observation::result(double cycle) const {
  const auto views = static_cast<double>(views_);
  const std::size_t middle = views_ / 2;
  const double late = cycle * static_cast<double>(views_ - 1 - middle);
  constexpr double lying = 0.5;  // the base leans by more than 60 degrees
  return {{"height_m", heights_ / views / static_cast<double>(last_.robots.size())},
          {"distance_m", mean_distance(places_.front(), places_.back())},
          {"late_speed_mm_s", late > 0 ? 1e3 * mean_distance(places_[middle], places_.back()) / late : 0},
          {"tracking_rad", std::sqrt(squares_ / static_cast<double>(joints_))},
          {"contacts", contacts_ / views},
          {"depth_mm", 1e3 * depth_},
          {"gap_mm", 1e3 * gap_},
          {"lying", std::ranges::count_if(last_.robots, [](const auto& robot) { return robot.upright < lying; })}};
}

}  // namespace peers

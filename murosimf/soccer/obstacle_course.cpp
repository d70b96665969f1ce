#include "murosimf/soccer/obstacle_course.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/soccer/behavior_properties.h"
#include "murosimf/soccer/dead_reckoning.h"
#include "murosimf/soccer/walk_to.h"

namespace murosimf::soccer {
namespace {

constexpr double across = 0.6;       // [m] behind the line it stops: dead reckoning may be a tenth too long
constexpr double beyond = 0.8;       // [m] behind the line is its goal
constexpr double keep_inside = 0.2;  // [m] of the touch lines

/// [m] The point of a way that is first `ahead` away from its beginning, or its end.
Vec3d point_ahead(const std::vector<Vec3d>& way, double ahead) noexcept {
  MUROSIMF_ASSERT(!way.empty() && ahead >= 0);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vec3d step = way[i] - way[i - 1];
    const double length = norm(step);
    if (length >= ahead) return way[i - 1] + (ahead / length) * step;
    ahead -= length;
  }
  return way.back();
}

}  // namespace

void append_hash(Hasher& hasher, const Course& course) {
  for (const soccer::Obstacle& obstacle : course.obstacles.all()) append_hash(hasher, obstacle.place);
  for (const Vec3d& place : course.way) append_hash(hasher, place);
}

ObstacleCourse::ObstacleCourse(Setup& setup, const ObstacleCourseOptions& options)
    : options_(options),
      frame_(sensors::read_frame(setup, options.camera)),
      body_(setup, *frame_.info),
      blobs_(options.color),
      around_(soccer::most_obstacles),
      velocity_(setup.read(properties::gait_velocity)[0]),
      command_(setup.write(properties::walk_command)[0]),
      pose_(setup.write(properties::pose_estimate)[0]),
      course_(setup.write(planned_course)[0]) {
  disks_.reserve(soccer::most_obstacles);
}

void ObstacleCourse::initialize() {
  command_ = {};
  pose_ = options_.start;
  course_.obstacles.clear();
  course_.way.clear();
  // Reserved once, so that steps do not allocate.
  course_.way.reserve(around_.most_points());
  course_.heading = std::numeric_limits<double>::quiet_NaN();
  course_.frame = 0;
}

void ObstacleCourse::step(const Instant& instant) noexcept {
  const double before = course_.heading;
  if (!body_.sense()) return;
  course_.heading = body_.heading();
  if (std::isfinite(before)) {
    pose_ = soccer::moved(pose_, soccer::step_along(velocity_, soccer::wrapped(body_.heading() - before),
                                                    seconds(instant.period)));
  }
  if (frame_.number != course_.frame) {
    look();
    plan();
  }
  walk();
}

void ObstacleCourse::look() noexcept {
  course_.frame = frame_.number;
  for (const soccer::Blob& blob : blobs_.find(frame_.color)) {
    const auto seen =
        soccer::obstacle_of(blob, frame_.info->lens, body_.camera(), options_.obstacle_radius, options_.farthest);
    if (seen) course_.obstacles.see(soccer::from_frame(pose_, seen->place), seen->whole, 3 * options_.obstacle_radius);
  }
}

/// Plans with less clearance where there is no way.
void ObstacleCourse::plan() noexcept {
  for (const double share : {1.0, 0.6, 0.2}) {
    plan(share * options_.clearance);
    if (!course_.way.empty()) return;
  }
}

void ObstacleCourse::plan(double clearance) noexcept {
  MUROSIMF_ASSERT(clearance >= 0);
  disks_.clear();
  for (const soccer::Obstacle& obstacle : course_.obstacles.all()) {
    if (obstacle.sightings < options_.fewest_sightings) continue;
    disks_.push_back({obstacle.place, options_.obstacle_radius + options_.robot_radius + clearance});
  }
  const double forward = options_.goal_x > options_.start.x ? 1 : -1, inside = options_.half_width - keep_inside;
  const Vec3d here{pose_.x, pose_.y, 0};
  const Vec3d goal{options_.goal_x + beyond * forward, std::clamp(pose_.y, -inside, inside), 0};
  const auto way = around_.find(here, goal, disks_, {.lowest_y = -inside, .highest_y = inside});
  MUROSIMF_ASSERT(way.size() <= around_.most_points());
  course_.way.assign(way.begin(), way.end());
}

void ObstacleCourse::walk() noexcept {
  const double forward = options_.goal_x > options_.start.x ? 1 : -1;
  if (forward * (pose_.x - options_.goal_x) > across || course_.way.empty()) {
    command_ = {};
    return;
  }
  command_ = walk_to(soccer::to_frame(pose_, point_ahead(course_.way, options_.look_ahead)), options_.speed);
}

}  // namespace murosimf::soccer

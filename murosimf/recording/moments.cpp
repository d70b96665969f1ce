#include "murosimf/recording/moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/run_watch.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {
namespace {

using namespace std::chrono_literals;
using Kind = Moment::Kind;

constexpr double kick_change = 0.8;      // [m/s]
constexpr double fastest_ball = 30;      // [m/s] faster, and it was put elsewhere
constexpr double reach = 0.25;           // [m] from the middle of the ball to the origin of a body
constexpr Duration kick_window = 100ms;  // a kick takes some frames
constexpr Duration speeding_up = 200ms;  // the foot pushes on
constexpr Duration between_kicks = 400ms;
const double cos_fallen = std::cos(pi / 3), cos_upright = std::cos(pi / 6);

/// Velocities of the ball by differences of its recorded places, over a window.
class BallMotion {
 public:
  void see(Duration time, const Vec3d& place) {
    if (last_ && time > last_->first) {
      const Vec3d velocity = (1 / seconds(time - last_->first)) * (place - last_->second);
      if (norm(velocity) > fastest_ball) forget();
      velocities_.emplace_back(time, last_ ? velocity : Vec3d{});
    }
    before_ = last_ ? last_->second : place;
    last_.emplace(time, place);
    // two of them at least, in recordings with few frames, too
    while (velocities_.size() > 2 && velocities_.front().first < time - kick_window) velocities_.pop_front();
  }
  void forget() {
    last_.reset();
    velocities_.clear();
  }
  /// In the frame before: where it was kicked, if frames are few.
  [[nodiscard]] const Vec3d& place_before() const { return before_; }
  [[nodiscard]] double change() const {
    return velocities_.empty() ? 0 : norm(velocities_.back().second - velocities_.front().second);
  }
  [[nodiscard]] double speed() const { return velocities_.empty() ? 0 : norm(velocities_.back().second); }

 private:
  std::optional<std::pair<Duration, Vec3d>> last_;
  Vec3d before_;
  std::deque<std::pair<Duration, Vec3d>> velocities_;
};

struct WatchedRobot {
  const Entity* entity = nullptr;
  bool lying = false;
};

class MomentFinder {
 public:
  explicit MomentFinder(const scene::Scene& scene) : scene_(scene), ball_(scene.parts().ball) {
    for (const Entity* entity : scene.moving_entities()) {
      const Column<Mat3d>* R = entity->find(properties::orientation);
      if (entity == ball_ || !R || entity->model().joints().empty()) continue;
      robots_.push_back({.entity = entity, .lying = R->values[0].z.z < cos_fallen});
    }
    goal_ = goal_with_ball(scene_);
  }

  void see(std::vector<Moment>& moments) {
    const Duration now = scene_.simulation().now();
    const int goal = goal_with_ball(scene_);
    if (goal != 0 && goal_ == 0) moments.push_back({.kind = Kind::goal, .time = now, .robot = {}, .goal = goal});
    goal_ = goal;
    see_kick(now, moments);
    for (WatchedRobot& robot : robots_) see_lean(robot, now, moments);
  }

 private:
  void see_kick(Duration now, std::vector<Moment>& moments) {
    const Column<Vec3d>* place = ball_ && ball_->present() ? ball_->find(properties::position) : nullptr;
    if (!place) return motion_.forget();
    motion_.see(now, place->values[0]);
    if (now <= kicked_ + speeding_up) moments[kick_].speed = std::max(moments[kick_].speed, motion_.speed());
    if (motion_.change() < kick_change || motion_.speed() < kick_change) return;
    const WatchedRobot* kicker = nearest_to(motion_.place_before());
    if (!kicker || now < kicked_ + between_kicks) return;
    kicked_ = now;
    kick_ = moments.size();
    moments.push_back({Kind::kick, now, kicker->entity->name(), motion_.speed(), 0});
  }

  [[nodiscard]] const WatchedRobot* nearest_to(const Vec3d& place) const {
    const WatchedRobot* nearest = nullptr;
    double least = reach;
    for (const WatchedRobot& robot : robots_) {
      if (!robot.entity->present()) continue;
      for (const Vec3d& origin : robot.entity->find(properties::position)->values) {
        if (norm(origin - place) > least) continue;
        least = norm(origin - place);
        nearest = &robot;
      }
    }
    return nearest;
  }

  static void see_lean(WatchedRobot& robot, Duration now, std::vector<Moment>& moments) {
    if (!robot.entity->present()) return;
    const double cos_lean = robot.entity->find(properties::orientation)->values[0].z.z;
    if (!robot.lying && cos_lean < cos_fallen) {
      robot.lying = true;
      moments.push_back({Kind::fall, now, robot.entity->name(), 0, 0});
    } else if (robot.lying && cos_lean > cos_upright) {
      robot.lying = false;
      moments.push_back({Kind::get_up, now, robot.entity->name(), 0, 0});
    }
  }

  const scene::Scene& scene_;
  const Entity* ball_;
  std::vector<WatchedRobot> robots_;
  BallMotion motion_;
  Duration kicked_ = Duration::min() / 2;
  std::size_t kick_ = 0;  // index of the last one
  int goal_ = 0;
};

Duration before(Kind kind) {
  switch (kind) {
    case Kind::goal: return 3s;
    case Kind::get_up: return 4s;
    case Kind::kick:
    case Kind::fall: break;
  }
  return 1200ms;
}
constexpr Duration after = 1800ms;

}  // namespace

const std::vector<std::string>& moment_kinds() {
  static const std::vector<std::string> names = {"goal", "kick", "fall", "get_up"};
  return names;
}

std::string_view name_of(Kind kind) { return moment_kinds()[static_cast<std::size_t>(kind)]; }

std::string text_of(const Moment& moment) {
  switch (moment.kind) {
    case Kind::kick: return fmt::format("{} kicks the ball ({:.1f} m/s)", moment.robot, moment.speed);
    case Kind::fall: return moment.robot + " falls";
    case Kind::get_up: return moment.robot + " gets up";
    case Kind::goal: break;
  }
  return "goal";
}

std::vector<Moment> find_moments(RecordedSource& source, const std::function<bool()>& stop) {
  std::vector<Moment> moments;
  source.begin();
  MomentFinder finder(source.scene());
  while (!source.at_end() && !stop()) {
    source.step();
    finder.see(moments);
  }
  return moments;
}

std::vector<Clip> clips_of(std::vector<Moment> moments, const std::set<std::string>& kinds, std::size_t most,
                           Duration first, Duration last) {
  MUROSIMF_ASSERT(first <= last);
  std::erase_if(moments, [&](const Moment& one) { return !kinds.contains(std::string(name_of(one.kind))); });
  std::ranges::stable_sort(moments, [](const Moment& a, const Moment& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.speed > b.speed;
  });
  if (moments.size() > most) moments.resize(most);
  std::ranges::stable_sort(moments, {}, &Moment::time);
  std::vector<Clip> clips;
  for (Moment& moment : moments) {
    const Duration begin = std::max(first, moment.time - before(moment.kind)),
                   end = std::min(last, moment.time + after);
    // one that begins earlier than those before it takes them in
    Clip clip{begin, end, {}};
    while (!clips.empty() && clips.back().end >= clip.begin) {
      clip.begin = std::min(clip.begin, clips.back().begin);
      clip.moments.insert(clip.moments.begin(), clips.back().moments.begin(), clips.back().moments.end());
      clips.pop_back();
    }
    clip.moments.push_back(std::move(moment));
    clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace murosimf::recording

#include "murosimf/dataset/arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "murosimf/dataset/colors.h"
#include "murosimf/dataset/places.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::dataset {
namespace {

constexpr double camera_reach = 0.3;  // [m] free around a free camera
constexpr double deg = pi / 180;

/// One of the first `count` of what the bank has, by weights; the first one if none of these has a weight; nothing if there is none.
std::optional<std::size_t> drawn_doing(const Postures& known, const std::array<double, 3>& weights, double draw,
                                       std::size_t count) {
  std::optional<std::size_t> first, drawn;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (known[i].empty()) continue;
    if (!first) first = i;
    sum += weights[i];
  }
  if (sum == 0) return first;
  double rest = draw * sum;
  for (std::size_t i = 0; i < count; ++i) {
    if (known[i].empty() || weights[i] == 0) continue;
    drawn = i;
    if (rest < weights[i]) break;
    rest -= weights[i];
  }
  return drawn;
}

class Arranger {
 public:
  Arranger(const Stage& stage, const Randomisation& r, const imaging::Lens& lens, std::uint64_t seed,
           std::uint64_t number)
      : stage_(stage), r_(r), lens_(lens), seed_(seed), number_(number), places_(stage.field()) {
    result_.frame = stage.at_start();
    result_.colors.resize(stage.world().entities().size());
    result_.reach.resize(stage.world().entities().size());
  }

  Arrangement arrange() {
    keep_bodies();
    place_camera();
    place_ball();
    place_robots();
    place_others();
    dress();
    return std::move(result_);
  }

 private:
  Dice dice(std::string_view purpose) const { return {seed_, purpose, number_}; }
  void set_present(const Actor& actor, bool present) { result_.frame.present[actor.place] = present; }
  std::size_t first_row(const Actor& actor) const { return result_.frame.first[actor.place]; }

  Transformd pose_of(const Actor& actor, int object) const {
    const std::size_t row = first_row(actor) + static_cast<std::size_t>(object);
    return {result_.frame.position[row], result_.frame.orientation[row]};
  }

  /// Those of the scene stay where they are, with the ground that they take.
  void keep_bodies() {
    for (const Footprint& one : stage_.standing()) places_.take(one);
    for (const Actor& actor : stage_.actors()) {
      if (actor.role != Actor::Role::body) {
        set_present(actor, false);
      } else if (result_.frame.present[actor.place]) {
        places_.take(result_.frame.position[first_row(actor)], actor.reach);
        result_.reach[actor.place] = actor.reach;
      }
    }
  }

  void set_base(const Actor& actor, const Vec3d& position, const Mat3d& orientation, double reach) {
    result_.reach[actor.place] = reach;
    result_.frame.position[first_row(actor)] = position;
    result_.frame.orientation[first_row(actor)] = orientation;
    set_present(actor, true);
    complete(actor);
  }

  /// Poses of all its objects from those of base and joints.
  void complete(const Actor& actor) {
    const std::size_t first = first_row(actor), size = result_.frame.first[actor.place + 1] - first;
    multibody::poses<double>(actor.entity->model().tree(), std::span(result_.frame.joint_position).subspan(first, size),
                             std::span(result_.frame.position).subspan(first, size),
                             std::span(result_.frame.orientation).subspan(first, size));
  }

  /// Null if it has none, or with `up` only those in which it lies.
  const Posture* posture(const Actor& robot, Dice& dice, bool up) const {
    const RobotRanges& ranges = r_.robots;
    const std::array weights{ranges.standing, ranges.moving, ranges.down};
    const Postures& known = *robot.postures;
    const double draw = dice.uniform(), which = dice.uniform();
    const auto doing = drawn_doing(known, weights, draw, up ? 2 : 3);
    if (!doing) return nullptr;
    const std::vector<Posture>& some = known[*doing];
    return &some[static_cast<std::size_t>(which * static_cast<double>(some.size()))];
  }

  void put_robot(const Actor& robot, const Posture& posture, const Vec3d& place, Dice& dice) {
    const double heading = dice.in({-pi, pi});
    const std::size_t first = first_row(robot);
    MUROSIMF_ASSERT(first + posture.joints.size() == result_.frame.first[robot.place + 1]);
    std::ranges::copy(posture.joints, result_.frame.joint_position.begin() + static_cast<std::ptrdiff_t>(first));
    for (const int joint : robot.entity->model().joints()) {
      result_.frame.joint_position[first + static_cast<std::size_t>(joint)] += dice.in(r_.robots.joint_jitter);
    }
    set_base(robot, {place.x, place.y, posture.height}, rotation_z(heading) * posture.attitude, posture.reach);
  }

  /// A robot's own camera, or one anywhere that looks at a place on the field.
  void place_camera() {
    Dice dice = this->dice("camera");
    std::vector<const Actor*> with_camera;
    for (const Actor& actor : stage_.actors()) {
      if (!actor.cameras.empty()) with_camera.push_back(&actor);
    }
    const bool of_robot = dice.chance(r_.camera.of_robot);
    std::optional<Transformd> own;
    if (of_robot && !with_camera.empty()) own = own_camera(*with_camera[dice.one_of(with_camera.size())], dice);
    Transformd at = own ? *own : free_camera(dice);
    const double pan = dice.in(r_.camera.pan_deg) * deg, tilt = dice.in(r_.camera.tilt_deg) * deg;
    at.orientation =
        at.orientation * rotation_z(pan) * rotation_y(tilt) * rotation_x(dice.in(r_.camera.roll_deg) * deg);
    result_.motion = {.position = at.position,
                      .orientation = at.orientation,
                      .velocity = {},
                      .angular_velocity = turning(dice, at.orientation)};
    looker_ = {&lens_, at.position, at.orientation * sensors::optical_axes};
  }

  /// [rad/s] Mostly about the vertical, as heads turn.
  Vec3d turning(Dice& dice, const Mat3d& axes) const {
    const double rate = dice.in(r_.sensor.turning), angle = dice.in({0, 2 * pi});
    return axes * Vec3d{0, 0.5 * rate * std::sin(angle), rate * std::cos(angle)};
  }

  /// Nothing if the robot has no posture on its feet, or finds no place.
  std::optional<Transformd> own_camera(const Actor& robot, Dice& dice) {
    const Posture* posture = this->posture(robot, dice, true);
    const auto place = posture ? places_.on_field(dice, posture->reach) : std::nullopt;
    if (!place) return std::nullopt;
    put_robot(robot, *posture, *place, dice);
    camera_robot_ = &robot;
    const sensors::CameraFrame& camera = *robot.cameras[dice.one_of(robot.cameras.size())];
    const sensors::CameraInfo& info = *camera.info;
    result_.camera = robot.entity->name() + "." + info.name;
    const Transformd link = pose_of(robot, info.link);
    return Transformd{link.position + link.orientation * info.position,
                      link.orientation * info.orientation * transpose(sensors::optical_axes)};
  }

  Transformd free_camera(Dice& dice) {
    const scene_file::FieldSize& field = stage_.field();
    const double margin = r_.camera.margin;
    const double x = dice.in({-0.5, 0.5}) * (field.length + 2 * margin);
    const double y = dice.in({-0.5, 0.5}) * (field.width + 2 * margin);
    const Vec3d eye{x, y, dice.in(r_.camera.height)};
    const double to_x = dice.in({-0.5, 0.5}) * field.length, to_y = dice.in({-0.5, 0.5}) * field.width;
    const Vec3d way = Vec3d{to_x, to_y, 0.1} - eye;
    places_.take(eye, camera_reach);
    return {eye, rotation_z(std::atan2(way.y, way.x)) * rotation_y(std::atan2(-way.z, std::hypot(way.x, way.y)))};
  }

  void place_ball() {
    const auto ball = std::ranges::find(stage_.actors(), Actor::Role::ball, &Actor::role);
    if (ball == stage_.actors().end()) return;
    Dice dice = this->dice("ball");
    if (!dice.chance(r_.ball.present)) return;
    const bool flies = dice.chance(r_.ball.in_air);
    const double height = ball->height + (flies ? dice.in(r_.ball.height) : 0);
    std::optional<Vec3d> place;
    if (dice.chance(r_.ball.in_view)) place = places_.in_view(dice, ball->reach, looker_, r_.ball.distance, height);
    if (!place) place = places_.on_field(dice, ball->reach);
    if (!place) return;
    const Mat3d turned =
        rotation_z(dice.in({-pi, pi})) * rotation_y(std::acos(dice.in({-1, 1}))) * rotation_z(dice.in({-pi, pi}));
    set_base(*ball, {place->x, place->y, height}, turned, ball->reach);
  }

  void place_robots() {
    for (const Actor& actor : stage_.actors()) {
      if (actor.role != Actor::Role::robot || &actor == camera_robot_) continue;
      Dice dice = this->dice("robot/" + actor.entity->name());
      if (!dice.chance(r_.robots.present)) continue;
      const Posture* posture = this->posture(actor, dice, false);
      if (!posture) continue;
      std::optional<Vec3d> place;
      if (dice.chance(r_.robots.in_view)) {
        place = places_.in_view(dice, posture->reach, looker_, r_.robots.distance, posture->height);
      }
      if (!place) place = places_.on_field(dice, posture->reach);
      if (place) put_robot(actor, *posture, *place, dice);
    }
  }

  void place_others() {
    for (const Actor& actor : stage_.actors()) {
      const bool person = actor.role == Actor::Role::person;
      if (!person && actor.role != Actor::Role::thing) continue;
      Dice dice = this->dice("other/" + actor.entity->name());
      if (!dice.chance(person ? r_.people.present : r_.people.thing_present)) continue;
      const bool on_field = dice.chance(r_.people.on_field) && person;
      const Looker* looker = dice.chance(r_.people.in_view) ? &looker_ : nullptr;
      const double heading = dice.in({-pi, pi}), reach = beyond_lines();
      std::optional<Vec3d> place;
      if (on_field && looker) place = places_.in_view(dice, actor.reach, looker_, {0.7, 6}, 0.5);
      if (on_field && !place) place = places_.on_field(dice, actor.reach);
      if (!on_field) place = places_.around(dice, actor.reach, reach, looker);
      if (!on_field && !place) place = places_.around(dice, actor.reach, reach, nullptr);
      if (place) set_base(actor, {place->x, place->y, actor.height}, rotation_z(heading), actor.reach);
    }
  }

  /// [m] Up to where people stand: inside of the nearest walls.
  double beyond_lines() const { return stage_.field().border + r_.light.wall_distance.low; }

  void dress() {
    Dice dice = this->dice("colors");
    std::vector<std::optional<Color>> teams;
    for (std::size_t i = 0; i < stage_.scene().spec().teams.size(); ++i) {
      const Color color = any_color(dice, {0.5, 1}, {0.3, 1});
      teams.emplace_back(dice.chance(r_.robots.team_colors) ? std::optional(color) : std::nullopt);
    }
    for (const Actor& actor : stage_.actors()) {
      std::optional<Color>& color = result_.colors[actor.place];
      const Color any = any_color(dice, {0, 0.9}, {0.08, 0.95});
      if (actor.role == Actor::Role::person || actor.role == Actor::Role::thing) color = any;
      if (actor.role == Actor::Role::robot && actor.team >= 0) color = teams[static_cast<std::size_t>(actor.team)];
      if (actor.role == Actor::Role::ball) color = ball_color();
    }
    result_.panels = dice.chance(r_.ball.panels);
  }

  Color ball_color() const {
    Dice dice = this->dice("ball color");
    const Color one = r_.ball.colors[dice.one_of(r_.ball.colors.size())];
    return dice.chance(r_.ball.any_color) ? any_color(dice, {0, 1}, {0.3, 1}) : one;
  }

  const Stage& stage_;
  const Randomisation& r_;
  const imaging::Lens& lens_;
  std::uint64_t seed_, number_;
  Places places_;
  Arrangement result_;
  Looker looker_;
  const Actor* camera_robot_ = nullptr;
};

}  // namespace

Arrangement arrange(const Stage& stage, const Randomisation& randomisation, const imaging::Lens& lens,
                    std::uint64_t seed, std::uint64_t number) {
  return Arranger(stage, randomisation, lens, seed, number).arrange();
}

}  // namespace murosimf::dataset

/// stage.h - actors of the pictures: the scene of the data set with people and things added, and its classes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/dataset/field_points.h"
#include "murosimf/dataset/ground_reach.h"
#include "murosimf/dataset/posture_bank.h"
#include "murosimf/dataset/randomisation.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/scene_file/field.h"
#include "murosimf/sensors/camera_frame.h"

namespace murosimf::dataset {

/// Numbers of classes: of pixels in masks, and of COCO's categories. Robots of further models follow.
enum Class : std::uint16_t {
  class_nothing = 0,
  class_ball = 1,
  class_robot = 2,
  class_goal = 3,
  class_person = 4,
  class_thing = 5,
  class_ground = 6,
  class_line = 7,
  class_next = 8
};

struct Category {
  std::uint16_t number = 0;
  std::string name;                    ///< "ball", "robot", "robot_kid21"
  std::vector<std::string> keypoints;  ///< names
};

/// An entity that may be placed, in the order of labels.
struct Actor {
  enum class Role { ball, robot, person, thing, body };
  const Entity* entity = nullptr;
  std::size_t place = 0;    ///< among the entities of the world
  std::uint16_t label = 0;  ///< sensors/view_source.h
  Role role = Role::body;
  std::uint16_t category = class_thing;
  double height = 0;                   ///< [m] of the base when it stands on the ground; of a ball its radius
  double reach = 0;                    ///< [m] radius that it takes on the ground; of a robot its Posture has it
  const Postures* postures = nullptr;  ///< of a robot
  int team = -1;                       ///< of a robot: number in the scene's teams
  std::vector<const sensors::CameraFrame*> cameras;  ///< that it carries
};

class Stage {
 public:
  /// Throws SetupError.
  Stage(const std::filesystem::path& name, const scene::SceneOptions& options, const Randomisation& randomisation);

  [[nodiscard]] scene::Scene& scene() const { return *scene_; }
  [[nodiscard]] const World& world() const { return scene_->simulation().world(); }
  [[nodiscard]] const std::vector<Actor>& actors() const { return actors_; }
  [[nodiscard]] const std::vector<Category>& categories() const { return categories_; }
  [[nodiscard]] const PoseFrame& at_start() const { return at_start_; }
  [[nodiscard]] const std::vector<FieldPoint>& crossings() const { return crossings_; }
  [[nodiscard]] const std::vector<GoalPoints>& goals() const { return goals_; }
  /// Ground that static bodies of the scene take.
  [[nodiscard]] const std::vector<Footprint>& standing() const { return standing_; }
  [[nodiscard]] const PostureBank& postures() const { return *postures_; }
  [[nodiscard]] const Markings& markings() const { return *markings_; }
  [[nodiscard]] const scene_file::FieldSize& field() const { return *field_; }

 private:
  void add_standing();
  void add_actors();
  [[nodiscard]] Actor actor_of(const Entity& entity, std::size_t number) const;
  void complete_robot(Actor& robot, const scene_file::RobotSpec& spec) const;
  void name_categories();

  std::unique_ptr<PostureBank> postures_;
  std::unique_ptr<scene::Scene> scene_;
  std::vector<Actor> actors_;
  std::vector<Category> categories_;
  PoseFrame at_start_;
  const Markings* markings_ = nullptr;
  const scene_file::FieldSize* field_ = nullptr;
  std::vector<FieldPoint> crossings_;
  std::vector<GoalPoints> goals_;
  std::vector<Footprint> standing_;
};

}  // namespace murosimf::dataset

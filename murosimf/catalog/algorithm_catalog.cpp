#include "murosimf/catalog/algorithm_catalog.h"

#include <algorithm>
#include <cmath>

#include "murosimf/catalog/controller_options.h"
#include "murosimf/catalog/physics_options.h"
#include "murosimf/collision/body_carry_law.h"
#include "murosimf/collision/body_island_law.h"
#include "murosimf/collision/body_kelvin_voigt_law.h"
#include "murosimf/collision/body_paper_law.h"
#include "murosimf/collision/implicit_stick_law.h"
#include "murosimf/collision/kelvin_voigt_law.h"
#include "murosimf/collision/paper_law.h"
#include "murosimf/connect/controller_task.h"
#include "murosimf/connect/library_software.h"
#include "murosimf/connect/trajectory_file.h"
#include "murosimf/connect/trajectory_player.h"
#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/keyframe_player.h"
#include "murosimf/locomotion/trot.h"
#include "murosimf/locomotion/walk_engine.h"
#include "murosimf/motion/articulated_dynamics.h"
#include "murosimf/motion/full_dynamics.h"
#include "murosimf/motion/kinematic_walking.h"
#include "murosimf/sensors/ground_truth.h"

namespace murosimf::catalog {
namespace {

/// With the level's own options in their places.
LevelOptions with_own(const OptionTable<LevelOptions>& table, LevelOptions options) {
  table.apply(options.own, options);
  return options;
}

std::unique_ptr<MotionLevel> make_kinematic_walking(Setup& setup, const LevelOptions& given) {
  return std::make_unique<motion::KinematicWalking>(setup, with_own(reference_options(), given).reference);
}

std::unique_ptr<MotionLevel> make_simplified_dynamics(Setup& setup, const LevelOptions& given) {
  const LevelOptions options = with_own(reference_options(), given);
  return std::make_unique<motion::SimplifiedDynamics>(
      setup, motion::SimplifiedDynamicsOptions{.integrator = options.tree.integrator,
                                               .base_rigid = options.base_rigid,
                                               .reference = options.reference});
}

std::unique_ptr<MotionLevel> make_full_dynamics(Setup& setup, const LevelOptions& given) {
  const LevelOptions options = with_own(reference_and_tree_options(), given);
  return std::make_unique<motion::FullDynamics>(setup, motion::FullDynamicsOptions{.reference = options.reference,
                                                                                   .tree = options.tree});
}

std::unique_ptr<MotionLevel> make_articulated_dynamics(Setup& setup, const LevelOptions& given) {
  const LevelOptions options = with_own(tree_options(), given);
  return std::make_unique<motion::ArticulatedDynamics>(setup, options.tree, options.servo_law);
}

/// [Hz] What the robot's file says, or else what a controller of type C wants.
template <class C>
double rate_of(const ControllerOptions& options) {
  return options.rate > 0 ? options.rate : C::rate_hz;
}

void attach_none(Simulation&, Entity&, const ControllerOptions&) {}

void attach_walk(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, rate_of<locomotion::WalkEngine>(options),
                                            options.command);
}

void attach_balance(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  locomotion::AnkleStrategyOptions strategy;
  balance_options().apply(options.own, strategy);
  simulation.attach<locomotion::AnkleStrategy>("ankle_strategy", robot, rate_of<locomotion::AnkleStrategy>(options),
                                               strategy);
}

void attach_keyframes(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  if (!options.motion) throw SetupError("controller 'keyframes' needs a motion: motion = \"get_up_front\"");
  simulation.attach<locomotion::KeyframePlayer>("keyframe_player", robot, rate_of<locomotion::KeyframePlayer>(options),
                                                *options.motion);
}

void attach_trajectory(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  connect::TrajectoryOptions played;
  trajectory_options().apply(options.own, played);
  if (played.file.empty()) {
    throw SetupError("controller 'trajectory' needs the name of a file: options = {file = \"gait.csv\"}");
  }
  const connect::LogColumns columns{.property = played.property,
                                    .entity = played.entity.empty() ? robot.name() : played.entity};
  const connect::JointTrajectory trajectory =
      connect::read_trajectory(files::find_data_file(played.file, "motions", ".csv", options.folder), robot.model(),
                               columns);
  const double rate = options.rate > 0 ? options.rate : connect::own_rate(trajectory);
  simulation.attach<connect::TrajectoryPlayer>("trajectory_player", robot, rate, trajectory, played);
}

void attach_library(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  if (options.library.empty()) {
    throw SetupError("controller 'library' needs the name of a file: library = \"build/libwalk.so\"");
  }
  const std::filesystem::path file = files::find_data_file(options.library, "libraries", ".so", options.folder);
  const auto library = connect::ControllerLibrary::load(file);
  const connect::LibraryOptions given{.file = file,
                                      .options = options.own,
                                      .seed = options.seed,
                                      .budget = from_seconds(options.call_budget),
                                      .reload = options.reload};
  Entity& common = simulation.world().common();
  const connect::SoftwareMaker make = [&](Setup& setup, connect::RobotPort& port, const connect::SayLine& say) {
    connect::one_after_the_other(setup, common, *library);
    return std::make_unique<connect::LibrarySoftware>(setup, port, say, library, given);
  };
  constexpr double usual_rate = 100;
  const double wanted = library->functions().rate > 0 ? library->functions().rate : usual_rate;
  const auto& task = simulation.attach<connect::ControllerTask>(
      "control_software", robot, options.rate > 0 ? options.rate : wanted, make,
      connect::ControllerTaskOptions{.software = file.string(), .budget = given.budget, .crashes = options.crashes});
  if (task.port().walks()) {
    simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
  }
}

void attach_drive(Simulation& simulation, Entity& car, const ControllerOptions& options) {
  locomotion::DriveOptions drive;
  drive_options().apply(options.own, drive);
  simulation.attach<locomotion::Drive>("drive", car, rate_of<locomotion::Drive>(options), options.command, drive);
}

void attach_trot(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  simulation.attach<locomotion::Trot>("trot", robot, rate_of<locomotion::Trot>(options), options.command);
}

void attach_ball_chaser(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  using behavior::BallChaser;
  behavior::BallChaserOptions chaser{.goal = {options.attacks * options.half_field.x, 0, 0},
                                     .half_field = options.half_field};
  ball_chaser_options().apply(options.own, chaser);
  if (!sensors::find_reading(robot, "ground_truth")) {
    const sensors::SensorSpec truth{.name = "ground_truth",
                                    .type = "ground_truth",
                                    .rate = rate_of<BallChaser>(options)};
    simulation.attach<sensors::GroundTruth>("ground_truth", robot, rate_of<BallChaser>(options), truth,
                                            sensors::SensorSurroundings{.moving_entities = options.everybody});
  }
  simulation.attach<BallChaser>("ball_chaser", robot, rate_of<BallChaser>(options), chaser);
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

void attach_localize(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  const double x = 0.5 * options.half_field.x, y = 0.45 * options.half_field.y;
  behavior::LocalizeOptions localize{.markings = options.markings,
                                     .start = options.start,
                                     .way = {{0, -y, 0}, {x, 0, 0}, {0, y, 0}, {-x, 0, 0}},
                                     .seed = options.seed};
  localize_options().apply(options.own, localize);
  simulation.attach<behavior::Localize>("localize", robot, rate_of<behavior::Localize>(options), localize);
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

void attach_obstacle_course(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  using behavior::ObstacleCourse;
  behavior::ObstacleCourseOptions course{.start = options.start,
                                         .goal_x = options.attacks * options.half_field.x,
                                         .half_width = options.half_field.y};
  obstacle_course_options().apply(options.own, course);
  simulation.attach<ObstacleCourse>("obstacle_course", robot, rate_of<ObstacleCourse>(options), course);
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

Vec3d clipped_command(const Vec3d& v, const Vec3d& fastest) {
  const auto clip = [](double x, double limit) { return std::clamp(x, -limit, limit); };
  return {clip(v.x, fastest.x), clip(v.y, fastest.y), clip(v.z, fastest.z)};
}

Vec3d walks_at(const Model& model, const Vec3d& command) {
  return clipped_command(command, locomotion::seeded_parameters(locomotion::find_legs(model)).fastest);
}

Vec3d trots_at(const Model& model, const Vec3d& command) {
  return clipped_command(command, locomotion::seeded_trot(model, locomotion::find_four_legs(model)).fastest);
}

Vec3d drives_at(const Model& model, const Vec3d& command) {
  const locomotion::Vehicle car = locomotion::find_vehicle(model);
  if (std::abs(command.x) < 1e-3) return {command.x, 0, 0};  // a car does not turn on the spot
  const double curvature = std::clamp(command.z / command.x, car.least_curvature, car.greatest_curvature);
  return {command.x, 0, command.x * curvature};
}

template <class Law>
std::shared_ptr<const collision::ContactLaw> make_law(const OptionValues&) {
  return std::make_shared<Law>();
}

std::shared_ptr<const collision::ContactLaw> make_paper(const OptionValues& given) {
  collision::PaperLawOptions options;
  paper_law_options().apply(given, options);
  return std::make_shared<collision::PaperLaw>(options);
}

std::shared_ptr<const collision::ContactLaw> make_paper_multipoint(const OptionValues& given) {
  collision::PaperLawOptions options{.one_point_per_body = false};
  paper_law_options().apply(given, options);
  return std::make_shared<collision::PaperLaw>(options);
}

constexpr LongestSteps bounded_steps{0.01, 0.01}, literal_steps{0.002, 0.001};

LongestSteps paper_steps(const OptionValues& given) {
  collision::PaperLawOptions options;
  paper_law_options().apply(values_among(paper_law_options().infos(), given), options);
  return options.bounded ? bounded_steps : literal_steps;
}

// Keys: what stands in a scene file; "position.z" is the height in `position`.
std::vector<LevelType> built_in_levels() {
  return {
      LevelType{"kinematic_walking", "the standing foot is fixed on the plane; cannot fall, ignores forces (paper 4.1)",
                motion::KinematicWalking::has, "joint_reference",
                "stance_pose stance_foot remaining_shift remaining_turn", make_kinematic_walking,
                reference_options().infos()},
      LevelType{"simplified_dynamics", "the robot as one rigid body under gravity and contact (paper 4.2)",
                motion::SimplifiedDynamics::has,
                "joint_reference base_rigid integrator contact position.z roll_deg pitch_deg",
                "applied_force linear_velocity angular_velocity base_quaternion", make_simplified_dynamics,
                reference_options().infos()},
      LevelType{"full_dynamics", "every link has its mass; joints move exactly as told (paper 4.3)",
                motion::FullDynamics::has,
                "joint_reference fixed_base integrator contact position.z roll_deg pitch_deg",
                "applied_force linear_velocity angular_velocity base_quaternion", make_full_dynamics,
                reference_and_tree_options().infos()},
      LevelType{"articulated_dynamics", "servos make torque, the whole tree moves as it must",
                motion::ArticulatedDynamics::has,
                "fixed_base integrator servo_law contact position.z roll_deg pitch_deg self_collision",
                "applied_force linear_velocity angular_velocity base_quaternion "
                "supply_voltage torque_enabled servo_temperature backlash_play backlash_side "
                "rotor_rate",
                make_articulated_dynamics, tree_options().infos()},
  };
}

std::vector<ContactLawType> built_in_contacts() {
  return {
      ContactLawType{"implicit_stick",
                     "compliant, implicit, with a tangential spring that sticks; the default",
                     make_law<collision::ImplicitStick>,
                     {0.01, 0.01}},
      ContactLawType{"island_gauss_seidel",
                     "the same force, settled together with all contacts of what is touched",
                     make_law<collision::IslandGaussSeidel>,
                     {0.01, 0.01}},
      ContactLawType{"kelvin_voigt",
                     "spring, damper and a tangential spring that sticks; explicit, for steps of 1 ms",
                     make_law<collision::KelvinVoigt>,
                     {0.002, 0.001}},
      ContactLawType{"paper", "one point per body, spring and viscous friction (paper 5.3, eq. 4 and 5)", make_paper,
                     bounded_steps, paper_law_options().infos(), paper_steps},
      ContactLawType{"paper_multipoint", "the same spring and viscous friction at every point", make_paper_multipoint,
                     bounded_steps, paper_law_options().infos(), paper_steps},
  };
}

template <class Law>
std::unique_ptr<collision::BodyContactLaw> make_body_law(const OptionValues&) {
  return std::make_unique<Law>();
}

std::unique_ptr<collision::BodyContactLaw> make_body_island(const OptionValues& given) {
  collision::BodyIslandOptions options;
  body_island_options().apply(given, options);
  return std::make_unique<collision::BodyIslandLaw>(options);
}

std::unique_ptr<collision::BodyContactLaw> make_body_paper(const OptionValues& given) {
  collision::PaperLawOptions options;
  paper_law_options().apply(given, options);
  return std::make_unique<collision::BodyPaperLaw>(options);
}

std::unique_ptr<collision::BodyContactLaw> make_body_paper_multipoint(const OptionValues& given) {
  collision::PaperLawOptions options{.one_point_per_body = false};
  paper_law_options().apply(given, options);
  return std::make_unique<collision::BodyPaperLaw>(options);
}

std::vector<BodyContactLawType> built_in_body_contacts() {
  return {
      BodyContactLawType{"island_gauss_seidel", "all contacts of touching entities settled together; the default",
                         make_body_island, body_island_options().infos()},
      BodyContactLawType{"carry", "either body implicit by itself, the difference given back later; up to 2 ms",
                         make_body_law<collision::BodyCarryLaw>},
      BodyContactLawType{"kelvin_voigt", "explicit spring, damper and viscous friction; 1 ms",
                         make_body_law<collision::BodyKelvinVoigtLaw>},
      BodyContactLawType{"paper", "spring and viscous friction at one point of two bodies (paper 5.3); 1 ms",
                         make_body_paper, paper_law_options().infos()},
      BodyContactLawType{"paper_multipoint", "the same spring and viscous friction at every point; 1 ms",
                         make_body_paper_multipoint, paper_law_options().infos()},
  };
}

std::vector<ControllerType> built_in_controllers() {
  return {
      ControllerType{"none", "joints stay where they are put", "posture", attach_none},
      ControllerType{"walk", "walks with the velocity in walk_command", "command", attach_walk, {}, false, walks_at},
      ControllerType{
          "trot", "trots on four legs with the velocity in walk_command", "command", attach_trot, {}, false, trots_at},
      ControllerType{"balance", "stands and answers pushes with its ankles, from the sensor 'imu'", "", attach_balance,
                     balance_options().infos()},
      ControllerType{"keyframes", "plays the key frames of a motion once", "motion", attach_keyframes},
      ControllerType{"trajectory",
                     "plays joint angles from a table over time (CSV), a team's own or a log of this program", "",
                     attach_trajectory, trajectory_options().infos()},
      ControllerType{"library",
                     "control software of one's own in a shared library (murosimf_controller.h)",
                     "library",
                     attach_library,
                     {},
                     true},
      ControllerType{"drive", "drives a car with the speed and turning rate in walk_command", "command", attach_drive,
                     drive_options().infos(), false, drives_at},
      ControllerType{"ball_chaser", "turns to the ball, walks to it and pushes it to the goal, from ground truth", "",
                     attach_ball_chaser, ball_chaser_options().infos()},
      ControllerType{"localize", "walks a round on the field and finds out from its camera where it is", "",
                     attach_localize, localize_options().infos()},
      ControllerType{"obstacle_course", "crosses the field without touching magenta poles that its camera sees", "",
                     attach_obstacle_course, obstacle_course_options().infos()},
  };
}

}  // namespace

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (words.substr(begin, end - begin) == word) return true;
    begin = end + 1;
  }
  return false;
}

Registries& registries() {
  static Registry<LevelType> levels("level", built_in_levels());
  static Registry<ContactLawType> contacts("contact law", built_in_contacts());
  static Registry<BodyContactLawType> body_contacts("law of contact between bodies", built_in_body_contacts());
  static Registry<ControllerType> controllers("controller", built_in_controllers());
  static Registry<CommandType> commands("command");
  static Registries all{
      levels,  contacts, body_contacts, controllers, components::sensor_registry(), robot::robot_format_registry(),
      commands};
  return all;
}

const Registry<LevelType>& levels() { return registries().levels; }
const Registry<ContactLawType>& contacts() { return registries().contacts; }
const Registry<BodyContactLawType>& body_contacts() { return registries().body_contacts; }
const Registry<ControllerType>& controllers() { return registries().controllers; }

std::unique_ptr<MotionLevel> make_level(std::string_view name, Setup& setup, const LevelOptions& options) {
  const LevelType& type = levels().find(name);
  LevelOptions known = options;
  known.own = values_among(type.options, options.own);
  return type.make(setup, known);
}

std::shared_ptr<const collision::ContactLaw> make_contact_law(std::string_view name, const OptionValues& given) {
  const ContactLawType& type = contacts().find(name);
  return type.make(values_among(type.options, given));
}

std::unique_ptr<collision::BodyContactLaw> make_body_contact_law(std::string_view name, const OptionValues& given) {
  const BodyContactLawType& type = body_contacts().find(name);
  return type.make(values_among(type.options, given));
}

}  // namespace murosimf::catalog

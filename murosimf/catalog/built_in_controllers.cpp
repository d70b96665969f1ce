#include "murosimf/catalog/built_in_controllers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "murosimf/catalog/controller_options.h"
#include "murosimf/control_software/command_arrival.h"
#include "murosimf/control_software/controller_task.h"
#include "murosimf/control_software/library_software.h"
#include "murosimf/control_software/python/python_software.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/control_software/trajectory_file.h"
#include "murosimf/control_software/trajectory_player.h"
#include "murosimf/dds/booster/booster_software.h"
#include "murosimf/dds/ros2/ros_software.h"
#include "murosimf/dds/unitree/unitree_software.h"
#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/keyframe_player.h"
#include "murosimf/locomotion/motion_engine.h"
#include "murosimf/locomotion/trot.h"
#include "murosimf/locomotion/walk_engine.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot/step_table_file.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/sensors/ground_truth.h"
#include "murosimf/sensors/inertial.h"
#include "murosimf/sensors/joint_sensors.h"
#include "murosimf/serial/serial_software.h"

namespace murosimf::catalog {
namespace {

/// [Hz] Rate from the robot's file, or else the usual rate of a controller of type C.
template <class C>
double rate_of(const ControllerOptions& options) {
  return options.rate > 0 ? options.rate : C::rate_hz;
}

Vec3d clipped_command(const Vec3d& v, const Vec3d& fastest) {
  MUROSIMF_ASSERT(fastest.x >= 0 && fastest.y >= 0 && fastest.z >= 0);
  const auto clip = [](double x, double limit) { return std::clamp(x, -limit, limit); };
  return {clip(v.x, fastest.x), clip(v.y, fastest.y), clip(v.z, fastest.z)};
}

void attach_none(Simulation&, Entity&, const ControllerOptions&) {}

/// Attaches an ideal inertial sensor or ideal encoders to a robot without them.
void attach_missing_senses(Simulation& simulation, Entity& robot) {
  constexpr double rate = 200;  // [Hz]
  const auto has = [&](auto matches) { return std::ranges::any_of(sensors::readings_of(robot), matches); };
  const sensors::SensorSurroundings nothing;
  if (!sensors::find_reading(robot, "imu"))
    simulation.attach<sensors::Imu>("imu", robot, rate, sensors::SensorSpec{.name = "imu", .type = "imu"}, nothing);
  if (!has([](const sensors::Reading* reading) { return reading->info->type == "joint_position"; })) {
    const sensors::SensorSpec encoders{.name = "encoders", .type = "joint_position"};
    simulation.attach<sensors::JointPosition>("encoders", robot, rate, encoders, nothing);
  }
}

void attach_motion_engine(Simulation& simulation, Entity& robot, double rate, const Vec3d& command,
                          const locomotion::MotionEngineOptions& options) {
  attach_missing_senses(simulation, robot);
  simulation.attach<locomotion::MotionEngine>("motion_engine", robot, rate, command, options);
}

locomotion::WalkParameters walk_of(const Model& model, const OptionValues& options) {
  return options.empty() ? locomotion::seeded_parameters(model) : locomotion::walk_parameters(model, options);
}

void attach_walk(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, rate_of<locomotion::WalkEngine>(options),
                                            options.command, walk_of(robot.model(), options.own));
}

std::vector<OptionInfo> motions_options() {
  std::vector<OptionInfo> options = locomotion::balanced_walk_options();
  options.push_back(
      {"steps", std::string(), "", "table of the steady walk (CSV), instead of the model's; none: no feedback"});
  return options;
}

/// A file of steps is read here, so that the engine needs no files.
void attach_motions(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  locomotion::MotionEngineOptions engine = locomotion::motion_engine_options(robot.model(), options.own);
  if (const auto steps = options.own.find("steps"); steps != options.own.end()) {
    const std::string& file = std::get<std::string>(steps->second);
    engine.steps = file == "none"
                       ? nullptr
                       : robot::read_step_table(files::find_data_file(file, "models", ".csv", options.folder));
  }
  attach_motion_engine(simulation, robot, rate_of<locomotion::MotionEngine>(options), options.command, engine);
}

Vec3d engine_walks_at(const Model& model, const OptionValues& options, const Vec3d& command) {
  return clipped_command(command, locomotion::balanced_walk(model, options).fastest);
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
  control_software::TrajectoryOptions played;
  trajectory_options().apply(options.own, played);
  if (played.file.empty()) {
    throw SetupError("controller 'trajectory' needs the name of a file: options = {file = \"gait.csv\"}");
  }
  const control_software::LogColumns columns{.property = played.property,
                                             .entity = played.entity.empty() ? robot.name() : played.entity,
                                             .no_other = !played.entity.empty()};
  // a log has columns of many entities; a table of a team has only joints
  const control_software::JointTrajectory trajectory =
      control_software::read_trajectory(files::find_data_file(played.file, "motions", ".csv", options.folder),
                                        robot.model(), columns);
  const double rate = options.rate > 0 ? options.rate : control_software::own_rate(trajectory);
  simulation.attach<control_software::TrajectoryPlayer>("trajectory_player", robot, rate, trajectory, played);
}

double usual_rate(double of_scene, double wanted) {
  constexpr double otherwise = 100;  // [Hz]
  if (of_scene > 0) return of_scene;
  return wanted > 0 ? wanted : otherwise;
}

/// Also attaches the walk engine, which moves the legs, or the motion engine, which moves all joints, if the software has requested it.
void attach_software(Simulation& simulation, Entity& robot, double rate, const control_software::SoftwareMaker& make,
                     control_software::ControllerTaskOptions options, const ControllerOptions& given) {
  options.link = given.link;
  options.seed = given.seed;
  options.memory = given.outside.memory;
  auto& task = simulation.attach<control_software::ControllerTask>("control_software", robot, rate, make, options);
  if (task.port().command_link()) {
    // the link delivers between cycles of the software, hence at every tick
    const double every_tick = 1 / seconds(simulation.tick());  // [Hz]
    simulation.attach<control_software::CommandArrival>("control_link", robot, every_tick, task.port());
  }
  if (task.port().uses_motions()) {
    attach_motion_engine(simulation, robot, locomotion::MotionEngine::rate_hz, {},
                         locomotion::motion_engine_options(robot.model(), {}));
  }
  if (!task.port().walks()) return;
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

/// Software that disconnects before it is ready makes room for other software, until the wall time for connecting has passed.
void attach_first_ready(control_software::TcpServer& server, control_software::TcpOptions options,
                        const std::function<void(const control_software::TcpOptions&)>& attach) {
  const double limit = options.wait;
  const auto end = std::chrono::steady_clock::now() + from_seconds(limit);
  for (;;) {
    try {
      return attach(options);
    } catch (const control_software::SoftwareWent& went) {
      options.wait = seconds(end - std::chrono::steady_clock::now());
      if (options.wait <= 0) throw;
      server.tell(fmt::format("{}; waiting for other software", went.what()));
    }
  }
}

void attach_tcp(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  const ExternalInputOptions& outside = options.outside;
  if (!options.software && !outside.repeated) {
    throw SetupError("controller 'tcp': no software can come; say where: murosimf run --listen PORT");
  }
  control_software::TcpOptions given;
  tcp_options().apply(options.own, given);
  ExternalInputLog::Channel* const channel = outside.channel("tcp:" + robot.name());
  const ExternalInputRecorder pen(channel);
  const auto attach = [&](const control_software::ArrivedSoftware& arrived) {
    attach_software(simulation, robot, usual_rate(options.rate, arrived.rate), arrived.make,
                    {.software = arrived.name, .budget = from_seconds(options.call_budget)}, options);
  };
  if (outside.repeated)
    return attach(control_software::repeat_software(outside.repeated, robot.name(), given, options.seed, pen));
  attach_first_ready(*options.software, given, [&](const control_software::TcpOptions& left) {
    if (channel) channel->clear();  // input of software that was not ready is not part of the run
    attach(options.software->wait_for(robot.name(), left, options.seed, pen));
  });
}

/// The library is looked for beside the scene, then in the usual folders.
void attach_library(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  if (options.library.empty()) {
    throw SetupError("controller 'library' needs the name of a file: library = \"build/libwalk.so\"");
  }
  const std::filesystem::path file = files::find_data_file(options.library, "libraries", ".so", options.folder);
  const auto library = control_software::ControllerLibrary::load(file);
  const control_software::LibraryOptions given{.file = file,
                                               .options = options.own,
                                               .seed = options.seed,
                                               .budget = from_seconds(options.call_budget),
                                               .reload = options.reload};
  Entity& common = simulation.world().common();
  const control_software::SoftwareMaker make = [&](Setup& setup, control_software::RobotPort& port,
                                                   const control_software::SayLine& say) {
    control_software::one_after_the_other(setup, common, *library);
    return std::make_unique<control_software::LibrarySoftware>(setup, port, say, library, given);
  };
  attach_software(simulation, robot, usual_rate(options.rate, library->functions().rate), make,
                  {.software = file.string(), .budget = given.budget, .crashes = options.crashes}, options);
}

/// The class says itself how often it is called, and when in a step.
void attach_python(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  control_software::PythonOptions given{.folder = options.folder,
                                        .options = options.own,
                                        .seed = options.seed,
                                        .budget = from_seconds(options.call_budget)};
  if (const auto target = given.options.find("class"); target != given.options.end()) {
    if (const auto* text = std::get_if<std::string>(&target->second)) given.target = *text;
    given.options.erase(target);
  }
  control_software::PythonClass made(robot, given);
  const std::string name = made.name();
  const Phase phase = made.phase();
  const double rate = usual_rate(options.rate, made.traits().rate);
  Entity& common = simulation.world().common();
  const control_software::SoftwareMaker make = [&](Setup& setup, control_software::RobotPort& port,
                                                   const control_software::SayLine& say) {
    control_software::python_in_turns(setup, common);
    return std::make_unique<control_software::PythonSoftware>(setup, &port, say, std::move(made),
                                                              options.moving_entities);
  };
  attach_software(simulation, robot, rate, make,
                  {.software = name, .budget = given.budget, .crashes = options.crashes, .memory = {}, .phase = phase},
                  options);
}

/// Without a file of the bus, joints get ids in their order.
void attach_serial(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  serial::SerialOptions given;
  serial_options().apply(options.own, given);
  using serial::dynamixel::Protocol;
  const Protocol protocol = given.protocol < 2 ? Protocol::v1 : Protocol::v2;
  const Model& model = robot.model();
  const std::vector<serial::ServoPlace> layout =
      given.bus.empty()
          ? serial::usual_layout(model, protocol)
          : serial::read_layout(files::find_data_file(given.bus, "buses", ".csv", options.folder), model, protocol);
  const control_software::SoftwareMaker make = [&](Setup& setup, control_software::RobotPort& port,
                                                   const control_software::SayLine& say) {
    return std::make_unique<serial::SerialSoftware>(setup, port, say, layout, given, options.terminals,
                                                    options.outside);
  };
  attach_software(simulation, robot, rate_of<serial::SerialSoftware>(options), make, {.software = "serial line"},
                  options);
}

/// A robot's own domain opens nothing by itself: only the command line does.
void attach_booster(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  using dds::booster::BoosterSoftware;
  dds::booster::BoosterOptions given;
  booster_options().apply(options.own, given);
  std::optional<int> domain = options.dds_domain;
  if (domain && given.domain >= 0) domain = given.domain;
  attach_missing_senses(simulation, robot);
  const control_software::SoftwareMaker make = [&](Setup& setup, control_software::RobotPort& port,
                                                   const control_software::SayLine& say) {
    return std::make_unique<BoosterSoftware>(setup, port, say, given, domain, options.outside);
  };
  attach_software(simulation, robot, rate_of<BoosterSoftware>(options), make, {.software = "Booster SDK"}, options);
}

/// The same.
void attach_unitree(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  using dds::unitree::UnitreeSoftware;
  dds::unitree::UnitreeOptions given;
  unitree_options().apply(options.own, given);
  std::optional<int> domain = options.unitree_domain;
  if (domain && given.domain >= 0) domain = given.domain;
  attach_missing_senses(simulation, robot);
  const control_software::SoftwareMaker make = [&](Setup& setup, control_software::RobotPort& port,
                                                   const control_software::SayLine& say) {
    return std::make_unique<UnitreeSoftware>(setup, port, say, given, domain, options.outside);
  };
  attach_software(simulation, robot, rate_of<UnitreeSoftware>(options), make, {.software = "unitree_hg"}, options);
}

/// Only the command line lets nodes in.
void attach_ros2(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  using dds::ros2::RosSoftware;
  dds::ros2::RosOptions given;
  ros2_options().apply(options.own, given);
  if (given.walk) attach_missing_senses(simulation, robot);
  const control_software::SoftwareMaker make = [&](Setup& setup, control_software::RobotPort& port,
                                                   const control_software::SayLine& say) {
    return std::make_unique<RosSoftware>(setup, port, say, given, options.ros2_domain, options.outside);
  };
  attach_software(simulation, robot, rate_of<RosSoftware>(options), make, {.software = "ROS 2 nodes"}, options);
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
  using soccer::BallChaser;
  soccer::BallChaserOptions chaser{.goal = {options.attacks * options.half_field.x, 0, 0},
                                   .half_field = options.half_field};
  ball_chaser_options().apply(options.own, chaser);
  if (!sensors::find_reading(robot, "ground_truth")) {
    // the chaser decides from ground truth: a sensor of the same rate gives one sample per decision
    const sensors::SensorSpec truth{.name = "ground_truth",
                                    .type = "ground_truth",
                                    .rate = rate_of<BallChaser>(options)};
    simulation.attach<sensors::GroundTruth>("ground_truth", robot, rate_of<BallChaser>(options), truth,
                                            sensors::SensorSurroundings{.moving_entities = options.moving_entities});
  }
  simulation.attach<BallChaser>("ball_chaser", robot, rate_of<BallChaser>(options), chaser);
  if (chaser.kicks) {
    return attach_motion_engine(simulation, robot, locomotion::MotionEngine::rate_hz, {},
                                locomotion::motion_engine_options(robot.model(), {}));
  }
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

void attach_localize(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  const double x = 0.5 * options.half_field.x, y = 0.45 * options.half_field.y;
  // a round through the middles of the field's halves: every line is seen from near once
  soccer::LocalizeOptions localize{.markings = options.markings,
                                   .start = options.start,
                                   .way = {{0, -y, 0}, {x, 0, 0}, {0, y, 0}, {-x, 0, 0}},
                                   .seed = options.seed};
  localize_options().apply(options.own, localize);
  simulation.attach<soccer::Localize>("localize", robot, rate_of<soccer::Localize>(options), localize);
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

/// The course depends on the field and on the direction in which the team attacks.
void attach_obstacle_course(Simulation& simulation, Entity& robot, const ControllerOptions& options) {
  using soccer::ObstacleCourse;
  soccer::ObstacleCourseOptions course{.start = options.start,
                                       .goal_x = options.attacks * options.half_field.x,
                                       .half_width = options.half_field.y};
  obstacle_course_options().apply(options.own, course);
  simulation.attach<ObstacleCourse>("obstacle_course", robot, rate_of<ObstacleCourse>(options), course);
  simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz);
}

Vec3d walks_at(const Model& model, const OptionValues& options, const Vec3d& command) {
  return clipped_command(command, walk_of(model, options).fastest);
}

Vec3d trots_at(const Model& model, const OptionValues&, const Vec3d& command) {
  return clipped_command(command, locomotion::seeded_trot(model, locomotion::find_four_legs(model)).fastest);
}

Vec3d drives_at(const Model& model, const OptionValues&, const Vec3d& command) {
  const locomotion::Vehicle car = locomotion::find_vehicle(model);
  if (std::abs(command.x) < 1e-3) return {command.x, 0, 0};  // a car does not turn on the spot
  const double curvature = std::clamp(command.z / command.x, car.least_curvature, car.greatest_curvature);
  return {command.x, 0, command.x * curvature};
}

}  // namespace

std::vector<ControllerType> built_in_controllers() {
  return {
      ControllerType{"none", "joints stay where they are put", "posture", attach_none},
      ControllerType{"walk", "walks with the velocity in walk_command", "command", attach_walk,
                     locomotion::walk_options(), false, walks_at},
      ControllerType{
          "trot", "trots on four legs with the velocity in walk_command", "command", attach_trot, {}, false, trots_at},
      ControllerType{"motions",
                     "stands, walks with feedback, plays the robot's motions and gets up, from its own sensors",
                     "command", attach_motions, motions_options(), false, engine_walks_at},
      ControllerType{"balance", "stands and answers pushes with its ankles, from the sensor 'imu'", "", attach_balance,
                     balance_options().infos()},
      ControllerType{"keyframes", "plays the key frames of a motion once", "motion", attach_keyframes},
      ControllerType{"trajectory",
                     "plays joint angles from a table over time (CSV), a team's own or a log of this program", "",
                     attach_trajectory, trajectory_options().infos()},
      ControllerType{"library",
                     "control software of one's own in a shared library (murosimf_controller.h)",
                     "library call_budget link",
                     attach_library,
                     {},
                     true},
      ControllerType{"python",
                     "control software of one's own as a class in Python: options = {class = \"module:Class\"}",
                     "call_budget link",
                     attach_python,
                     {},
                     true},
      ControllerType{"tcp", "control software in another program, over TCP: murosimf run --listen PORT",
                     "call_budget link", attach_tcp, tcp_options().infos()},
      ControllerType{"serial", "servos and IMU on a virtual serial line that speaks the Dynamixel protocols", "link",
                     attach_serial, serial_options().infos()},
      ControllerType{"booster",
                     "programs with the SDK of the robot's vendor, Booster, over DDS: murosimf run --booster", "link",
                     attach_booster, booster_options().infos()},
      ControllerType{"unitree",
                     "low-level programs for a Unitree G1, by its vendor's messages over DDS: murosimf run --unitree",
                     "link", attach_unitree, unitree_options().infos()},
      ControllerType{"ros2", "nodes of ROS 2 on this computer, over DDS: murosimf run --ros2", "link", attach_ros2,
                     ros2_options().infos()},
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

}  // namespace murosimf::catalog

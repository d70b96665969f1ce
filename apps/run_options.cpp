#include "apps/run_options.h"

#include <algorithm>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/roboviz_arguments.h"
#include "murosimf/catalog/controller_options.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/dds/participant.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/state_file.h"

namespace murosimf::app {
namespace {

std::shared_ptr<control_software::TcpServer> server_at(const std::string& where) {
  if (where.empty()) return nullptr;
  control_software::TcpServerOptions options{.say = [](const std::string& line) { say_warning(line); },
                                             .stop = interrupted};
  try {
    options.address = network::parse_address(where);
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("--listen: {}", error.what()));
  }
  auto server = control_software::listen_for_software(std::move(options));
  say_note(fmt::format("listening on {}", to_text(server->address())));
  return server;
}

/// Robots that programs of their vendor control over DDS.
struct Vendor {
  std::string controller, option, software;
  std::string domain;  ///< of the command line; empty: none
};

template <class Options>
void check_vendor(const scene_file::SceneSpec& spec, const Vendor& vendor, const OptionTable<Options>& table) {
  std::map<std::pair<int, std::string>, std::string> taken;  // robots by domain and suffix
  for (const scene_file::RobotSpec& robot : spec.robots) {
    if (robot.controller != vendor.controller) continue;
    if (vendor.domain.empty()) {
      say_warning(fmt::format("{}: no program can reach {}; to let {} in: {}", robot.where, robot.name, vendor.software,
                              vendor.option));
      continue;
    }
    Options options;
    table.apply(robot.options, options);
    const int own = options.domain >= 0 ? options.domain : read_domain(vendor.option, vendor.domain);
    const auto [place, fresh] = taken.try_emplace({own, options.suffix}, robot.name);
    if (fresh) continue;
    throw SetupError(fmt::format(
        "{}: {} and {} are in the same DDS domain, {}; give one another, or a suffix: options = {{suffix = \"_{}\"}}",
        robot.where, place->second, robot.name, own, robot.name));
  }
  if (!vendor.domain.empty() && taken.empty()) {
    throw SetupError(fmt::format("{}: no robot is controlled by {} (controller = \"{}\")", vendor.option,
                                 vendor.software, vendor.controller));
  }
}

}  // namespace

void define_run(const Command& command, RunOptions& options) {
  add_scene(command, options.scene);
  command.add("--duration", options.duration, "Simulated seconds, instead of the scene's");
  command.add(
      "--speed", options.speed,
      "'max', as it is without this, or simulated seconds per second: 1 is real time, as it is with --web and --ros2");
  command.add("--json", options.json, "Write the report as JSON to this file, or to standard output with '-'");
  command.add("--picture", options.picture, "Write a PNG picture of the field from above");
  add_web(command, options.web);
  const Option pictures = command.add("--pictures", options.pictures,
                                      "Write PNG pictures of the bodies to this folder while the scene runs");
  command.add("--picture-every", options.picture_every, "Simulated seconds from one picture to the next")
      .needs(pictures)
      .shows_default();
  const Option log =
      command.add("--log", options.log,
                  "Record numbers: of sensors, like 'blue1.imu.*', or properties, like 'ball.ball.position'");
  const Option out =
      command.add("--out", options.out, "Write them to this file: CSV, or an array for NumPy if it ends with .npy")
          .needs(log);
  log.one_at_a_time().needs(out);
  command.add("--log-rate", options.log_rate, "How often properties are recorded, in Hz").needs(log).shows_default();
  add_record(command, options.record);
  command.add("--from", options.from, "Go on from a state of this scene: of --save-at, --save-state or a recording");
  command.add("--save-at", options.save_at, "TIME:FILE: write the state at this time (s) to this file").one_at_a_time();
  command.add("--save-state", options.save_state, "Write the state at the end to this file");
  add_game(command, options.game);
  command.add("--listen", options.listen,
              "Take control software for robots with the controller 'tcp': PORT of this computer alone, or HOST:PORT");
  add_roboviz(command, options.roboviz);
  add_supervision(command, options.supervision).excludes(pictures);
  command.add("--serial", options.serial,
              "Folder for links to the serial lines of robots with controller = \"serial\", one for each, named as it");
  command
      .add("--booster", options.booster,
           "Let programs with the SDK of Booster, on this computer alone, control robots with controller = "
           "\"booster\"; a value: DOMAIN of DDS")
      .value_if_alone("0");
  command
      .add("--unitree", options.unitree,
           "Let low-level programs for a Unitree G1, on this computer alone, control robots with controller = "
           "\"unitree\"; a value: DOMAIN of DDS")
      .value_if_alone("0");
  add_ros2(command, options.ros2);
  add_no_cameras(command, options.no_cameras);
}

void check(const RunOptions& options) {
  if (!options.booster.empty()) (void)read_domain("--booster", options.booster);
  if (!options.unitree.empty()) (void)read_domain("--unitree", options.unitree);
  (void)speed_of(options);
  if (options.duration) (void)read_duration(*options.duration);
  check(options.record, !options.supervision.where.empty());
  check(options.web);
  check(options.ros2);
  check(options.supervision);
  if (options.no_cameras && std::ranges::find(options.record.what, "pictures") != options.record.what.end()) {
    throw SetupError("--record-what pictures: --no-cameras lets nothing be drawn for cameras");
  }
  if (is_steered(options) && !options.pictures.empty()) {
    throw SetupError(
        "--pictures are taken of runs that cannot be stopped or taken back: without --web, --supervise and --ros2");
  }
}

void check_serial(const scene_file::SceneSpec& spec, const std::string& folder) {
  const auto found = std::ranges::find(spec.robots, "serial", &scene_file::RobotSpec::controller);
  if (folder.empty() && found != spec.robots.end()) {
    throw SetupError(
        fmt::format("{}: {} has a serial line; say where programs find it: --serial DIR", found->where, found->name));
  }
  if (!folder.empty() && found == spec.robots.end()) {
    throw SetupError("--serial: no robot has a serial line (controller = \"serial\")");
  }
}

void check_vendors(const scene_file::SceneSpec& spec, const RunOptions& options) {
  check_vendor(spec, {"booster", "--booster", "programs with Booster's SDK", options.booster},
               catalog::booster_options());
  check_vendor(spec, {"unitree", "--unitree", "low-level programs of Unitree", options.unitree},
               catalog::unitree_options());
}

bool is_steered(const RunOptions& options) {
  return !options.web.web.empty() || !options.supervision.where.empty() || !options.ros2.domain.empty();
}

bool stays_at_end(const RunOptions& options) { return !options.web.web.empty() || !options.supervision.where.empty(); }

/// They keep what happens, in the order of time.
std::string no_way_back(const RunOptions& options) {
  if (!options.record.file.empty()) return "it is recorded (--record)";
  if (!options.log.empty()) return "its numbers are logged (--log)";
  if (!options.web.html.empty()) return "it is written as HTML (--html)";
  return options.game.log.empty() ? "" : "what comes from outside is written down (--game-log)";
}

std::optional<double> speed_of(const RunOptions& options) {
  const bool with_people = !options.web.web.empty() || !options.ros2.domain.empty();
  if (options.speed.empty()) return with_people ? std::optional(1.0) : std::nullopt;
  return read_speed(options.speed);
}

scene::SceneOptions scene_options_of(const RunOptions& options) {
  scene::SceneOptions all = options_of(options.scene);
  all.cameras = !options.no_cameras;
  all.paths = !options.picture.empty();
  all.terminals = options.serial;
  if (!options.ros2.domain.empty()) all.ros2_domain = read_domain("--ros2", options.ros2.domain);
  if (!options.booster.empty()) all.dds_domain = read_domain("--booster", options.booster);
  if (!options.unitree.empty()) all.unitree_domain = read_domain("--unitree", options.unitree);
  all.pushable = is_steered(options);
  if (!options.from.empty()) all.pushable = recording::was_pushable(options.from).value_or(all.pushable);
  all.software = server_at(options.listen);
  if (!options.record.file.empty()) all.outside.notes = std::make_shared<ExternalInputLog>();
  return all;
}

}  // namespace murosimf::app

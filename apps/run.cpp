// `murosimf run`: builds a scene, runs it, reports.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/game_arguments.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/picture_sequence.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "apps/supervision_arguments.h"
#include "murosimf/connect/crash_note.h"
#include "murosimf/connect/tcp_server.h"
#include "murosimf/files/files_read.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/league/league.h"
#include "murosimf/logging/run_log.h"
#include "murosimf/runtime/clock.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_pictures.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/session/session.h"

namespace murosimf::app {
namespace {

struct RunOptions {
  SceneArguments scene;
  std::optional<double> duration;  ///< [s]
  std::string speed = "max";       ///< "max", or simulated seconds per wall second
  std::string json;                ///< file, "-" for standard output
  std::string picture;             ///< PNG file
  std::string pictures;            ///< folder for a sequence of PNG files
  double picture_every = 0.5;      ///< [s] of simulated time
  std::vector<std::string> log;    ///< what is recorded (logging/log_paths.h)
  std::string out;                 ///< CSV file for that
  double log_rate = 100;           ///< [Hz] of properties in it
  std::string listen;              ///< [HOST:]PORT, empty: nobody can connect
  RecordOptions record;
  std::string serial;                  ///< folder for links to serial lines
  bool no_cameras = false;             ///< nothing is drawn for cameras
  std::string load_state, save_state;  ///< files
  GameArguments game;
  SupervisionArguments supervision;
};

void define(const Command& command, RunOptions& options) {
  add_scene(command, options.scene);
  command.add("--duration", options.duration, "Simulated seconds, instead of the scene's");
  command.add("--speed", options.speed, "'max', or simulated seconds per second: 1 is real time").shows_default();
  command.add("--json", options.json, "Write the report as JSON to this file, or to standard output with '-'");
  command.add("--picture", options.picture, "Write a PNG picture of the field from above");
  const Option pictures = command.add("--pictures", options.pictures,
                                      "Write PNG pictures of the bodies to this folder while the scene runs");
  command.add("--picture-every", options.picture_every, "Simulated seconds from one picture to the next")
      .needs(pictures)
      .shows_default();
  const Option log =
      command.add("--log", options.log,
                  "Record numbers: of sensors, like 'blue1.imu.*', or properties, like 'ball.ball.position'");
  const Option out = command.add("--out", options.out, "Write them to this file (CSV)").needs(log);
  log.one_at_a_time().needs(out);
  command.add("--log-rate", options.log_rate, "How often properties are recorded, in Hz").needs(log).shows_default();
  add_record(command, options.record);
  command.add("--load-state", options.load_state, "Go on from a state of this scene that --save-state has written");
  command.add("--save-state", options.save_state, "Write the state at the end to this file");
  add_game(command, options.game);
  command.add("--listen", options.listen,
              "Take control software for robots with the controller 'tcp': PORT of this computer alone, or HOST:PORT");
  add_supervision(command, options.supervision).excludes(pictures);
  command.add("--serial", options.serial,
              "Folder for links to the serial lines of robots with controller = \"serial\", one for each, named as it");
  command.add("--no-cameras", options.no_cameras, "Draw nothing for cameras: they have no frames then");
}

using WallClock = std::chrono::steady_clock;

std::shared_ptr<connect::TcpServer> server_at(const std::string& where) {
  if (where.empty()) return nullptr;
  connect::TcpServerOptions options{.say = [](const std::string& line) { say_warning(line); }, .stop = interrupted};
  try {
    options.address = wire::parse_address(where);
  } catch (const wire::WireError& error) {
    throw SetupError(fmt::format("--listen: {}", error.what()));
  }
  auto server = connect::listen_for_software(std::move(options));
  say_note(fmt::format("listening on {}", to_text(server->address())));
  return server;
}

std::optional<double> speed_of(const std::string& text) {
  if (text == "max") return std::nullopt;
  double speed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), speed);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw SetupError(fmt::format("--speed '{}': write 'max' or a number (1 is real time)", text));
  }
  return speed;
}

Duration duration_of(double s) {
  if (!(s >= 0) || !std::isfinite(s)) throw SetupError(fmt::format("--duration {}: must be a number from 0", s));
  if (s > scene_file::longest_duration)
    throw SetupError(fmt::format("--duration {}: longer than simulated time can count", s));
  return from_seconds(s);
}

/// How far a run has come.
class RunProgress {
 public:
  RunProgress(Duration start, Duration end) : start_(start), end_(seconds(end)) {}
  void show(Duration now) {
    const double share = end_ > 0 ? seconds(now) / end_ : 1;
    const std::string rate =
        rate_of(seconds(now - start_), std::chrono::duration<double>(WallClock::now() - wall_start_).count());
    line_.show(share, fmt::format("{:.1f} of {:.1f} s{}{}", seconds(now), end_, rate.empty() ? "" : ", ", rate));
  }
  void warn(Duration now, const std::string& text) {
    line_.hide();
    say_warning(fmt::format("{:.1f} s: {}", seconds(now), text));
  }

 private:
  Progress line_;
  Duration start_;
  WallClock::time_point wall_start_ = WallClock::now();
  double end_;  // [s]
};

void load(scene::Scene& scene, const std::string& file) {
  const std::string bytes = files::read_input_file(file, files::most_state_bytes);
  with_context(file, [&] { scene.load(std::as_bytes(std::span(bytes))); });
}

void save(scene::Scene& scene, const std::string& file) {
  const std::vector<std::byte> bytes = scene.save();
  files::write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Whether control software has crashed meanwhile. Reports of the run are written then too.
template <class Run>
bool crashes(const Run& run) {
  try {
    run();
    return false;
  } catch (const connect::SoftwareCrash&) {
    return true;
  }
}

/// Serial lines need a place where programs find them, and a place needs lines.
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

std::string why_stopped(bool crashed) {
  if (crashed) return "a crash";
  return interrupted() ? signal_name() : "a supervisor";
}

/// Why a run cannot go back in time; empty: it can.
std::string no_way_back(const RunOptions& options) {
  if (!options.log.empty()) return "its numbers are logged";
  if (!options.record.file.empty()) return "it is recorded";
  const GameArguments& game = options.game;
  const bool outside = !game.game_controller.empty() || !game.team_links.empty() || !game.repeat.empty();
  return outside ? "it has to do with the world outside" : "";
}

/// As supervisors want.
template <class Show, class Warn>
void run_supervised(scene::Scene& scene, const RunOptions& options, Duration end, const Show& show, const Warn& warn,
                    Lateness& lateness) {
  session::Session session(scene, {.speed = speed_of(options.speed),
                                   .paused = options.supervision.paused,
                                   .tell_of_overruns = warn,
                                   .no_way_back = no_way_back(options)});
  const auto supervision = supervision_of(session, options.supervision);
  session.run(end, show);
  lateness = session.lateness();
}

int run(const RunOptions& options) {
  end_gently();
  Clock clock(speed_of(options.speed));
  if (options.duration) duration_of(*options.duration);
  // where results go is checked before anything is computed, so that no result is lost
  check_json_file(options.json);
  if (!options.picture.empty()) files::check_writable(options.picture);
  if (!options.out.empty()) files::check_writable(options.out);
  if (!options.save_state.empty()) files::check_writable(options.save_state);
  if (!options.game.log.empty()) files::check_writable(options.game.log);
  check(options.record);
  std::optional<PictureSequence> pictures;
  if (!options.pictures.empty()) pictures.emplace(options.pictures, options.picture_every);

  scene::SceneOptions scene_options = options_of(options.scene);
  scene_options.cameras = !options.no_cameras;
  scene_options.paths = !options.picture.empty();
  scene_options.terminals = options.serial;
  scene_options.pushable = !options.supervision.where.empty();
  const files::FilesRead files_read;
  scene_options.software = server_at(options.listen);
  scene::Scene scene(options.scene.file, scene_options);
  check_serial(scene.spec(), options.serial);
  const Duration duration = duration_of(options.duration.value_or(scene.spec().duration));
  Simulation& simulation = scene.simulation();
  const std::unique_ptr<league::League> game = game_of(scene, options.game);
  std::optional<logging::RunLog> log;
  if (!options.log.empty()) {
    log.emplace(simulation, options.log,
                logging::RunLogOptions{.step_rate = scene.spec().rate, .property_rate = options.log_rate});
  }
  const auto recorder = make_recorder(scene, options.record, files_read);
  simulation.initialize();
  if (!options.load_state.empty()) load(scene, options.load_state);
  if (pictures) pictures->show(scene);

  Duration wall{};  // without that for pictures
  bool crashed = false;
  Lateness lateness;
  {
    RunProgress progress(simulation.now(), duration);
    const auto warn = [&](const Overrun& overrun) {
      progress.warn(overrun.simulated, scene::to_text(overrun.lateness));
    };
    clock.tell_of_overruns(warn);
    bool records = recorder != nullptr;
    const auto show = [&](Duration now) {
      progress.show(now);
      if (!records || recorder->trouble().empty()) return;
      progress.warn(now, "nothing is recorded any more: " + recorder->trouble());
      records = false;
    };
    const auto advance_to = [&](Duration time) {
      const auto start = WallClock::now();
      simulation.run(std::max(Duration{}, time - simulation.now()), clock, show);
      wall += WallClock::now() - start;
    };
    const auto advance = [&] {
      if (!options.supervision.where.empty()) {
        const auto start = WallClock::now();
        run_supervised(scene, options, duration, show, warn, lateness);
        wall += WallClock::now() - start;
        return;
      }
      while (pictures && pictures->next() <= duration) {
        advance_to(pictures->next());
        if (interrupted()) return;
        pictures->take();
      }
      advance_to(duration);
    };
    crashed = crashes(advance);
    if (options.supervision.where.empty()) lateness = clock.lateness();
    clock.tell_of_overruns({});
  }
  scene::RunReport report = make_report(scene, wall, lateness);
  if (simulation.now() < duration)
    report.stopped = {why_stopped(crashed), options.duration.value_or(scene.spec().duration)};

  if (log) log->write(options.out);
  if (game && !options.game.log.empty()) files::write_file(options.game.log, game->log().to_text());
  const bool recorded = !recorder || finish(*recorder, report, options.record);
  if (!options.save_state.empty()) save(scene, options.save_state);
  if (!options.picture.empty()) write_picture(scene, options.picture);
  write_result(options.json, scene::to_text(report), options.json.empty() ? "" : scene::to_json(report));
  if (crashed) return unexpected;
  if (!recorded) return users_mistake;
  return report.stopped ? exit_code() : 0;
}

}  // namespace

void add_run(CommandLine& line) { line.add<RunOptions>("run", "Run a scene and say what happened", define, run); }

}  // namespace murosimf::app

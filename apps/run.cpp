// `murosimf run`: builds a scene, runs it, reports.
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/picture_sequence.h"
#include "apps/standard_output.h"
#include "murosimf/io/output_file.h"
#include "murosimf/io/run_log.h"
#include "murosimf/io/scene.h"

namespace murosimf::app {
namespace {

using WallClock = std::chrono::steady_clock;

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
  if (s > io::longest_duration) throw SetupError(fmt::format("--duration {}: longer than simulated time can count", s));
  return from_seconds(s);
}

/// One line on the terminal that grows; nothing if standard error is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(Duration duration) : duration_(duration), shown_(isatty(STDERR_FILENO) != 0) {}
  ~ProgressBar() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(Duration now) const {
    if (!shown_) return;
    constexpr int width = 40;
    const double share = duration_ > Duration{} ? seconds(now) / seconds(duration_) : 1;
    const int done = static_cast<int>(std::min(1.0, share) * width);
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:.1f} of {:.1f} s", "", done, "", width - done, seconds(now),
               seconds(duration_));
    std::fflush(stderr);
  }

 private:
  Duration duration_;
  bool shown_;
};

}  // namespace

int run(const RunOptions& options) {
  Clock clock(speed_of(options.speed));
  if (options.duration) duration_of(*options.duration);
  // where results go is checked before anything is computed, so that no result is lost
  check_json_file(options.json);
  if (!options.picture.empty()) io::check_writable(options.picture);
  if (!options.out.empty()) io::check_writable(options.out);
  std::optional<PictureSequence> pictures;
  if (!options.pictures.empty()) pictures.emplace(options.pictures, options.picture_every);

  io::Scene scene(options.scene, {.threads = options.threads,
                                  .seed = options.seed,
                                  .overrides = options.overrides,
                                  .events = options.events,
                                  .pushes = options.pushes,
                                  .lenient = options.lenient,
                                  .cameras = !options.no_cameras});
  const Duration duration = duration_of(options.duration.value_or(scene.spec().duration));
  Simulation& simulation = scene.simulation();
  std::optional<io::RunLog> log;
  if (!options.log.empty()) {
    log.emplace(simulation, options.log,
                io::RunLogOptions{.step_rate = scene.spec().rate, .property_rate = options.log_rate});
  }
  simulation.initialize();

  Duration wall{};  // without that for pictures
  {
    const ProgressBar bar(duration);
    const auto advance_to = [&](Duration time) {
      const auto start = WallClock::now();
      simulation.run(std::max(Duration{}, time - simulation.now()), clock, [&](Duration now) { bar.show(now); });
      wall += WallClock::now() - start;
    };
    while (pictures && pictures->next() <= duration) {
      advance_to(pictures->next());
      pictures->take(scene);
    }
    advance_to(duration);
  }
  const io::RunReport report = scene.report(wall, clock.lateness());

  if (log) log->write(options.out);
  write_result(options.json, io::to_text(report), io::to_json(report));
  if (!options.picture.empty()) scene.write_picture(options.picture);
  return 0;
}

}  // namespace murosimf::app

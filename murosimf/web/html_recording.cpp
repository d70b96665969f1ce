#include "murosimf/web/html_recording.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "murosimf/drawing/drawn.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/web/entity_states.h"
#include "murosimf/web/gzip.h"
#include "murosimf/web/json_line.h"
#include "murosimf/web/little_endian.h"
#include "murosimf/web/page.h"
#include "murosimf/web/pose_message.h"

namespace murosimf::web {
namespace {

constexpr double slowest = 0.1, fastest = 200;  // [Hz]
constexpr std::string_view place = "<!-- recording -->";

Duration period_of(double rate) {
  if (rate >= slowest && rate <= fastest) return from_seconds(1 / rate);
  throw SetupError(fmt::format("an HTML file cannot have {} frames per second; write a number from {} to {}", rate,
                               slowest, fastest));
}

}  // namespace

/// Bytes of equal significance follow each other: they compress much better.
std::string as_planes(const std::vector<std::string>& frames) {
  MUROSIMF_ASSERT(std::ranges::all_of(frames, [&](const auto& one) { return one.size() == frames.front().size(); }));
  const std::size_t words = frames.empty() ? 0 : frames.front().size() / 2;
  std::string out(2 * words * frames.size(), '\0');
  for (std::size_t word = 0; word < words; ++word) {
    unsigned before = 0;
    char* low = &out[2 * word * frames.size()];
    for (const std::string& frame : frames) {
      const unsigned value = static_cast<unsigned char>(frame[2 * word]) |
                             static_cast<unsigned>(static_cast<unsigned char>(frame[2 * word + 1])) << 8;
      const unsigned difference = value - before;
      low[0] = static_cast<char>(difference & 0xff);
      low[frames.size()] = static_cast<char>(difference >> 8 & 0xff);
      before = value;
      ++low;
    }
  }
  return out;
}

HtmlRecording::HtmlRecording(scene::Scene& scene, HtmlOptions options)
    : scene_(scene), options_(std::move(options)), period_(period_of(options_.rate)) {
  if (compressed_page().empty()) {
    throw SetupError("this program was built without its page for browsers: npm was missing (docs/web.md)");
  }
  (void)gunzip(compressed_page());  // fails early if this build cannot unpack it
  files::check_writable(options_.file);
  if (!options_.by_hand) scene_.simulation().after_start([this] { start(); });
}

/// Also after a reset: the file contains one run.
void HtmlRecording::start() {
  times_.clear();
  frames_.clear();
  document_ = {};
  drawings_ = {};
  drawn_.reset();
  scene_.simulation().at(scene_.simulation().now(), [this] { look(); });
}

void HtmlRecording::look() {
  take_frame();
  MUROSIMF_ASSERT(!times_.empty());
  // multiples of the period from the first frame: no drift by rounding
  scene_.simulation().at(times_.front() + static_cast<std::int64_t>(times_.size()) * period_, [this] { look(); });
}

void HtmlRecording::take_frame() {
  const Simulation& simulation = scene_.simulation();
  const std::size_t rows = document_.moving.size();
  const bool grows = simulation.world().entities().size() != document_.entities;
  if (grows) document_ = scene_document(scene_);
  poses_.time = simulation.now();
  take_poses(simulation.world(), poses_);
  times_.push_back(poses_.time);
  frames_.push_back(pose_message(document_, poses_, 0, false));
  if (grows && frames_.size() > 1) lengthen_frames(rows);
  take_drawings();
}

/// Frames are of one size: those of before an entity came have the rows of the last one for it, as of one that is not present.
void HtmlRecording::lengthen_frames(std::size_t rows) {
  const std::size_t size = frames_.front().size();
  const std::string& last = frames_.back();
  MUROSIMF_ASSERT(last.size() >= size);
  const std::string absent = rows_of_absent(document_, rows, last.substr(size));
  const std::string count = last.substr(count_in_pose_message, 2);
  for (std::size_t i = 0; i + 1 < frames_.size(); ++i) {
    MUROSIMF_ASSERT(frames_[i].size() == size);
    frames_[i].replace(count_in_pose_message, 2, count) += absent;
  }
}

/// Drawings are taken only when one of the counters has changed.
void HtmlRecording::take_drawings() {
  const World& world = scene_.simulation().world();
  const auto others = options_.others ? options_.others->shown() : nullptr;
  const std::pair now{drawing::drawn_changes(world), others ? others->changes : 0};
  if (drawn_ == now) return;
  drawn_ = now;
  std::vector<drawing::Drawn> all = drawing::drawn_by_robots(world);
  if (others) std::ranges::move(drawing::external_drawings(*others, drawing::teams_of(world)), std::back_inserter(all));
  MUROSIMF_ASSERT(!times_.empty());
  drawings_.take(times_.size() - 1, all);
}

void HtmlRecording::note(Duration time, const std::string& text) { notes_.emplace_back(time, text); }

nlohmann::json HtmlRecording::lines() const {
  if (notes_.empty()) return lines_of(scene_.simulation());
  nlohmann::json lines = nlohmann::json::array();
  for (const auto& [time, text] : notes_) {
    lines.push_back({{"time", seconds(time)}, {"text", text}, {"warning", false}});
  }
  return lines;
}

std::string HtmlRecording::packed() const {
  MUROSIMF_ASSERT(!frames_.empty());
  const Simulation& simulation = scene_.simulation();
  nlohmann::json text{{"scene_bytes", document_.bytes.size()},
                      {"frames", frames_.size()},
                      {"words", frames_.front().size() / 2},
                      {"lines", lines()},
                      {"entities", entity_states(simulation.world())}};
  if (!drawings_.empty()) text["drawings"] = drawings_.object();
  const std::string head = json_line(text);
  std::string bytes;
  put_u32(bytes, static_cast<std::uint32_t>(head.size()));
  bytes += head;
  bytes += document_.bytes;
  bytes += as_planes(frames_);
  return gzip(bytes);
}

/// The last instant belongs to the recording, even between two frames.
void HtmlRecording::finish() {
  scene_.simulation().initialize();
  if (times_.empty() || times_.back() < scene_.simulation().now()) take_frame();
  std::string page = gunzip(compressed_page());
  const std::size_t found = page.find(place);
  if (found == std::string::npos) throw SetupError("the page of this program has no place for a recording");
  page.replace(found, place.size(),
               fmt::format(R"(<script id="recording" type="application/octet-stream">{}</script>)", base64(packed())));
  files::write_file(options_.file, page);
}

}  // namespace murosimf::web

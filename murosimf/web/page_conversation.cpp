#include "murosimf/web/page_conversation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/web/json_line.h"
#include "murosimf/web/waiting_jobs.h"
#include "murosimf/web/watched_numbers.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

enum Kind { poses, state, lines, values, picture, drawings, camera_note };  // of views (outbox.h)

constexpr int most_unseen = 4;            // a slow page gets fewer poses, but no outdated ones
constexpr std::size_t most_paths = 64;    // per client
constexpr std::size_t most_orders = 256;  // pending per client
constexpr double longest_time = 3e9;      // [s]

/// Errors of the JSON library would tell a page nothing about the key.
template <class T>
T get(const json& order, const char* key) {
  try {
    return order.at(key).get<T>();
  } catch (const json::exception&) {
    throw ClientError(fmt::format("'{}' is missing, or is of another type", key));
  }
}

double finite(const json& order, const char* key) {
  const double value = get<double>(order, key);
  if (!std::isfinite(value) || std::abs(value) > longest_time)
    throw ClientError(fmt::format("'{}' is no such number", key));
  return value;
}

}  // namespace

PageConversation::~PageConversation() { live_.leave(*this); }

/// Binary messages have no meaning here.
void PageConversation::receive(std::string_view message, bool binary) {
  if (binary) throw ClientError("orders are text");
  const json order = json::parse(message, nullptr, false);
  if (!order.is_object()) throw ClientError("orders are JSON objects");
  const auto what = get<std::string>(order, "do");
  if (what == "seen") {
    unseen_ = std::max(0, unseen_ - 1);
    if (missed_.bytes) show_poses();
    return;
  }
  const auto id = order.contains("id") ? get<std::int64_t>(order, "id") : -1;
  if (jobs_.size() >= most_orders) throw ClientError("too many orders at once");
  try {
    carry_out(what, order, id);
  } catch (const SetupError& error) {
    answer(id, error.what());
  }
}

void PageConversation::carry_out(const std::string& what, const json& order, std::int64_t id) {
  session::Session& session = live_.session();
  if (what == "change") return wait_for(id, session.change(get<std::string>(order, "text")));
  if (what == "seek")
    return wait_for(id,
                    session.seek(from_seconds(finite(order, "time")),
                                 order.contains("branch") ? std::optional(get<int>(order, "branch")) : std::nullopt));
  if (what == "reset") {
    return wait_for(id, session.reset(order.contains("seed") ? std::optional(get<std::uint64_t>(order, "seed"))
                                                             : std::nullopt));
  }
  if (what == "watch") return watch(order, id);
  if (what == "names") return names(order, id);
  if (what == "camera") return look_through(order, id);
  if (what == "pause") {
    session.pause();
  } else if (what == "go_on") {
    session.go_on();
  } else if (what == "step") {
    session.step(std::clamp<std::int64_t>(get<std::int64_t>(order, "steps"), 1, 1'000'000));
  } else if (what == "speed") {
    session.set_speed(get<json>(order, "speed").is_null() ? std::nullopt : std::optional(finite(order, "speed")));
  } else if (what == "contacts") {
    contacts_ = get<bool>(order, "on");
  } else {
    throw ClientError(fmt::format("unknown request '{}'", what.substr(0, 40)));
  }
  answer(id, "");
}

void PageConversation::watch(const json& order, std::int64_t id) {
  const auto paths = get<std::vector<std::string>>(order, "paths");
  if (paths.size() > most_paths) throw SetupError(fmt::format("{} numbers at most are shown at once", most_paths));
  std::future<void> done = live_.session().visit([paths](scene::Scene& scene) {
    for (const std::string& path : paths) (void)find_number(scene.simulation().world(), path);
  });
  jobs_.push_back({.id = id, .done = std::move(done), .result = nullptr, .then = [this, paths] { paths_ = paths; }});
}

/// A known picture is sent at once.
void PageConversation::look_through(const json& order, std::int64_t id) {
  camera_.clear();
  ++cameras_chosen_;
  if (get<json>(order, "camera").is_null()) return answer(id, "");
  const auto camera = get<std::string>(order, "camera");
  std::future<void> done = live_.session().visit([camera](scene::Scene& scene) { check_camera(scene, camera); });
  const std::uint64_t number = cameras_chosen_;
  jobs_.push_back({.id = id, .done = std::move(done), .result = nullptr, .then = [this, camera, number] {
                     if (number != cameras_chosen_) return;  // another one was selected meanwhile
                     camera_ = camera;
                     const auto note = live_.last().camera_notes.find(camera);
                     if (note != live_.last().camera_notes.end()) outbox.show(camera_note, note->second);
                     const auto known = live_.last().pictures.find(camera);
                     if (known != live_.last().pictures.end()) outbox.show(picture, known->second);
                   }});
}

void PageConversation::names(const json& order, std::int64_t id) {
  auto result = std::make_shared<json>();
  const auto entity = get<std::string>(order, "entity");
  std::future<void> done = live_.session().visit(
      [result, entity](scene::Scene& scene) { *result = paths_of(scene.simulation().world(), entity); });
  jobs_.push_back({.id = id, .done = std::move(done), .result = result});
}

void PageConversation::wait_for(std::int64_t id, std::future<void> done) {
  jobs_.push_back({.id = id, .done = std::move(done), .result = nullptr});
}

void PageConversation::answer(std::int64_t id, const std::string& error) {
  json text{{"is", "answer"}, {"id", id}};
  if (!error.empty()) text["error"] = error;
  outbox.send(text_message(json_line(text)));
}

void PageConversation::answer_jobs() {
  answer_ready(jobs_, [this](const Job& job, const std::string& error) {
    if (!error.empty()) return answer(job.id, error);
    job.then();
    json text{{"is", "answer"}, {"id", job.id}};
    if (job.result) text["result"] = *job.result;
    outbox.send(text_message(json_line(text)));
  });
}

void PageConversation::show_poses() {
  MUROSIMF_ASSERT(unseen_ >= 0);
  if (unseen_ >= most_unseen) return;
  outbox.show(poses, std::exchange(missed_, {}));
  ++unseen_;
}

/// A new document comes first: all later messages refer to it.
void PageConversation::look() {
  const bool is_new = document_ != live_.documents();
  if (is_new) {
    const bool first = std::exchange(document_, live_.documents()) == 0;
    outbox.send(live_.document());
    if (first) {
      if (live_.last().state.bytes) outbox.show(state, live_.last().state);
      if (live_.last().lines.bytes) outbox.show(lines, live_.last().lines);
      if (live_.last().drawings.bytes) outbox.show(drawings, live_.last().drawings);
    }
    missed_ = live_.last().poses;
  }
  answer_jobs();
  if (document_ == 0) return;
  const News& news = live_.news();
  const Message& now = contacts_ && news.poses_with_contacts.bytes ? news.poses_with_contacts : news.poses;
  if (now.bytes) missed_ = now;
  if (missed_.bytes) show_poses();
  if (news.state.bytes) outbox.show(state, news.state);
  if (news.lines.bytes) outbox.show(lines, news.lines);
  if (news.drawings.bytes) outbox.show(drawings, news.drawings);
  if (news.values.bytes && !paths_.empty()) outbox.show(values, news.values);
  const auto note = news.camera_notes.find(camera_);
  if (note != news.camera_notes.end()) outbox.show(camera_note, note->second);
  const auto seen = news.pictures.find(camera_);
  if (seen != news.pictures.end()) outbox.show(picture, seen->second);
}

/// Numbers that several pages watch are read once.
void PageConversation::add(Requests& requests) const {
  ++requests.clients;
  requests.contacts = requests.contacts || contacts_;
  for (const std::string& path : paths_) {
    if (std::ranges::find(requests.numbers, path) == requests.numbers.end()) requests.numbers.push_back(path);
  }
  if (!camera_.empty() && std::ranges::find(requests.cameras, camera_) == requests.cameras.end()) {
    requests.cameras.push_back(camera_);
  }
}

}  // namespace murosimf::web

#include "murosimf/web/foxglove_conversation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/web/gzip.h"
#include "murosimf/web/json_line.h"
#include "murosimf/web/little_endian.h"
#include "murosimf/web/waiting_jobs.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

constexpr int time_view = 0, playback_view = -1;  // kinds of views (outbox.h); channels have theirs from 1
constexpr int error_level = 2;
constexpr std::size_t most_requests = 256;
constexpr std::size_t most_names = 1000;

enum ServerOpcode : std::uint8_t { message_data = 1, time_data = 2, playback_state = 5 };
enum ClientOpcode : std::uint8_t { client_data = 1, playback_control = 3 };

/// Reads numbers of a binary message in order; ClientError if it ends too early.
class BytesReader {
 public:
  explicit BytesReader(std::string_view bytes) : left_(bytes) {}
  template <class Unsigned>
  Unsigned take() {
    const std::string_view bytes = take(sizeof(Unsigned));
    Unsigned value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      value = static_cast<Unsigned>(value | static_cast<Unsigned>(static_cast<unsigned char>(bytes[i])) << (8 * i));
    }
    return value;
  }
  std::string_view take(std::size_t size) {
    if (left_.size() < size) throw ClientError("a binary message ends too early");
    const std::string_view bytes = left_.substr(0, size);
    left_.remove_prefix(size);
    return bytes;
  }
  [[nodiscard]] std::string_view rest() const { return left_; }

 private:
  std::string_view left_;
};

json time_json(Duration time) {
  return {{"sec", time.count() / 1'000'000'000}, {"nsec", time.count() % 1'000'000'000}};
}

/// A value in the notation of `PATH = VALUE`: texts without quotes.
std::string text_of_value(const json& value) { return value.is_string() ? value.get<std::string>() : json_line(value); }

std::set<std::string> names_of(const json& order) {
  const auto names = order.at("parameterNames").get<std::vector<std::string>>();
  if (names.size() > most_names) throw ClientError("too many parameters at once");
  return {names.begin(), names.end()};
}

std::string id_of(const json& order) { return order.value("id", std::string{}); }

/// "/blue1/command": "blue1"; empty for other topics.
std::string commanded_robot(const std::string& topic) {
  constexpr std::string_view end = "/command";
  if (!topic.starts_with('/') || !topic.ends_with(end) || topic.size() <= end.size() + 1) return {};
  return topic.substr(1, topic.size() - 1 - end.size());
}

double number_at(const json& object, const char* key) { return object.is_object() ? object.value(key, 0.0) : 0.0; }

/// Of geometry_msgs/Twist: "[0.1, 0, 0.3]", forward, left [m/s], turn [rad/s].
std::string command_of(const json& twist) {
  if (!twist.is_object() || !twist.contains("linear")) throw SetupError("a command is {linear: {x, y}, angular: {z}}");
  const json linear = twist.at("linear"), angular = twist.value("angular", json::object());
  return fmt::format("[{}, {}, {}]", number_at(linear, "x"), number_at(linear, "y"), number_at(angular, "z"));
}

}  // namespace

FoxgloveConversation::~FoxgloveConversation() {
  for (const auto& [channel, id] : subscriptions_) live_.subscribe(channel, false);
  live_.leave();
}

void FoxgloveConversation::receive(std::string_view message, bool binary) {
  if (jobs_.size() >= most_requests) throw ClientError("too many requests at once");
  try {
    if (!binary) {
      const json order = json::parse(message, nullptr, false);
      if (!order.is_object()) throw ClientError("requests are JSON objects");
      return receive_text(order);
    }
    switch (BytesReader(message).take<std::uint8_t>()) {
      case client_data: return take_published(message.substr(1));
      case playback_control: return control_playback(message.substr(1));
      default: throw ClientError("unknown binary message");
    }
  } catch (const SetupError& error) {
    say(error_level, error.what());
  } catch (const json::exception&) {
    throw ClientError("a request lacks something, or has something of another type");
  }
}

void FoxgloveConversation::receive_text(const json& order) {
  const auto what = order.at("op").get<std::string>();
  if (what == "subscribe") return subscribe(order);
  if (what == "unsubscribe") return unsubscribe(order);
  if (what == "advertise") return advertise(order);
  if (what == "getParameters") return get_parameters(order);
  if (what == "setParameters") return set_parameters(order);
  if (what == "unadvertise") {
    for (const json& id : order.at("channelIds")) published_.erase(id.get<std::uint32_t>());
  } else if (what == "subscribeParameterUpdates") {
    watched_.merge(names_of(order));
    if (watched_.size() > most_names) throw ClientError("too many parameters at once");
  } else if (what == "unsubscribeParameterUpdates") {
    for (const std::string& name : names_of(order)) watched_.erase(name);
  } else {
    say(error_level, fmt::format("unknown request '{}'", what.substr(0, 40)));
  }
}

void FoxgloveConversation::subscribe(const json& order) {
  for (const json& one : order.at("subscriptions")) {
    const auto id = one.at("id").get<std::uint32_t>();
    const auto channel = one.at("channelId").get<std::uint64_t>();
    if (channel == 0 || channel > announced_) {
      say(error_level, fmt::format("there is no channel {}", channel));
      continue;
    }
    if (subscriptions_.insert_or_assign(static_cast<std::uint16_t>(channel), id).second)
      live_.subscribe(static_cast<std::uint16_t>(channel), true);
    if (const auto last = live_.last(static_cast<std::uint16_t>(channel)); last.bytes) send_packet(last);
  }
}

void FoxgloveConversation::unsubscribe(const json& order) {
  for (const json& id : order.at("subscriptionIds")) {
    std::erase_if(subscriptions_, [&](const auto& one) {
      if (one.second != id.get<std::uint32_t>()) return false;
      live_.subscribe(one.first, false);
      told_troubles_.erase(one.first);
      return true;
    });
  }
}

void FoxgloveConversation::advertise(const json& order) {
  for (const json& one : order.at("channels")) {
    const auto topic = one.at("topic").get<std::string>();
    if (one.at("encoding").get<std::string>() != "json") {
      say(error_level, fmt::format("'{}': messages are taken as json", topic.substr(0, 80)));
    } else if (topic != "/change" && commanded_robot(topic).empty()) {
      say(error_level, fmt::format("'{}': no such topic; topics are /ROBOT/command and /change", topic.substr(0, 80)));
    } else if (published_.size() < most_names) {
      published_[one.at("id").get<std::uint32_t>()] = topic;
    }
  }
}

void FoxgloveConversation::take_published(std::string_view message) {
  BytesReader in(message);
  const auto found = published_.find(in.take<std::uint32_t>());
  if (found == published_.end()) throw SetupError("a message of a channel that was not advertised");
  const json body = json::parse(in.rest(), nullptr, false);
  if (body.is_discarded()) throw SetupError(fmt::format("{}: this is no JSON", found->second));
  if (const std::string robot = commanded_robot(found->second); !robot.empty())
    return change(fmt::format("{}.command = {}", robot, command_of(body)));
  if (body.is_object() && body.contains("data")) return change(text_of_value(body.at("data")));
  throw SetupError("/change: messages are {data: \"PATH = VALUE\"}");
}

void FoxgloveConversation::change(const std::string& text) { jobs_.push_back({.done = live_.session().change(text)}); }

void FoxgloveConversation::get_parameters(const json& order) {
  std::set<std::string> names = names_of(order);
  if (names.empty()) {
    for (const auto& [name, value] : live_.parameters()) names.insert(name);
  }
  send_parameters(names, id_of(order));
}

/// Any change by PATH = VALUE; readable parameters are reported after it.
void FoxgloveConversation::set_parameters(const json& order) {
  for (const json& one : order.at("parameters")) {
    if (jobs_.size() >= most_requests) throw ClientError("too many requests at once");
    const auto name = one.at("name").get<std::string>();
    if (!one.contains("value")) throw SetupError(fmt::format("{}: a parameter cannot be removed", name));
    const std::string value = text_of_value(one.at("value"));
    jobs_.push_back({.done = live_.session().change(fmt::format("{} = {}", name, value)),
                     .parameter = name,
                     .value = value,
                     .id = id_of(order)});
  }
}

void FoxgloveConversation::control_playback(std::string_view message) {
  BytesReader in(message);
  const bool play = in.take<std::uint8_t>() == 0;
  const auto speed = std::bit_cast<float>(in.take<std::uint32_t>());
  const bool seek = in.take<std::uint8_t>() != 0;
  const auto time = in.take<std::uint64_t>();
  const std::string id(in.take(in.take<std::uint32_t>()));
  session::Session& session = live_.session();
  const bool has_speed = std::isfinite(speed) && speed > 0;
  if (has_speed) session.set_speed(speed);
  if (!play) session.pause();
  if (seek) {
    const session::SessionStatus now = session.status();
    const auto wanted =
        static_cast<Duration::rep>(std::min<std::uint64_t>(time, std::uint64_t(Duration::max().count())));
    jobs_.push_back({.done = session.seek(std::clamp(Duration(wanted), now.first, now.last)), .id = id, .seek = true});
  }
  if (play && !seek) session.go_on();
  // the request is not executed yet, so the status would show the old speed
  if (!seek) send_playback(false, id, has_speed ? std::optional<double>(speed) : std::nullopt);
}

void FoxgloveConversation::introduce() {
  const session::SessionStatus status = live_.session().status();
  const Duration end = status.end == Duration::max() ? status.last : std::max(status.last, status.end);
  const auto capabilities = {"clientPublish", "parameters", "parametersSubscribe", "time", "playbackControl"};
  outbox.send(text_message(json_line({{"op", "serverInfo"},
                                      {"name", "MuRoSimF: " + live_.scene_name()},
                                      {"capabilities", capabilities},
                                      {"supportedEncodings", {"json"}},
                                      {"metadata", {{"scene", live_.scene_name()}}},
                                      {"dataStartTime", time_json(status.first)},
                                      {"dataEndTime", time_json(end)},
                                      // viewers drop their data when time has jumped to a new run
                                      {"sessionId", fmt::format("{}", status.jumps)}})));
  introduced_ = true;
}

void FoxgloveConversation::announce_channels() {
  json channels = json::array();
  for (; announced_ < live_.channels().size(); ++announced_) {
    const FoxgloveChannel& channel = live_.channels()[announced_];
    channels.push_back({{"id", channel.id},
                        {"topic", channel.topic},
                        {"encoding", "protobuf"},
                        {"schemaName", channel.schema_name},
                        {"schemaEncoding", "protobuf"},
                        {"schema", base64(channel.schema)}});
  }
  outbox.send(text_message(json_line({{"op", "advertise"}, {"channels", channels}})));
}

void FoxgloveConversation::send_parameters(const std::set<std::string>& names, const std::string& id) {
  json parameters = json::array();
  for (const std::string& name : names) {
    const auto found = live_.parameters().find(name);
    if (found != live_.parameters().end()) parameters.push_back({{"name", name}, {"value", found->second}});
  }
  json text{{"op", "parameterValues"}, {"parameters", parameters}};
  if (!id.empty()) text["id"] = id;
  outbox.send(text_message(json_line(text)));
}

void FoxgloveConversation::send_packet(const FoxgloveLive::Packet& packet) {
  const auto found = subscriptions_.find(packet.channel);
  if (found == subscriptions_.end()) return;
  std::string bytes;
  bytes.reserve(13 + packet.bytes->size());
  put_u8(bytes, message_data);
  put_u32(bytes, found->second);
  put_u64(bytes, static_cast<std::uint64_t>(packet.time.count()));
  bytes += *packet.bytes;
  if (live_.is_of_lines(packet.channel)) {
    outbox.send(binary_message(std::move(bytes)));
  } else {
    outbox.show(packet.channel, binary_message(std::move(bytes)));
  }
}

void FoxgloveConversation::send_playback(bool seeked, const std::string& id, std::optional<double> speed) {
  enum State : std::uint8_t { playing, paused, buffering, ended };
  const session::SessionStatus status = live_.session().status();
  std::string bytes;
  put_u8(bytes, playback_state);
  put_u8(bytes, !status.paused ? playing : status.time >= status.end ? ended : paused);
  const std::size_t head = bytes.size();
  put_u64(bytes, static_cast<std::uint64_t>(status.time.count()));
  put_f32(bytes, static_cast<float>(speed.value_or(status.speed.value_or(1))));
  put_u8(bytes, seeked ? 1 : 0);
  put_u32(bytes, static_cast<std::uint32_t>(id.size()));
  bytes += id;
  playback_ = bytes.substr(0, head);
  if (id.empty() && !seeked) {
    outbox.show(playback_view, binary_message(std::move(bytes)));
  } else {
    outbox.send(binary_message(std::move(bytes)));
  }
}

void FoxgloveConversation::say(int level, const std::string& text) {
  outbox.send(text_message(json_line({{"op", "status"}, {"level", level}, {"message", text}})));
}

/// Each message once.
void FoxgloveConversation::publish_troubles() {
  for (const auto& [channel, id] : subscriptions_) {
    const std::string trouble = live_.trouble_of(channel);
    if (!trouble.empty() && std::exchange(told_troubles_[channel], trouble) != trouble) say(error_level, trouble);
  }
}

void FoxgloveConversation::answer_jobs() {
  answer_ready(jobs_, [this](const Job& job, const std::string& error) {
    if (!error.empty()) say(error_level, error);
    if (error.empty()) live_.parameter_became(job.parameter, job.value);
    if (!job.parameter.empty()) send_parameters({job.parameter}, job.id);
    if (job.seek) send_playback(error.empty(), job.id);
  });
}

void FoxgloveConversation::look() {
  if (live_.channels().empty()) return;  // the first visit is pending
  if (!introduced_) introduce();
  if (announced_ < live_.channels().size()) announce_channels();
  answer_jobs();
  publish_troubles();
  for (const FoxgloveLive::Packet& packet : live_.news()) send_packet(packet);
  if (live_.news().empty()) return;
  std::string clock;
  put_u8(clock, time_data);
  put_u64(clock, static_cast<std::uint64_t>(live_.time().count()));
  outbox.show(time_view, binary_message(std::move(clock)));
  std::set<std::string> other;
  for (const std::string& name : watched_) {
    const auto now = live_.parameters().find(name);
    if (now == live_.parameters().end() || std::exchange(told_[name], now->second) == now->second) continue;
    other.insert(name);
  }
  if (!other.empty()) send_parameters(other, "");
  const session::SessionStatus status = live_.session().status();
  const char state = !status.paused ? 0 : status.time >= status.end ? 3 : 1;
  if (playback_.empty() || playback_[1] != state) send_playback(false, "");
}

}  // namespace murosimf::web

/// foxglove_conversation.h - the protocol between Foxglove or Lichtblick and the server: subprotocols "foxglove.sdk.v1" and
/// "foxglove.websocket.v1" (docs/web.md; https://github.com/foxglove/ws-protocol).
#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "murosimf/web/foxglove_live.h"
#include "murosimf/web/server.h"

namespace murosimf::web {

class FoxgloveConversation final : public Conversation {
 public:
  explicit FoxgloveConversation(FoxgloveLive& live) : live_(live) { live_.join(); }
  ~FoxgloveConversation() override;
  FoxgloveConversation(const FoxgloveConversation&) = delete;
  FoxgloveConversation& operator=(const FoxgloveConversation&) = delete;

  void receive(std::string_view message, bool binary) override;
  void look() override;

 private:
  void receive_text(const nlohmann::json& order);
  void subscribe(const nlohmann::json& order);
  void unsubscribe(const nlohmann::json& order);
  void advertise(const nlohmann::json& order);
  void get_parameters(const nlohmann::json& order);
  void set_parameters(const nlohmann::json& order);
  void take_published(std::string_view message);
  void control_playback(std::string_view message);
  void change(const std::string& text);

  void introduce();
  void announce_channels();
  void send_parameters(const std::set<std::string>& names, const std::string& id);
  void send_packet(const FoxgloveLive::Packet& packet);
  void send_playback(bool seeked, const std::string& id, std::optional<double> speed = {});
  void publish_troubles();
  void say(int level, const std::string& text);
  void answer_jobs();

  /// A request executed by the simulation's thread for this client.
  struct Job {
    std::future<void> done;
    std::string parameter{}, value{};  ///< reported on completion; empty: none
    std::string id{};                  ///< of the request
    bool seek = false;
  };

  FoxgloveLive& live_;
  std::deque<Job> jobs_;
  bool introduced_ = false;
  std::size_t announced_ = 0;                             // number of channels
  std::map<std::uint16_t, std::uint32_t> subscriptions_;  // by channel
  std::map<std::uint16_t, std::string> told_troubles_;    // by channel
  std::map<std::uint32_t, std::string> published_;        // topics by the client's channels
  std::set<std::string> watched_;                         // parameters
  std::map<std::string, std::string> told_;               // values of these
  std::string playback_;                                  // last state sent
};

}  // namespace murosimf::web

/// page_conversation.h - the protocol between the page and the server: subprotocol "murosimf.v1" (docs/web.md).
#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "murosimf/web/live_scene.h"
#include "murosimf/web/server.h"

namespace murosimf::web {

class PageConversation final : public Conversation, public Subscriber {
 public:
  explicit PageConversation(LiveScene& live) : live_(live) { live_.join(*this); }
  ~PageConversation() override;

  void receive(std::string_view message, bool binary) override;
  void look() override;

  void add(Requests& requests) const override;

 private:
  /// A request executed by the simulation's thread for this client.
  struct Job {
    std::int64_t id = 0;
    std::future<void> done;
    std::shared_ptr<nlohmann::json> result;  ///< null: no result but completion
    std::function<void()> then = [] {};      ///< called on completion
  };
  void carry_out(const std::string& what, const nlohmann::json& order, std::int64_t id);
  void watch(const nlohmann::json& order, std::int64_t id);
  void look_through(const nlohmann::json& order, std::int64_t id);
  void names(const nlohmann::json& order, std::int64_t id);
  void wait_for(std::int64_t id, std::future<void> done);
  void answer(std::int64_t id, const std::string& error);
  void answer_jobs();
  void show_poses();

  LiveScene& live_;
  std::deque<Job> jobs_;
  std::uint64_t document_ = 0;  // version that the client has
  bool contacts_ = false;
  std::vector<std::string> paths_;
  std::string camera_;                // selected camera; empty: none
  std::uint64_t cameras_chosen_ = 0;  // number of selections so far
  int unseen_ = 0;                    // messages of poses not yet acknowledged
  Message missed_;                    // poses withheld until an acknowledgement
};

}  // namespace murosimf::web

/// message_exchange.h - algorithm: carries messages between the robots of a team, at the beginning of a tick, in a fixed order.
///
/// A message that software sends in a tick is handed over at the beginning of the next one, in the order of the robots: first to the
/// channel of the team (its bandwidth), then to each other robot in range (delay, jitter, loss; link_model.h). It is in
/// the inbox at the beginning of the first tick at or after its arrival. The same for any number of threads.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/control_software/link_model.h"
#include "murosimf/control_software/message_box.h"
#include "murosimf/control_software/radio_options.h"
#include "murosimf/control_software/team_gateway.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::control_software {

class MessageExchange final : public Algorithm {
 public:
  /// Of the world. Of `robots` those take part whose software has requested messages (TeamRadio::open). Throws SetupError for
  /// impossible options.
  MessageExchange(Setup& setup, const std::vector<Entity*>& robots, const RadioOptions& options, std::uint64_t seed);

  /// Sets the gateway that is polled at every tick for external messages and receives all that are sent; null: none. Must outlive this
  /// object or be removed.
  void connect(TeamGateway* gateway) { gateway_ = gateway; }

  [[nodiscard]] Phase phase() const noexcept override { return Phase::survey; }
  void initialize() override;
  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;
  void entity_entered(const Entity& entity) override;
  void reseed(std::uint64_t seed) override;
  void state(StateArchive& archive) override;
  void step(const Instant& instant) noexcept override;

 private:
  struct Member {
    const Entity* robot;
    std::span<const Vec3d> r;
    MessageBox* box;
  };
  struct Posted {
    std::size_t sender;  // of members_
    TeamMessage message;
  };
  struct OnItsWay {
    Duration arrival{};
    std::uint64_t receiver = 0;  // of members_
    TeamMessage message;
    void state(StateArchive& archive) { archive(arrival, receiver, message); }
  };
  using Way = std::pair<std::size_t, std::size_t>;  // from, to

  void add(Setup setup);
  void start(const Member& member) const;
  [[nodiscard]] LinkModel& channel(const std::string& team);
  [[nodiscard]] LinkModel& way(const Way& way);
  [[nodiscard]] bool in_range(const Member& a, const Member& b) const noexcept;
  [[nodiscard]] std::vector<Posted> collect();
  void send(const Posted& posted);
  void deliver(Duration now);
  void deliver_from_outside(Duration now);

  RadioOptions options_;
  std::uint64_t seed_;
  TeamGateway* gateway_ = nullptr;
  std::vector<Member> members_;
  std::map<std::string, LinkModel> channels_;  // by team
  std::map<Way, LinkModel> ways_;
  std::vector<OnItsWay> on_their_way_;  // by arrival; those of one instant as they were sent
};

}  // namespace murosimf::control_software

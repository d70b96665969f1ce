#include "murosimf/control_software/message_exchange.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::control_software {

MessageExchange::MessageExchange(Setup& setup, const std::vector<Entity*>& robots, const RadioOptions& options,
                                 std::uint64_t seed)
    : options_(options), seed_(seed) {
  (void)LinkModel(options.channel(), seed, "");  // throws for invalid options
  (void)LinkModel(options.way(), seed, "");
  for (Entity* robot : robots) add(setup.of(*robot));
}

void MessageExchange::add(Setup setup) {
  if (!setup.entity().find(message_box)) return;
  members_.push_back({&setup.entity(), setup.read(properties::position), &setup.write(message_box)[0]});
}

void MessageExchange::entity_added(Setup& setup) { add(setup); }

void MessageExchange::entity_taken_back(const Entity& entity) noexcept {
  std::erase_if(members_, [&](const Member& member) { return member.robot == &entity; });
}

void MessageExchange::start(const Member& member) const {
  *member.box = {.longest = options_.message_bytes, .per_second = options_.messages_per_second};
}

void MessageExchange::initialize() {
  for (const Member& member : members_) start(member);
  channels_.clear();
  ways_.clear();
  on_their_way_.clear();
}

void MessageExchange::entity_entered(const Entity& entity) {
  for (const Member& member : members_) {
    if (member.robot == &entity) start(member);
  }
}

void MessageExchange::reseed(std::uint64_t seed) {
  seed_ = seed;
  for (auto& [team, channel] : channels_) channel.reseed(seed);
  for (auto& [pair, way] : ways_) way.reseed(seed);
}

LinkModel& MessageExchange::channel(const std::string& team) {
  return channels_.try_emplace(team, options_.channel(), seed_, "channel of " + team).first->second;
}

LinkModel& MessageExchange::way(const Way& way) {
  MUROSIMF_ASSERT(way.first < members_.size() && way.second < members_.size() && way.first != way.second);
  const auto found = ways_.find(way);
  if (found != ways_.end()) return found->second;
  const std::string name =
      fmt::format("radio from {} to {}", members_[way.first].robot->name(), members_[way.second].robot->name());
  return ways_.try_emplace(way, options_.way(), seed_, name).first->second;
}

bool MessageExchange::in_range(const Member& a, const Member& b) const noexcept {
  return options_.range <= 0 || norm(a.r[0] - b.r[0]) <= options_.range;
}

void MessageExchange::step(const Instant& instant) noexcept {
  for (const Posted& posted : collect()) send(posted);
  if (!on_their_way_.empty()) deliver(instant.now);
  if (gateway_) deliver_from_outside(instant.now);
}

/// In the order of time; those of one instant in the order of the robots.
std::vector<MessageExchange::Posted> MessageExchange::collect() {
  std::vector<Posted> all;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    for (TeamMessage& message : members_[i].box->outbox) all.push_back({i, std::move(message)});
    members_[i].box->outbox.clear();
  }
  // Stable: messages of one instant keep the order of the robots, whatever thread ran their software.
  std::ranges::stable_sort(all, {}, [](const Posted& posted) { return posted.message.sent; });
  return all;
}

void MessageExchange::send(const Posted& posted) {
  MUROSIMF_ASSERT(posted.sender < members_.size());
  const Member& sender = members_[posted.sender];
  const std::string& team = sender.robot->options().team;
  if (gateway_) gateway_->give(team, posted.message);
  const std::optional<Duration> on_air = channel(team).arrival(posted.message.sent, posted.message.bytes.size());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Member& receiver = members_[i];
    if (i == posted.sender || receiver.robot->options().team != team || receiver.robot->idle()) continue;
    std::optional<Duration> arrival;
    if (on_air && in_range(sender, receiver)) {
      arrival = way({posted.sender, i}).arrival(*on_air, posted.message.bytes.size());
    }
    if (!arrival) {
      ++sender.box->counts.lost;
      continue;
    }
    // upper_bound: of equal arrivals the one that was sent first is delivered first
    const auto place = std::ranges::upper_bound(on_their_way_, *arrival, {}, &OnItsWay::arrival);
    on_their_way_.insert(place, {*arrival, i, posted.message});
  }
}

void MessageExchange::deliver(Duration now) {
  const auto end = std::ranges::upper_bound(on_their_way_, now, {}, &OnItsWay::arrival);
  for (auto each = on_their_way_.begin(); each != end; ++each) {
    MUROSIMF_ASSERT(each->receiver < members_.size());
    const Member& receiver = members_[each->receiver];
    if (!receiver.robot->idle()) receiver.box->deliver(std::move(each->message));
  }
  on_their_way_.erase(on_their_way_.begin(), end);
}

void MessageExchange::deliver_from_outside(Duration now) {
  for (const ExternalMessage& outside : gateway_->take(now)) {
    for (const Member& member : members_) {
      if (member.robot->options().team != outside.team || member.robot->idle()) continue;
      member.box->deliver({now, "", outside.bytes});
    }
  }
}

/// Ways are created again on loading, since a state may have more of them than this run had so far.
void MessageExchange::state(StateArchive& archive) {
  archive(on_their_way_);
  for (const OnItsWay& message : on_their_way_) {
    if (message.receiver >= members_.size()) throw SetupError("the state has a message for a robot that is not there");
  }
  for (std::size_t from = 0; from < members_.size(); ++from) {
    const std::string& team = members_[from].robot->options().team;
    archive(channel(team));
    for (std::size_t to = 0; to < members_.size(); ++to) {
      if (to != from && members_[to].robot->options().team == team) archive(way({from, to}));
    }
  }
}

}  // namespace murosimf::control_software

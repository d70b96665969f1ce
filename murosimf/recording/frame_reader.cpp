#include "murosimf/recording/frame_reader.h"

#include <algorithm>
#include <limits>
#include <ranges>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/topics.h"

namespace murosimf::recording {
namespace {

constexpr std::size_t most_kept = 4;                                                            // chunks
constexpr auto latest = static_cast<std::uint64_t>(std::numeric_limits<Duration::rep>::max());  // [ns]
constexpr std::uint64_t most_entities = 1'000'000;  // more are none of a recording's
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

FrameReader::FrameReader(const McapReader& file, const std::vector<RecordedEntity>& entities)
    : file_(file), entities_(entities), channels_(channels_of(file, {"/tf", "/joints", "/targets", "/contacts"})) {
  const auto poses = channels_of(file, {"/tf"});
  const auto& chunks = file.contents().chunks;
  for (std::size_t i = 0; i < chunks.size() && !poses.empty(); ++i) {
    if (has_any(chunks[i], poses)) chunks_.push_back(i);
  }
  std::erase_if(chunks_, [&](std::size_t i) {
    return chunks[i].end_time > latest || chunks[i].start_time > chunks[i].end_time;
  });
  std::ranges::stable_sort(chunks_, {}, [&](std::size_t i) { return chunks[i].start_time; });
  for (std::size_t i = 0; i < entities.size(); ++i) {
    for (const RecordedEntity::Link& link : entities[i].links) links_.emplace(link.frame, Place{i, links_.size()});
    for (const RecordedEntity::Joint& joint : entities[i].joints) joints_.emplace(joint.name, Place{i, joints_.size()});
  }
  std::size_t first = 0, last = chunks_.size();
  while (first < chunks_.size() && read(first).frames.empty()) ++first;
  while (last > first && read(last - 1).frames.empty()) --last;
  if (first == last) throw SetupError(file.file().string() + ": it has no poses (--record-what)");
  begin_ = read(first).frames.begin()->first;
  end_ = read(last - 1).frames.rbegin()->first;
  if (begin_ > end_) refuse_index();
  MUROSIMF_ASSERT(begin_ <= end_);
}

/// Called if the index of chunks contradicts the times of their messages.
void FrameReader::refuse_index() const {
  throw SetupError(file_.file().string() + ": its index of times is wrong; 'murosimf repair' mends it");
}

/// The last chunks are kept: neighboring frames are mostly in the same one.
const FrameReader::Chunk& FrameReader::read(std::size_t index) {
  MUROSIMF_ASSERT(index < chunks_.size());
  const auto known = std::ranges::find(kept_, index, &Chunk::index);
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
    return kept_.front();
  }
  Chunk chunk{.index = index, .frames = {}};
  std::map<Duration, Messages> all;
  file_.visit_messages(file_.contents().chunks[chunks_[index]], [&](const Message& message) {
    const auto channel = channels_.find(message.channel_id);
    if (channel == channels_.end()) return;
    if (message.log_time > latest) return;
    Messages& messages = all[time_of(message)];
    const std::string& topic = channel->second;
    (topic == "/tf"        ? messages.transforms
     : topic == "/joints"  ? messages.joints
     : topic == "/targets" ? messages.targets
                           : messages.contacts) = message.data;
  });
  for (auto& [time, messages] : all) {
    if (!messages.transforms.empty()) chunk.frames.emplace(time, std::move(messages));
  }
  kept_.push_front(std::move(chunk));
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front();
}

const RecordedFrame& FrameReader::at(Duration time) {
  const Duration wanted = std::clamp(time, begin_, end_);
  const auto begins = [&](std::size_t chunk) {
    return Duration(static_cast<Duration::rep>(file_.contents().chunks[chunk].start_time));
  };
  auto index = static_cast<std::size_t>(std::ranges::upper_bound(chunks_, wanted, {}, begins) - chunks_.begin());
  // backwards: the first chunk before the time may have no pose until then
  while (index > 0) {
    const Chunk& chunk = read(--index);
    const auto later = chunk.frames.upper_bound(wanted);
    if (later == chunk.frames.begin()) continue;
    const auto& found = *std::prev(later);
    frame_ = {.time = found.first, .of_poses = true};
    frame_.present.assign(entities_.size(), 0);
    frame_.poses.assign(links_.size(), {});
    frame_.joints.assign(joints_.size(), {unknown, unknown, unknown, unknown});
    with_context(file_.file().string(), [&, &messages = found.second] {
      take_transforms(messages.transforms);
      take_joints(messages.joints, false);
      take_joints(messages.targets, true);
      take_contacts(messages.contacts);
    });
    return frame_;
  }
  refuse_index();
}

/// The first message after the time: in this chunk or the next one that has any.
std::optional<Duration> FrameReader::after(Duration time) {
  if (time >= end_) return std::nullopt;
  const auto ends = [&](std::size_t chunk) {
    return Duration(static_cast<Duration::rep>(file_.contents().chunks[chunk].end_time));
  };
  for (std::size_t index = 0; index < chunks_.size(); ++index) {
    if (ends(chunks_[index]) <= time) continue;
    const Chunk& chunk = read(index);
    const auto next = chunk.frames.upper_bound(time);
    if (next != chunk.frames.end()) return next->first;
  }
  return std::nullopt;
}

void FrameReader::take_transforms(std::string_view data) {
  for (ProtobufReader all(data); all.next();) {
    if (all.field() != 1) continue;
    std::string parent, child;
    Transformd pose;
    for (ProtobufReader in = all.message(); in.next();) {
      if (in.field() == 2) parent = in.bytes();
      if (in.field() == 3) child = in.bytes();
      if (in.field() == 4) pose.position = read_vector(in.message());
      if (in.field() == 5) pose.orientation = read_rotation(in.message());
    }
    const auto link = links_.find(child);
    if (link == links_.end()) continue;      // of an entity that was added later
    const auto outer = links_.find(parent);  // parents are written first
    if (outer != links_.end()) pose = frame_.poses[outer->second.index] * pose;
    frame_.poses[link->second.index] = pose;
    frame_.present[link->second.entity] = 1;
  }
}

/// Joints are found by name: other programs may write them in another order.
void FrameReader::take_joints(std::string_view data, bool targets) {
  for (ProtobufReader all(data); all.next();) {
    if (all.field() != 2) continue;
    JointNumbers* joint = nullptr;
    for (ProtobufReader in = all.message(); in.next();) {
      if (in.field() == 1) {
        const auto found = joints_.find(std::string(in.bytes()));
        joint = found == joints_.end() ? nullptr : &frame_.joints[found->second.index];
      }
      if (!joint) continue;
      if (in.field() == 2) (targets ? joint->target : joint->position) = in.number();
      if (in.field() == 3) joint->velocity = in.number();
      if (in.field() == 5) joint->torque = in.number();
    }
  }
}

/// Entities are numbered from 1, by their places in the world; 0: two entities touch, or the file does not say.
void FrameReader::take_contacts(std::string_view data) {
  for (ProtobufReader all(data); all.next();) {
    if (all.field() != 2) continue;
    ContactMark mark;
    for (ProtobufReader in = all.message(); in.next();) {
      if (in.field() == 1) mark.point = read_vector(in.message());
      if (in.field() == 2) mark.force = read_vector(in.message());
      if (in.field() == 3) mark.ground_contact_of = static_cast<int>(std::min(in.varint(), most_entities)) - 1;
    }
    frame_.contacts.push_back(mark);
  }
}

}  // namespace murosimf::recording

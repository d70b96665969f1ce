#include "murosimf/recording/recording_retention.h"

#include <algorithm>
#include <ranges>

#include "murosimf/math/assert.h"

namespace murosimf::recording {

RecordingRetention::RecordingRetention(const scene::Scene& scene, const RetentionOptions& options,
                                       RecordingWriter& writer)
    : scene_(scene), writer_(writer), keep_(options.keep), after_(options.after) {
  if (!options.record_on.empty()) watch_.emplace(scene, options.record_on);
}

void RecordingRetention::ask(bool on) {
  if (asked_ == on) return;
  if (!on && !newly_asked_) write_until_ = std::max(write_until_, scene_.simulation().now());
  asked_ = newly_asked_ = on;
}

RecordedFrame RecordingRetention::spare_frame() {
  RecordedFrame frame;
  if (!spare_.empty()) {
    frame = std::move(spare_.back());
    spare_.pop_back();
  }
  return frame;
}

void RecordingRetention::add_frame(RecordedFrame&& frame) {
  if (watch_) watch(frame);
  add_between(std::move(frame));
}

void RecordingRetention::add_between(RecordedFrame&& frame) {
  MUROSIMF_ASSERT(batch_.empty() || batch_.back().time <= frame.time);
  if (watch_ && !frame.state.empty()) flush();  // states begin batches
  batch_.push_back(std::move(frame));
  if (batch_.back().time - batch_.front().time >= batch_span) flush();
}

void RecordingRetention::watch(RecordedFrame& frame) {
  std::vector<std::string> happened = watch_->look();
  if (!happened.empty()) write_until_ = std::max(write_until_, frame.time + after_);
  if (std::exchange(newly_asked_, false)) happened.emplace_back("the recording was asked for");
  for (std::string& event : happened) {
    frame.events.emplace_back(frame.time, std::move(event));
    frame.commands.insert(frame.commands.begin(), commands_between_.begin(), commands_between_.end());
    commands_between_.clear();
    frame.outside.insert(frame.outside.begin(), outside_between_.begin(), outside_between_.end());
    outside_between_.clear();
    ++happened_;
  }
}

/// The present one is held; frames that were written are kept for those to come.
void RecordingRetention::begin_batch() {
  Batch spent = writer_.spent();
  for (RecordedFrame& frame : spent) {
    if (frame.of_poses) spare_.push_back(std::move(frame));
  }
  spent.clear();
  spent.reserve(batch_.size() + batch_.size() / 4);
  held_.push_back(std::move(batch_));
  batch_ = std::move(spent);
}

void RecordingRetention::flush() {
  if (batch_.empty()) return;
  const Duration begin = batch_.front().time;
  begin_batch();
  if (watch_ && !asked_ && begin > write_until_) return forget_old();
  if (begin_file()) {
    for (Batch& batch : held_) writer_.push(std::move(batch));
  }
  held_.clear();
}

bool RecordingRetention::begin_file() {
  MUROSIMF_ASSERT(held_.empty() || !held_.front().empty());
  return writer_.begin(held_.empty() ? scene_.simulation().now() : held_.front().front().time);
}

/// Drops what is before the last state that is old enough; of a file that has begun commands stay, so that the run can be repeated.
void RecordingRetention::forget_old() {
  const auto is_start = [&](const Batch& batch) {
    return !batch.front().state.empty() && batch.front().time <= scene_.simulation().now() - keep_;
  };
  const auto last = std::find_if(held_.rbegin(), held_.rend(), is_start);
  if (last == held_.rend()) return;
  const auto first_kept = std::prev(last.base());
  Batch rest;
  for (auto batch = held_.begin(); batch != first_kept; ++batch) {
    for (RecordedFrame& frame : *batch) {
      if (writer_.began()) {
        commands_between_.insert(commands_between_.end(), frame.commands.begin(), frame.commands.end());
      }
      if (!frame.outside.empty()) keep_outside(frame, rest);
    }
  }
  if (!rest.empty()) writer_.push(std::move(rest));
  keep_drawings(first_kept);
  held_.erase(held_.begin(), first_kept);
}

/// A file that has begun gets all of it at once, so that the run can be repeated; before, what lasts is kept for its first event.
void RecordingRetention::keep_outside(RecordedFrame& dropped, Batch& rest) {
  if (writer_.began()) {
    rest.emplace_back().time = dropped.time;
    rest.back().outside = std::move(dropped.outside);
    return;
  }
  for (auto& note : dropped.outside) {
    if (lasts(note.second.kind)) outside_between_.push_back(std::move(note));
  }
}

/// Of the frames before, the last drawings of each topic, which come only when they change, go to the first frame that stays.
void RecordingRetention::keep_drawings(std::vector<Batch>::iterator first_kept) {
  std::vector<FrameDrawings>& kept = first_kept->front().drawings;
  const auto has = [&](const DrawingTopic& topic) {
    return std::ranges::find(kept, topic, &FrameDrawings::topic) != kept.end();
  };
  for (auto batch = first_kept; batch != held_.begin();) {
    --batch;
    for (RecordedFrame& frame : std::views::reverse(*batch)) {
      for (FrameDrawings& drawn : frame.drawings) {
        if (!has(drawn.topic)) kept.push_back(std::move(drawn));
      }
    }
  }
}

}  // namespace murosimf::recording

// What Recorder does with record_on: frames are kept in memory until something happens.
#include <algorithm>
#include <ranges>
#include <utility>

#include "murosimf/recording/recorder.h"

namespace murosimf::recording {

void Recorder::ask(bool on) {
  if (asked_ == on) return;
  if (!on && !newly_asked_) write_until_ = std::max(write_until_, scene_.simulation().now());
  asked_ = newly_asked_ = on;
}

void Recorder::watch(RecordedFrame& frame) {
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

/// Drops what is before the last state that is old enough; of a file that has begun commands stay, for who repeats the run.
void Recorder::forget_old() {
  const auto is_start = [&](const RecordingThread::Batch& batch) {
    return !batch.front().state.empty() && batch.front().time <= scene_.simulation().now() - keep_;
  };
  const auto last = std::find_if(held_.rbegin(), held_.rend(), is_start);
  if (last == held_.rend()) return;
  const auto first_kept = std::prev(last.base());
  RecordingThread::Batch rest;
  for (auto batch = held_.begin(); batch != first_kept; ++batch) {
    for (RecordedFrame& frame : *batch) {
      if (began_) commands_between_.insert(commands_between_.end(), frame.commands.begin(), frame.commands.end());
      if (!frame.outside.empty()) keep_outside(frame, rest);
    }
  }
  if (!rest.empty()) thread_->push(std::move(rest));
  keep_drawings(first_kept);
  held_.erase(held_.begin(), first_kept);
}

/// A file that has begun gets all of it at once, for who repeats the run; before, what lasts is kept for its first event.
void Recorder::keep_outside(RecordedFrame& dropped, RecordingThread::Batch& rest) {
  if (began_) {
    rest.emplace_back().time = dropped.time;
    rest.back().outside = std::move(dropped.outside);
    return;
  }
  for (auto& note : dropped.outside) {
    if (lasts(note.second.kind)) outside_between_.push_back(std::move(note));
  }
}

/// Of the frames before, the last drawings of each topic, which come only when they change, go to the first frame that stays.
void Recorder::keep_drawings(std::vector<RecordingThread::Batch>::iterator first_kept) {
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

/// external_messages.h - messages of a robot's programs: taken from DDS as they arrive, and written down; or those of an earlier run again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/control_software/software_maker.h"
#include "murosimf/dds/inbox.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::dds {

class ExternalMessages {
 public:
  /// What is said when the first program has come, and when the last one has gone.
  struct Lines {
    std::string came, left;
  };
  /// `channel`: "dds:ROBOT". `say` is told when programs come and go.
  ExternalMessages(const std::string& channel, const ExternalInputOptions& outside, control_software::SayLine say,
                   Lines lines);

  /// Whether this run is given the messages of an earlier one.
  [[nodiscard]] bool is_repeated() const { return repeated_ != nullptr; }
  /// Whether this instant was there before: nothing may be sent then.
  [[nodiscard]] bool remembers() const { return memory_ && memory_->repeats(); }
  /// Messages of the instant `now`, in the order in which they came. `inbox`: null, if nothing can come.
  [[nodiscard]] std::vector<Arrival> at(Duration now, Inbox* inbox);
  /// A state was loaded.
  void rewind() { reader_.rewind(); }

 private:
  [[nodiscard]] std::vector<ExternalInput> listen(Inbox* inbox);
  [[nodiscard]] std::vector<ExternalInput> repeat(Duration now);
  [[nodiscard]] std::vector<ExternalInput> remember();

  control_software::SayLine say_;
  Lines lines_;
  std::shared_ptr<ExternalInputLog> notes_;  // the pen's
  ExternalInputRecorder pen_;
  std::shared_ptr<const ExternalInputLog> repeated_;  // null: live
  ExternalInputReader reader_;
  std::shared_ptr<ExternalInputHistory> remembered_;  // the channel's
  ExternalInputHistory::Channel* memory_ = nullptr;   // null: time does not jump
  bool client_ = false;
};

}  // namespace murosimf::dds

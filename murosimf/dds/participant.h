/// participant.h - a participant of a DDS domain on this machine alone: topics of bytes that are encoded elsewhere (cdr.h).
///
/// It speaks UDP over IPv4 on 127.0.0.1 and nothing else: no other interface, no shared memory. Programs that start later find it at
/// once, since it announces itself every 0.2 s. Implemented with Fast DDS 2; builds without it have none (no_participant.cpp).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "murosimf/dds/inbox.h"

namespace murosimf::dds {

struct Topic {
  std::string name;       ///< "rt/low_state"
  std::string type;       ///< "booster_interface::msg::dds_::LowState_"
  bool reliable = false;  ///< of what is written: repeated until it is acknowledged
  bool kept = false;      ///< what was written last also goes to readers that come later (transient local)
  bool large = false;     ///< messages of more than a datagram: they are sent by a thread of their own
  int depth = 0;          ///< [1] messages that are kept until they are acknowledged; 0: the usual number
};

/// Writes messages of one topic. May be called from any thread; waits for nothing.
class TopicWriter {
 public:
  virtual ~TopicWriter() = default;
  virtual void write(const Bytes& message) = 0;
  /// The same as an answer: the sender of `request` recognizes it by the related sample identity (RTPS 2.3, 8.7.8).
  virtual void answer(const Bytes& message, const SampleIdentity& request) = 0;
  /// Whether any program reads it at present.
  [[nodiscard]] virtual bool has_readers() const = 0;
};

class Participant {
 public:
  static constexpr int highest_domain = 232;  ///< by the ports of RTPS

  /// Throws SetupError: the domain cannot be joined, or this build has no DDS.
  explicit Participant(int domain);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Lives as long as the participant. Throws SetupError.
  [[nodiscard]] TopicWriter& writer(const Topic& topic);
  /// Messages go to the inbox, marked with `mark`; it outlives the participant. Throws SetupError.
  void read(const Topic& topic, Inbox& inbox, char mark);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace murosimf::dds

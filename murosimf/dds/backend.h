/// backend.h - what a DDS library does for a participant (participant.h).
///
/// It is in a module of its own, which is loaded when the first participant is made: loading Fast DDS takes as long as the rest of the program's start.
/// No exceptions and no memory of the library cross the border.
#pragma once

#include "murosimf/dds/participant.h"

namespace murosimf::dds {

class Backend {
 public:
  virtual ~Backend() = default;
  /// As of Participant; null: it cannot be made.
  [[nodiscard]] virtual TopicWriter* writer(const Topic& topic) noexcept = 0;
  /// False: it cannot be made.
  [[nodiscard]] virtual bool read(const Topic& topic, Inbox& inbox, char mark) noexcept = 0;
};

/// What the module has. Null: the domain cannot be joined.
using JoinDomain = Backend*(int domain);
inline constexpr const char* join_domain_name = "murosimf_join_dds_domain";

}  // namespace murosimf::dds

#include "murosimf/dds/participant.h"
#include "murosimf/model/error.h"

namespace murosimf::dds {

struct Participant::Inside {};

Participant::Participant(int) {
  throw SetupError("this build has no DDS: it was made without Fast DDS 2 (Debian 12, Ubuntu 24.04: libfastrtps-dev)");
}
Participant::~Participant() = default;

/// Not reached: there is no participant.
TopicWriter& Participant::writer(const Topic& topic) { throw SetupError("no DDS: " + topic.name); }
void Participant::read(const Topic& topic, Inbox&, char) { throw SetupError("no DDS: " + topic.name); }

}  // namespace murosimf::dds

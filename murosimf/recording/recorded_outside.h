/// recorded_outside.h - what came from outside into a recorded run (connect/outside_notes.h), as messages murosimf.Outside.
#pragma once

#include <memory>
#include <string>

#include "murosimf/connect/outside_notes.h"
#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

/// Appends the message.
void put_outside(std::string& bytes, const std::string& channel, const connect::OutsideNote& note);

/// All of a recording. Throws SetupError if a message is damaged.
[[nodiscard]] std::shared_ptr<const connect::OutsideNotes> recorded_outside(const McapReader& file);

}  // namespace murosimf::recording

/// recorded_outside.h - what came from outside into a recorded run (runtime/outside_notes.h), as messages murosimf.Outside.
#pragma once

#include <memory>
#include <string>

#include "murosimf/runtime/outside_notes.h"
#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

/// Appends the message.
void put_outside(std::string& bytes, const std::string& channel, const OutsideNote& note);

/// All of a recording. Throws SetupError if a message is damaged.
[[nodiscard]] std::shared_ptr<const OutsideNotes> recorded_outside(const McapReader& file);

}  // namespace murosimf::recording

/// recorded_external_input.h - external input of a recorded run (runtime/external_input_log.h), as messages murosimf.Outside.
#pragma once

#include <memory>
#include <string>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::recording {

/// Appends the message.
void put_outside(std::string& bytes, const std::string& channel, const ExternalInput& note);

/// All notes of a recording. Throws SetupError if a message is damaged.
[[nodiscard]] std::shared_ptr<const ExternalInputLog> recorded_external_input(const McapReader& file);

}  // namespace murosimf::recording

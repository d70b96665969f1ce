/// recording_schemas.h - the types of messages in recordings: Foxglove's, with its names and numbers, and a few additional ones.
#pragma once

#include <string>

#include "murosimf/recording/mcap/message_schema.h"

namespace murosimf::recording {

/// "foxglove.FrameTransforms", "murosimf.StateHash", ... Throws SetupError if there is none of this name.
[[nodiscard]] const MessageSchema& find_schema(const std::string& name);

/// descriptor_set() of it.
[[nodiscard]] std::string descriptors_of(const MessageSchema& schema);

}  // namespace murosimf::recording

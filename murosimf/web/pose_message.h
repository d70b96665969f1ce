/// pose_message.h - all poses at one instant, as one self-contained binary message [little-endian]:
///
///     u8 1, u8 flags (1: with contacts), u16 entities, u32 jumps of time so far, f64 time [s]
///     of each entity that moves, in the order of the scene document:
///       u16 flags (1 present, 2 frozen), u16 bodies, f32 x y z of its base [m], f32 step [m]
///       of each body: i16 x y z from the base's origin [step], i16 x y z w of its orientation [1/32767]
///     with contacts: u32 number, of each f32 x y z [m], f32 x y z [N]
///
/// The step is 2^-13 m (0.12 mm) while all of an entity is within 4 m of its base, else the smallest sufficient multiple by a power of two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "murosimf/runtime/pose_frame.h"
#include "murosimf/web/scene_document.h"

namespace murosimf::web {

enum class MessageKind : std::uint8_t { poses = 1, picture = 2, scene = 3 };

/// `frame` contains the entities of the document.
[[nodiscard]] std::string pose_message(const SceneDocument& document, const PoseFrame& frame, std::uint64_t jumps,
                                       bool contacts);

/// Where its number of entities is [byte].
inline constexpr std::size_t count_in_pose_message = 2;

/// The rows of a message for the entities of the document from number `first` on, as if none of these was present.
[[nodiscard]] std::string rows_of_absent(const SceneDocument& document, std::size_t first, std::string rows);

}  // namespace murosimf::web

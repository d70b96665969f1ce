/// motion_state.h - what the motion engine does at the moment (motion_engine.h).
#pragma once

#include <array>

#include "murosimf/model/value.h"

namespace murosimf::locomotion {

inline constexpr std::size_t most_motions = 32;  ///< of one robot

/// One number for each motion of a robot, in the order of their names. What changes to another number than 0 asks for its motion, once.
struct MotionRequests {
  std::array<double, most_motions> number{};
};

enum class MotionMode { walk, play, protect, lie, get_up };

/// Doubles and nothing else, so that it is a property.
struct MotionState {
  double mode = 0;      ///< a MotionMode
  double motion = -1;   ///< number of the one that is played, from 0; -1: none
  double time = 0;      ///< [s] since it began
  double blend = 0;     ///< [s] in which the joints come from where they were
  double quiet = 0;     ///< [s] that it lies without moving
  double falls = 0;     ///< [1] so far
  MotionRequests seen;  ///< in the cycle before
};

}  // namespace murosimf::locomotion

namespace murosimf {

template <>
struct ValueTraits<locomotion::MotionRequests> : OfDoubles<locomotion::MotionRequests> {};
template <>
struct ValueTraits<locomotion::MotionState> : OfDoubles<locomotion::MotionState> {};

}  // namespace murosimf

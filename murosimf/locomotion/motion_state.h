/// motion_state.h - what the motion engine does at the moment (motion_engine.h).
#pragma once

#include "murosimf/model/value.h"

namespace murosimf::locomotion {

enum class MotionMode { walk, play, protect, lie, get_up };

/// Doubles and nothing else, so that it is a property.
struct MotionState {
  double mode = 0;     ///< a MotionMode
  double motion = -1;  ///< number of the one that is played, from 0; -1: none
  double time = 0;     ///< [s] since it began
  double blend = 0;    ///< [s] in which the joints come from where they were
  double quiet = 0;    ///< [s] that it lies without moving
  double asked = 0;    ///< motion_request of the cycle before
  double falls = 0;    ///< [1] so far
};

}  // namespace murosimf::locomotion

namespace murosimf {

template <>
struct ValueTraits<locomotion::MotionState> : OfDoubles<locomotion::MotionState> {};

}  // namespace murosimf

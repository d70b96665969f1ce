#include "murosimf/locomotion/gait_properties.h"

#include <array>

namespace murosimf::properties {
namespace {

constexpr std::array gait_entries{constant(given_walk),     variable(walk_command),    variable(gait_velocity),
                                  variable(path_curvature), variable(gait_phase),      variable(gait_amplitude),
                                  variable(motion_time),    variable(balance_up),      variable(balance_upright),
                                  variable(balance_bias),   variable(balance_capture), variable(halted),
                                  constant(given_balance),  constant(given_motions),   constant(given_steps),
                                  constant(rest_position),  variable(gait_state),      variable(odometry),
                                  variable(motion_request), variable(kick_request),    variable(motion_state),
                                  variable(motion_start),   variable(motion_joints)};

}  // namespace

std::span<const CatalogEntry> gait_list() { return gait_entries; }

}  // namespace murosimf::properties

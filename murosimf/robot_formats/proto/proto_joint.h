/// proto_joint.h - joints of a PROTO file: axes, stops, springs, friction and limits of their motors.
///
/// The range of a joint is that of its stops (minStop, maxStop), else that of its motor (minPosition, maxPosition); where both are 0,
/// there is none. A joint is named after its motor, the name that controllers use; else after its DEF; else after its Solid with "_joint".
/// `position` is the joint's position in the pose of the file, springs are at rest at 0. Motors without numbers have the defaults of the
/// format: 10 N m (10 N), 10 rad/s (10 m/s).
/// Source: Webots reference manual, "JointParameters", "HingeJointParameters", "Hinge2Joint", "Motor".
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/proto/proto_log.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::proto {

/// Place of the body of a joint in the frame in which the joint's anchor and axes are written.
struct JointPlace {
  std::string solid;  ///< name of the body
  Transformd body;    ///< in the frame of the joint
};

/// One joint, of a Hinge2Joint two, the outer one first, in body axes. Throws SetupError, also for a BallJoint.
[[nodiscard]] std::vector<robot_formats::JointDescription> read_joints(const Node& joint, const JointPlace& place,
                                                                       ProtoLog& log);

}  // namespace murosimf::robot_formats::proto

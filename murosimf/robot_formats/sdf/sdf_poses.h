/// sdf_poses.h - places of the parts of a model in an SDF file: frames of poses, axes and includes, resolved by libsdformat.
///
/// libsdformat is not linked: it would cost every start of the program 18 ms, and searches for files in the working directory. The program
/// `murosimf-sdf-frames` (apps/sdf_frames) is started instead, once for each file that is read.
/// Source: SDFormat documentation, "Pose frame semantics".
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "murosimf/math/transform.h"

namespace murosimf::robot_formats::sdf {

/// Names of nested models are those of Gazebo: "arm::upper".
struct SdfLinkPose {
  Transformd place;                                                ///< in the frame of the model
  Transformd inertial;                                             ///< in the link
  std::map<std::string, Transformd> visuals, collisions, sensors;  ///< by name, in the link
};

struct SdfJointPose {
  Transformd place;                           ///< in the frame of the model
  std::string parent, child;                  ///< links, or "world"
  std::vector<Vec3d> axes;                    ///< unit vectors, frame of the model; zero: without direction
  std::map<std::string, Transformd> sensors;  ///< by name, in the joint
};

struct SdfFramePose {
  std::string name, body;  ///< the link that it is attached to
  Transformd place;        ///< in the frame of the model
};

/// A message of libsdformat.
struct SdfError {
  std::string kind;   ///< inertia, uri or other
  std::string where;  ///< file:line; empty: libsdformat does not report it
  std::string message;
};

struct SdfPoses {
  std::map<std::string, SdfLinkPose> links;
  std::map<std::string, SdfJointPose> joints;
  std::vector<SdfFramePose> frames;
  std::vector<SdfError> errors;
};

/// `model`: of the first world; empty: the one at the top of the file. `includes`: the files of the URIs of includes. Throws SetupError:
/// this build has no libsdformat, or it fails.
[[nodiscard]] SdfPoses resolve_poses(const std::filesystem::path& file, const std::string& model,
                                     const std::map<std::string, std::filesystem::path>& includes);

/// `inner` relative to `frame`, both given in one frame.
[[nodiscard]] Transformd seen_from(const Transformd& frame, const Transformd& inner);

}  // namespace murosimf::robot_formats::sdf

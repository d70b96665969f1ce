/// rosbag2_export.h - a recording as a bag of ROS 2: a folder with metadata.yaml and one MCAP file (profile ros2, CDR), as `ros2 bag record`
/// writes it with the storage plug-in mcap. `ros2 bag play`, RViz and PlotJuggler read it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

struct Rosbag2Summary {
  std::uint64_t messages = 0;
  std::size_t topics = 0;
};

/// The model of a robot as URDF.
struct RobotDescription {
  std::string robot, urdf;
};
/// Of the robots of a recorded run, from the files in the recording; `why`: those that are missing, one line each. Throws nothing: a recording need
/// not have them.
[[nodiscard]] std::vector<RobotDescription> recorded_descriptions(const std::filesystem::path& recording,
                                                                  std::vector<std::string>& why);

/// Writes `folder`, which must not exist. `descriptions` are its first messages, kept for nodes that come later, and name the frames of
/// links. Stamps are simulated time from 0; /clock has it at each instant of /tf. Throws SetupError:
/// nothing in the recording has a counterpart in ROS, the recording is damaged, the folder exists or cannot be written; then there is no
/// folder.
Rosbag2Summary write_rosbag2(const McapReader& recording, const std::filesystem::path& folder,
                             const std::vector<RobotDescription>& descriptions = {});

}  // namespace murosimf::recording

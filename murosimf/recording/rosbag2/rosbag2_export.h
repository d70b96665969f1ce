/// rosbag2_export.h - a recording as a bag of ROS 2: a folder with metadata.yaml and one MCAP file (profile ros2, CDR), as `ros2 bag record`
/// writes it with the storage plug-in mcap. `ros2 bag play`, RViz and PlotJuggler read it.
#pragma once

#include <cstdint>
#include <filesystem>

#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

struct Rosbag2Summary {
  std::uint64_t messages = 0;
  std::size_t topics = 0;
};

/// Writes `folder`, which must not exist. Stamps are simulated time from 0; /clock has it at each instant of /tf. Throws SetupError:
/// nothing in the recording has a counterpart in ROS, the recording is damaged, the folder exists or cannot be written; then there is no
/// folder.
Rosbag2Summary write_rosbag2(const McapReader& recording, const std::filesystem::path& folder);

}  // namespace murosimf::recording

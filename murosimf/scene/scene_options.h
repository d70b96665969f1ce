/// scene_options.h - options for building a scene, in addition to its file.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/file_access.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::control_software {
class TcpServer;  // tcp_server.h
}

namespace murosimf::scene {

class Assets;  // assets.h

struct SceneOptions {
  int threads = 1;
  std::optional<std::uint64_t> seed;    ///< replaces the scene's
  std::vector<std::string> overrides;   ///< PATH=VALUE, as for --set
  std::vector<std::string> events;      ///< TIME:PATH=VALUE, as for --at
  std::vector<std::string> pushes;      ///< `OBJECT=FORCE@BEGIN..END`, as for --push
  bool libraries = false;               ///< control software that the file names may be loaded: it can run any code
  std::string terminals;                ///< folder for links to robots' serial lines; empty: there are none
  std::optional<int> ros2_domain{};     ///< for robots that nodes of ROS 2 command; nothing: none do
  std::optional<int> dds_domain{};      ///< for robots of Booster; nothing: they have no DDS
  std::optional<int> unitree_domain{};  ///< the same for robots of Unitree
  bool lenient = false;                 ///< accept unknown elements in model files
  bool lanes = true;                    ///< false: equal robots are not stepped together (Simulation::use_lanes)
  bool cameras = true;                  ///< false: nothing is drawn for cameras; they have no frames
  bool only_shown = false;              ///< it makes no steps: control software and its connections are left out
  bool pushable = false;  ///< moving entities can be pushed while it runs, also without a push in the file
  bool paths = false;     ///< record the paths of all entities, for write_picture
  std::shared_ptr<control_software::TcpServer>
      software{};                    ///< where control software of the controller "tcp" comes in; null: nowhere
  ExternalInputOptions outside{};    ///< what is done with all that comes from outside
  std::shared_ptr<Assets> assets{};  ///< that it shares with other scenes; null: its own
  /// Which files its names mean, and which may be read. With `files.only_from` the request comes over a network (requested_scene.h): it is
  /// made of these files alone, overrides are those that may come from there, and none of them has software loaded.
  files::FileAccess files{};
  StopRequest stop{};  ///< ends runs of the simulation early (Simulation::stop_if)
};

}  // namespace murosimf::scene

/// scene_options.h - options for building a scene, in addition to its file.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/allowed_files.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::connect {
class TcpServer;  // tcp_server.h
}

namespace murosimf::scene {

class Assets;  // assets.h

struct SceneOptions {
  int threads = 1;
  std::optional<std::uint64_t> seed;   ///< replaces the scene's
  std::vector<std::string> overrides;  ///< PATH=VALUE, as for --set
  std::vector<std::string> events;     ///< TIME:PATH=VALUE, as for --at
  std::vector<std::string> pushes;     ///< `OBJECT=FORCE@BEGIN..END`, as for --push
  bool libraries = false;              ///< control software that the file names may be loaded: it can run any code
  std::string terminals;               ///< folder for links to robots' serial lines; empty: there are none
  bool lenient = false;                ///< accept unknown elements in model files
  bool lanes = true;                   ///< false: equal robots are not stepped together (Simulation::use_lanes)
  bool cameras = true;                 ///< false: nothing is drawn for cameras; they have no frames
  bool only_shown = false;             ///< it makes no steps: control software and its connections are left out
  bool pushable = false;  ///< every moving entity can be pushed while it runs, also without a push in the file
  bool paths = false;     ///< records the paths of all entities, for write_picture
  std::shared_ptr<connect::TcpServer> software{};  ///< accepts control software of the controller "tcp"; null: none
  ExternalInputOptions outside{};                  ///< recording and repetition of external input
  std::shared_ptr<Assets> assets{};                ///< shared with other scenes; null: its own
  /// Set for requests over a network (requested_scene.h): the scene uses these files only, overrides are restricted to those for
  /// networks, and none of them loads software. Null: any file may be named.
  std::shared_ptr<const files::AllowedFiles> only_from{};
  StopRequest stop{};  ///< ends runs of the simulation early (Simulation::stop_if)
};

}  // namespace murosimf::scene

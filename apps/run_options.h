/// run_options.h - options of `murosimf run`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/game_arguments.h"
#include "apps/record_options.h"
#include "apps/ros2_arguments.h"
#include "apps/scene_arguments.h"
#include "apps/supervision_arguments.h"
#include "apps/web_arguments.h"

namespace murosimf::app {

struct RunOptions {
  SceneArguments scene;
  std::optional<double> duration;  ///< [s]
  std::string speed;               ///< "max", or simulated seconds per wall second; empty: as it is usual
  std::string json;                ///< file, "-" for standard output
  std::string picture;             ///< PNG file
  std::string pictures;            ///< folder for a sequence of PNG files
  double picture_every = 0.5;      ///< [s] of simulated time
  std::vector<std::string> log;    ///< what is recorded (logging/log_paths.h)
  std::string out;                 ///< CSV file for that
  double log_rate = 100;           ///< [Hz] of properties in it
  std::string listen;              ///< [HOST:]PORT, empty: no connections
  std::string roboviz;             ///< [HOST:]PORT, empty: no other program draws
  RecordOptions record;
  std::string serial;   ///< folder for links to serial lines
  std::string booster;  ///< domain of DDS; empty: none
  std::string unitree;  ///< the same
  Ros2Arguments ros2;
  bool no_cameras = false;           ///< nothing is drawn for cameras
  std::string from, save_state;      ///< files
  std::vector<std::string> save_at;  ///< TIME:FILE
  GameArguments game;
  WebArguments web;
  SupervisionArguments supervision;
};

void define_run(const Command& command, RunOptions& options);

/// All checks that are possible before anything is computed. Throws SetupError.
void check(const RunOptions& options);

/// Serial lines need a place where programs find them, and a place needs lines. Throws SetupError.
void check_serial(const scene_file::SceneSpec& spec, const std::string& folder);
/// Throws SetupError: two robots of Booster, or of Unitree, in one domain, or a domain without such robots. Without a domain a note says that none is
/// reached.
void check_vendors(const scene_file::SceneSpec& spec, const RunOptions& options);
/// Whether others steer the run: browsers, supervisors, nodes of ROS 2.
[[nodiscard]] bool is_steered(const RunOptions& options);
/// Whether such a run pauses at its end, until they end it.
[[nodiscard]] bool stays_at_end(const RunOptions& options);
/// Why a steered run cannot go back in time; empty: it can.
[[nodiscard]] std::string no_way_back(const RunOptions& options);
/// Simulated seconds per wall second; nothing: as fast as possible. Throws SetupError.
[[nodiscard]] std::optional<double> speed_of(const RunOptions& options);

/// With a server if one is asked for; its address is printed. Throws SetupError.
[[nodiscard]] scene::SceneOptions scene_options_of(const RunOptions& options);

}  // namespace murosimf::app

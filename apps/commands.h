/// commands.h - the subcommands of the program. Each returns the exit code and throws SetupError for users' mistakes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/compare/compare_runs.h"

namespace murosimf::app {

struct RunOptions {
  std::string scene;
  std::optional<double> duration;  ///< [s]
  std::string speed = "max";       ///< "max", or simulated seconds per wall second
  int threads = 1;
  std::optional<std::int64_t> seed;  ///< from 0
  std::vector<std::string> overrides;
  std::vector<std::string> events;
  std::vector<std::string> pushes;
  std::string json;              ///< file, "-" for standard output
  std::string picture;           ///< PNG file
  std::string pictures;          ///< folder for a sequence of PNG files
  double picture_every = 0.5;    ///< [s] of simulated time
  std::vector<std::string> log;  ///< what is recorded (logging/log_paths.h)
  std::string out;               ///< CSV file for that
  double log_rate = 100;         ///< [Hz] of properties in it
  bool no_cameras = false;       ///< nothing is drawn for cameras
  bool lenient = false;
};

int run(const RunOptions& options);

struct RenderOptions {
  std::string scene;
  double time = 0;                 ///< [s] of the picture, or of the video's beginning
  std::string view;                ///< name of a place (scene/scene_viewpoints.h)
  std::string camera;              ///< ROBOT.CAMERA instead
  std::string size;                ///< WIDTHxHEIGHT; empty: 1280x720
  std::string layer = "color";     ///< or depth, labels
  std::string light;               ///< instead of the scene's
  bool no_shadows = false;         ///< in pictures for people; cameras have what the scene says
  std::string out;                 ///< PNG file
  std::string video;               ///< video file
  double fps = 25;                 ///< of a video that is no camera's
  double slow = 1;                 ///< a video takes so many times longer than what it shows
  std::optional<double> duration;  ///< [s] of the video
  int threads = 1;
  std::optional<std::int64_t> seed;
  std::vector<std::string> overrides, events, pushes;
  bool lenient = false;
};

/// A picture or a video of a scene.
int render(RenderOptions options);

struct PlotOptions {
  std::string file;                   ///< CSV
  std::string out;                    ///< PNG file; empty: beside the table
  std::vector<std::string> patterns;  ///< columns to draw; none: all
};

/// A table of numbers over time as a picture.
int plot(const PlotOptions& options);

struct CheckOptions {
  std::string model;
  std::string json;     ///< file, "-" for standard output
  std::string picture;  ///< PNG file
  std::string roles;    ///< TOML file
  bool lenient = false;
};

int check(const CheckOptions& options);

struct ConvertOptions {
  std::string model;
  std::string out;  ///< MJCF file to write
  std::string fit;  ///< sphere, capsule, cylinder, box or best; empty: meshes stay meshes
  bool lenient = false;
  bool force = false;  ///< replace the file
};

/// URDF or MJCF to MJCF in our normal form, with a TOML file beside it.
int convert(const ConvertOptions& options);

struct BenchOptions {
  std::string json;  ///< file, "-" for standard output
};

/// Collision detection: tests and time per step.
int bench(const BenchOptions& options);

struct CompareCommand {
  compare::CompareOptions options;
  std::vector<std::string> thresholds;  ///< NAME=VALUE
  std::string json;                     ///< file, "-" for standard output
  std::string plots;                    ///< folder for PNG files
};

/// The same experiment at several levels of detail.
int compare(const CompareCommand& command);

/// `what`: levels, contacts, body_contacts, volumes, integrators, servo_laws, controllers, sensors, parts,
/// lenses, materials, scenes, models, properties.
int list(const std::string& what);

struct FitServoOptions {
  std::vector<std::string> logs;      ///< files and folders
  std::string model = "m4";           ///< of friction: m1 to m6
  std::string out;                    ///< servo file
  std::string servo;                  ///< type that firmware and voltage are taken from; empty: what the logs name
  std::string prior;                  ///< "none", a type or a file; empty: that of the type, if there is one
  std::vector<std::string> validate;  ///< logs that are not fitted
  std::string cross_validate;         ///< "trajectory" or "gain"; empty: no
  std::int64_t seed = 1;
  int starts = 4;
  double windows = 0.5;  ///< share of windows in what is minimized, 0 to 1
  int threads = 0;       ///< 0: as many as the machine has
  std::string json;      ///< file, "-" for standard output
};

/// Finds the numbers of a servo that explain logs of it.
int fit_servo(const FitServoOptions& options);

struct ReplayServoOptions {
  std::vector<std::string> logs;  ///< files and folders
  std::string servo;              ///< type or file
  std::string json;               ///< file, "-" for standard output
  std::string plot;               ///< folder for PNG files
};

/// Simulates a servo as logs drove a real one, and says how far it is off.
int replay_servo(const ReplayServoOptions& options);

struct LensOptions {
  std::string file;   ///< calibration (YAML), or the name of one that comes with the program
  std::string model;  ///< to convert it to; empty: no
  std::string out;    ///< calibration to write
};

/// What a camera's calibration says, and the same in the words of another lens model.
int lens(const LensOptions& options);

}  // namespace murosimf::app

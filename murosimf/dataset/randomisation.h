/// randomisation.h - what varies from picture to picture of a data set, and how far: the TOML file of `--randomise` (docs/dataset.md).
///
/// What a file does not name does not vary: the defaults here are fixed values.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/dataset/dice.h"
#include "murosimf/model/shape.h"

namespace murosimf::dataset {

struct PictureRanges {
  std::string format = "png";  ///< of colors: png or jpeg
  Range jpeg_quality{90, 90};  ///< [%]
  double samples = 4;          ///< to a pixel: 1, 2, 4 or 8
  double validation = 0.2;     ///< [1] share of pictures for validation
  double least_pixels = 12;    ///< what shows fewer is not annotated
};

struct LightRanges {
  std::vector<std::string> presets{"hall"};
  Range brightness{1, 1};       ///< [1] of all light
  Range elevation_deg{60, 60};  ///< of the lamp that casts shadows
  Range warmth{0, 0};           ///< [1] red light more, blue less
  double shadows = 1;           ///< [1] chance
  double other_colors = 0;      ///< [1] chance that floor, walls, ceiling, hedge and sky are painted anew
  Range wall_distance{3.5, 3.5}, wall_height{4.5, 4.5};  ///< [m]
};

struct FieldRanges {
  Range hue_deg{125, 125};  ///< of the grass, as HSV
  Range saturation{0.58, 0.58}, value{0.5, 0.5};
  Range paint{0.93, 0.93};                                    ///< [1] of lines
  Range stripe_width{0.5, 0.5}, stripe_contrast{0.05, 0.05};  ///< [m], [1]
};

struct BallRanges {
  double present = 1;                         ///< [1] chance
  double in_view = 0.8;                       ///< [1] chance that it is placed where the camera looks
  Range distance{0.3, 6};                     ///< [m] from the camera, if it is
  std::vector<Color> colors{{1, 0.45, 0.1}};  ///< one of these
  double any_color = 0;                       ///< [1] chance of another one
  double panels = 1;                          ///< [1] chance that its panels are seen
  double in_air = 0;                          ///< [1] chance
  Range height{0.1, 0.6};                     ///< [m] of its lowest point in the air
};

struct RobotRanges {
  double present = 0.8;                             ///< [1] chance of each
  double in_view = 0.5;                             ///< [1] chance of each that it is placed where the camera looks
  Range distance{0.5, 6};                           ///< [m] from the camera, if it is
  double standing = 0.3, moving = 0.5, down = 0.2;  ///< [1] weights of postures
  Range joint_jitter{0, 0};                         ///< [rad] by which joints differ from the posture
  double team_colors = 0;                           ///< [1] chance that teams have other colors
  double recorded = 6;                              ///< [s] of the scene from which postures come
};

struct PeopleRanges {
  double count = 0;       ///< at most
  double present = 0.5;   ///< [1] chance of each
  double on_field = 0.2;  ///< [1] chance of each: referees; all others stand around the field
  double in_view = 0.5;   ///< [1] chance of each that it is placed where the camera looks
  double things = 0;      ///< boxes, barrels and bags around the field, at most
  double thing_present = 0.5;
};

struct CameraRanges {
  double of_robot = 0.7;                ///< [1] chance that a robot's own camera looks
  Range pan_deg{0, 0}, tilt_deg{0, 0};  ///< by which it is turned
  Range roll_deg{0, 0};
  Range height{0.3, 2};  ///< [m] of free cameras
  double margin = 1;     ///< [m] around the field in which they are
};

struct LensRanges {
  double count = 1;                                        ///< lenses of a data set
  double perspective = 1, plumb_bob = 0, equidistant = 0;  ///< [1] weights
  Range fov_deg{70, 70};                                   ///< from the left to the right border
  Range k1{0, 0}, k2{0, 0}, p{0, 0};                       ///< [1] of plumb_bob; k1 and k2 also of equidistant
};

struct SensorRanges {
  Range exposure{1, 1};                      ///< [1]
  Range white_balance{0, 0};                 ///< [1] by which red and blue light differ from green
  Range vignetting{0, 0};                    ///< [1]
  Range blur{0, 0};                          ///< [px]
  Range shot_noise{0, 0}, read_noise{0, 0};  ///< [1]
  double motion_blur = 0;                    ///< [1] chance
  Range exposure_time{0.005, 0.02};          ///< [s] with motion blur
  Range turning{0, 1.5};                     ///< [rad/s] of the camera then
};

struct Randomisation {
  PictureRanges picture;
  LightRanges light;
  FieldRanges field;
  BallRanges ball;
  RobotRanges robots;
  PeopleRanges people;
  CameraRanges camera;
  LensRanges lens;
  SensorRanges sensor;
  std::string text;  ///< of the file
};

/// `name`: a file, or the name of one that comes with the program ("soccer"). Throws SetupError with file:line:column: no such file, an
/// unknown section, key or name, a number out of its bounds, a fraction where a count is meant, weights that are all 0.
[[nodiscard]] Randomisation read_randomisation(const std::filesystem::path& name);

}  // namespace murosimf::dataset

/// render_options.h - options of `murosimf render`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/scene_arguments.h"

namespace murosimf::app {

struct RenderOptions {
  SceneArguments scene;
  double time = 0;                    ///< [s] of the picture, or of the video's beginning
  std::string view;                   ///< name of a place (scene/scene_viewpoints.h)
  std::vector<std::string> follow;    ///< names; "all"; instead of a place
  std::string sheet;                  ///< COLUMNSxROWS; empty: one picture
  std::string camera;                 ///< ROBOT.CAMERA instead
  std::string inset;                  ///< ROBOT.CAMERA in a corner; empty: none
  std::string size;                   ///< WIDTHxHEIGHT; empty: 1280x720
  std::string layer = "color";        ///< or depth, labels, depth_shown, labels_shown
  std::string light;                  ///< instead of the scene's
  bool stance = false;                ///< standing feet of kinematic walkers are yellow
  bool no_shadows = false;            ///< in pictures of viewpoints; those of cameras are as in the scene
  std::vector<std::string> drawings;  ///< groups, "blue1/ball", "roboviz/ball"; "all"; none
  std::vector<std::string> overlay;   ///< words of picture_overlay.h; none
  std::string dataset;                ///< folder of labelled pictures instead
  std::int64_t frames = 1000;         ///< how many
  std::string randomise = "soccer";   ///< what varies in them
  bool normals = false;               ///< they have normals, too
  std::string out;                    ///< PNG file
  std::string video;                  ///< video file
  double fps = 25;                    ///< of a video that is no camera's
  double slow = 1;                    ///< a video takes so many times longer than what it shows
  std::optional<double> duration;     ///< [s] of the video
};

}  // namespace murosimf::app

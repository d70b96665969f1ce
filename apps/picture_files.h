/// picture_files.h - a picture or a video of a running scene.
#pragma once

#include "apps/picture_source.h"

namespace murosimf::app {

/// Runs to the step that is nearest to `time`, and shows how far it is.
void run_with_progress(Simulation& simulation, Duration time);

/// Of now. False if it was interrupted.
bool write_picture(PictureSource& source, Simulation& simulation, const RenderOptions& options);

/// `duration` [s] from now. False if it was interrupted before the first picture.
bool write_video(PictureSource& source, Simulation& simulation, const RenderOptions& options, double duration);

[[noreturn]] void refuse_no_time();

}  // namespace murosimf::app

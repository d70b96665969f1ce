/// render_dataset.h - `murosimf render SCENE --dataset FOLDER`: labelled pictures to train vision with.
#pragma once

#include "apps/render_options.h"

namespace murosimf::app {

/// Returns the exit code. Throws SetupError.
[[nodiscard]] int render_dataset(const RenderOptions& options);

}  // namespace murosimf::app

/// dataset.h - makes a folder of labelled pictures of a scene: `murosimf render SCENE --dataset FOLDER` (docs/dataset.md).
///
/// Each picture is a pure function of scene, randomisation, seed and its number, so pictures are the same for any number of threads, and a
/// data set that was interrupted is continued by the same call.
#pragma once

#include "murosimf/dataset/request.h"

namespace murosimf::dataset {

struct Outcome {
  std::uint64_t drawn = 0, already = 0;  ///< pictures of this call, and those that were there
  bool complete = false;                 ///< false: it was told to stop
};

/// Throws SetupError: errors in scene or randomisation, a folder with other contents, files that cannot be written, or if nothing can be
/// drawn here; pictures that are complete by then stay.
Outcome write_dataset(const Request& request);

}  // namespace murosimf::dataset

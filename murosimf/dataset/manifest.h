/// manifest.h - what a data set was made from: with it the same pictures are made again, and only with the same it is continued.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "murosimf/dataset/randomisation.h"
#include "murosimf/dataset/request.h"
#include "murosimf/dataset/stage.h"

namespace murosimf::dataset {

constexpr const char* manifest_name = "manifest.json";

[[nodiscard]] nlohmann::json manifest_of(const Request& request, const Randomisation& randomisation,
                                         const Stage& stage);

/// An empty folder, none, or one with a manifest: before anything is computed. Halves of a manifest, which a call that was killed leaves,
/// do not count. Throws SetupError for all others.
void check_folder(const std::filesystem::path& folder);

/// Throws SetupError with the first key that differs from what the folder has, or if that has more pictures; without a manifest there
/// nothing.
void check_continued(const std::filesystem::path& folder, const nlohmann::json& manifest);

}  // namespace murosimf::dataset

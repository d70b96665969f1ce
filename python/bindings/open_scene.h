/// open_scene.h - scenes of files, texts and robots.
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "murosimf/scene.h"

namespace murosimf::python {

/// In the order in which the package gives them: threads, seed, set, events, pushes, libraries, lenient, cameras.
using Options = std::tuple<int, std::optional<std::uint64_t>, std::vector<std::string>, std::vector<std::string>,
                           std::vector<std::string>, bool, bool, bool>;

[[nodiscard]] SceneOptions options_of(Options options);

void bind_opening(nanobind::module_& module);

}  // namespace murosimf::python

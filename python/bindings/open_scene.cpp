#include "open_scene.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <tuple>
#include <utility>

#include "scene_ref.h"

namespace nb = nanobind;

namespace murosimf::python {

SceneOptions options_of(Options options) {
  auto& [threads, seed, set, events, pushes, libraries, lenient, cameras] = options;
  return {.threads = threads,
          .seed = seed,
          .set = std::move(set),
          .events = std::move(events),
          .pushes = std::move(pushes),
          .libraries = libraries,
          .lenient = lenient,
          .cameras = cameras};
}

void bind_opening(nb::module_& module) {
  const auto options = nb::arg("options");
  const nb::call_guard<nb::gil_scoped_release> unlocked{};
  module.def(
      "open_file",
      [](const std::string& name, Options given) {
        const bool threads = std::get<0>(given) > 1;
        return SceneRef(Scene(name, options_of(std::move(given))), threads);
      },
      nb::arg("name"), options, unlocked);
  module.def(
      "open_text",
      [](const std::string& toml, Options given) {
        const bool threads = std::get<0>(given) > 1;
        return SceneRef(Scene::of_text(toml, options_of(std::move(given))), threads);
      },
      nb::arg("toml"), options, unlocked);
  module.def(
      "open_robot",
      [](const std::string& model, Options given) {
        const bool threads = std::get<0>(given) > 1;
        return SceneRef(Scene::of_robot(model, options_of(std::move(given))), threads);
      },
      nb::arg("model"), options, unlocked);
}

}  // namespace murosimf::python

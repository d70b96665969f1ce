#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arrays.h"
#include "batch_state.h"
#include "handles.h"
#include "module.h"
#include "open_scene.h"
#include "scene_ref.h"

namespace murosimf::python {
namespace {

using Triple = std::array<double, 3>;

struct BatchRef {
  std::shared_ptr<BatchState> state;
};

using Worlds = nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

BatchRef open(const std::string& scene, std::size_t worlds, Options options, int threads) {
  const bool has_threads = threads > 1 || std::get<0>(options) > 1;
  return {std::make_shared<BatchState>(Batch(scene, worlds, options_of(std::move(options)), threads), has_threads)};
}

void reset(BatchRef& ref, std::optional<std::uint64_t> seed, const Worlds& which) {
  const BatchUse use(*ref.state, BatchUse::Kind::changes);
  const std::span<const std::uint8_t> worlds{which.data(), which.size()};
  const nb::gil_scoped_release unlocked;
  seed ? ref.state->batch.reset(*seed, worlds) : ref.state->batch.reset(worlds);
  ref.state->targets_begin_again(worlds);
}

/// (worlds, side), live.
Array<const double> shown_rows(BatchRef& ref, std::optional<std::size_t> side, BatchRows which) {
  const BatchUse use(*ref.state);
  const std::span<const double> rows = ref.state->rows(which);
  const std::size_t columns = side.value_or(ref.state->batch.joints());
  return shown<const double>(rows.data(), {rows.size() / columns, columns}, ref.state);
}

Array<const bool> fallen(BatchRef& ref) {
  const BatchUse use(*ref.state);
  const std::span<const std::uint8_t> fallen = ref.state->fallen();
  return shown<const bool>(reinterpret_cast<const bool*>(fallen.data()), {fallen.size()}, ref.state);
}

void push(BatchRef& ref, std::size_t world, const std::string& object, const Triple& force, double duration,
          const Triple& moment) {
  const BatchUse use(*ref.state);
  ref.state->batch.push(world, object, vector_of(force), duration, vector_of(moment));
}

Array<double> joint_target(BatchRef& ref) {
  const BatchUse use(*ref.state);
  std::vector<double>& targets = ref.state->targets();
  return shown<double>(targets.data(), {ref.state->batch.size(), ref.state->batch.joints()}, ref.state);
}

}  // namespace

void bind_batches(nb::module_& module) {
  nb::class_<BatchRef>(module, "Batch")
      .def("size", [](const BatchRef& ref) { return ref.state->batch.size(); })
      .def("joints", [](const BatchRef& ref) { return ref.state->batch.joints(); })
      .def(
          "world",
          [](BatchRef& ref, std::size_t number) {
            const BatchUse use(*ref.state);
            return SceneRef(ref.state->world(number));
          },
          nb::arg("number"))
      .def(
          "step", [](BatchRef& ref, std::int64_t steps) { ref.state->step(steps); }, nb::arg("steps"))
      .def("reset", &reset, nb::arg("seed").none(), nb::arg("which"))
      .def("joint_position", [](BatchRef& ref) { return shown_rows(ref, {}, BatchRows::joint_position); })
      .def("joint_velocity", [](BatchRef& ref) { return shown_rows(ref, {}, BatchRows::joint_velocity); })
      .def("base_pose", [](BatchRef& ref) { return shown_rows(ref, 7, BatchRows::base_pose); })
      .def("base_velocity", [](BatchRef& ref) { return shown_rows(ref, 6, BatchRows::base_velocity); })
      .def("ball_position", [](BatchRef& ref) { return shown_rows(ref, 3, BatchRows::ball_position); })
      .def("ball_velocity", [](BatchRef& ref) { return shown_rows(ref, 3, BatchRows::ball_velocity); })
      .def("push", &push, nb::arg("world"), nb::arg("object"), nb::arg("force"), nb::arg("duration"), nb::arg("moment"))
      .def("fallen", &fallen)
      .def("joint_target", &joint_target);
  module.def("open_batch", &open, nb::arg("scene"), nb::arg("worlds"), nb::arg("options"), nb::arg("threads"),
             nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace murosimf::python

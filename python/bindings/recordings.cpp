#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <tuple>

#include "arrays.h"
#include "module.h"
#include "murosimf/recording.h"
#include "scene_ref.h"

namespace murosimf::python {
namespace {

class RecorderRef {
 public:
  RecorderRef(SceneRef& scene, const std::string& file, double rate) : state_(scene.state) {
    const Use use(*state_);
    recorder_.emplace(state_->scene, file, rate);
    state_->threads = true;  // one writes
  }
  ~RecorderRef() {
    if (recorder_ && born_ != forks()) (void)new Recorder(std::move(*recorder_));  // the file is the parent's
  }
  RecorderRef(const RecorderRef&) = delete;
  RecorderRef& operator=(const RecorderRef&) = delete;

  void finish() {
    const Use use(*state_);
    const nb::gil_scoped_release unlocked;
    if (recorder_) recorder_->finish();
  }

 private:
  std::shared_ptr<SceneState> state_;
  std::optional<Recorder> recorder_;
  const unsigned born_ = forks();
};

/// Name, unit, times and values.
nb::list series_of(const Recording& recording, const std::string& pattern) {
  std::vector<Series> all;
  {
    const nb::gil_scoped_release unlocked;
    all = recording.series(pattern);
  }
  nb::list list;
  for (Series& series : all) {
    list.append(nb::make_tuple(series.name, series.unit, array_of(std::move(series.times)),
                               array_of(std::move(series.values))));
  }
  return list;
}

}  // namespace

void bind_recordings(nb::module_& module) {
  nb::class_<RecorderRef>(module, "Recorder")
      .def(nb::init<SceneRef&, const std::string&, double>(), nb::arg("scene"), nb::arg("file"), nb::arg("rate"))
      .def("finish", &RecorderRef::finish);
  nb::class_<Recording>(module, "Recording")
      .def(nb::init<const std::string&>(), nb::arg("file"), nb::call_guard<nb::gil_scoped_release>())
      .def("names", &Recording::names, nb::call_guard<nb::gil_scoped_release>())
      .def("series", &series_of, nb::arg("pattern"));
}

}  // namespace murosimf::python

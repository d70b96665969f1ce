#include "murosimf/dataset/dataset.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "murosimf/dataset/jpeg_bytes.h"
#include "murosimf/dataset/manifest.h"
#include "murosimf/dataset/painter.h"
#include "murosimf/dataset/random_camera.h"
#include "murosimf/dataset/summary.h"
#include "murosimf/files/json_document.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::dataset {
namespace {

/// Painters take one missing picture after the other, each in a thread of its own.
class Crew {
 public:
  Crew(const Request& request, const Folder& folder)
      : request_(request),
        missing_(folder.missing(request.pictures)),
        outcome_{.drawn = 0, .already = request.pictures - missing_.size(), .complete = missing_.empty()} {}

  [[nodiscard]] bool is_told_to_stop() const { return request_.options.stop && request_.options.stop(); }

  void work(std::vector<Painter>& painters) {
    {
      std::vector<std::jthread> threads;  // join when they go
      start(painters, threads);
      paint(painters[0]);
    }
    if (error_) std::rethrow_exception(error_);
    outcome_.complete = outcome_.drawn == missing_.size();
  }
  [[nodiscard]] const Outcome& outcome() const { return outcome_; }

 private:
  /// Where the system has no more threads, fewer make the same pictures.
  void start(std::vector<Painter>& painters, std::vector<std::jthread>& threads) {
    threads.reserve(painters.size());
    try {
      for (std::size_t i = 1; i < painters.size(); ++i) threads.emplace_back([&, i] { paint(painters[i]); });
    } catch (const std::system_error&) {
      return;
    }
  }

  void paint(Painter& painter) {
    try {
      while (!failed_ && !is_told_to_stop()) {
        const std::size_t next = next_++;
        if (next >= missing_.size()) return;
        painter.paint(missing_[next]);
        const std::lock_guard lock(mutex_);
        ++outcome_.drawn;
        if (request_.progress) request_.progress(outcome_.already + outcome_.drawn);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      failed_ = true;
    }
  }

  const Request& request_;
  const std::vector<std::uint64_t> missing_;
  std::atomic<std::size_t> next_ = 0;  // of these
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // of these
  Outcome outcome_;
  std::exception_ptr error_;
};

std::vector<Painter> painters_of(const Studio& studio, int count) {
  std::vector<Painter> painters;
  scene::Scene& scene = studio.stage->scene();
  for (int i = 0; i < std::max(count, 1); ++i)  // the light is each picture's own
    painters.emplace_back(studio, scene::make_camera_renderer(scene.parts(), scene.spec().light));
  return painters;
}

/// The manifest first: a folder with anything else in it is continued only by what it says.
void prepare(const Folder& folder, const Request& request, const nlohmann::json& manifest) {
  check_continued(folder.root(), manifest);
  folder.make_root();
  folder.remove_parts();
  folder.replace(manifest_name, files::json_text(manifest));
  folder.make(request.normals);
}

}  // namespace

Outcome write_dataset(const Request& request) {
  check_jpeg_bytes();
  check_folder(request.folder);
  const Randomisation randomisation = read_randomisation(request.randomisation);
  const Stage stage(request.scene, request.options, randomisation);
  const std::uint64_t seed = stage.scene().spec().seed;
  const Folder folder(request.folder, randomisation.picture.format == "jpeg" ? "jpg" : "png",
                      randomisation.picture.validation, seed);
  Crew crew(request, folder);
  // postures may be missing then
  if (crew.is_told_to_stop()) return {.drawn = 0, .already = crew.outcome().already, .complete = false};
  const Studio studio{.stage = &stage,
                      .randomisation = &randomisation,
                      .folder = &folder,
                      .lenses = random_lenses(randomisation.lens, request.width, request.height, seed),
                      .seed = seed,
                      .normals = request.normals};
  std::vector<Painter> painters = painters_of(studio, request.options.threads);
  prepare(folder, request, manifest_of(request, randomisation, stage));
  crew.work(painters);
  if (crew.outcome().complete) write_summary(folder, stage.categories(), request.pictures);
  return crew.outcome();
}

}  // namespace murosimf::dataset

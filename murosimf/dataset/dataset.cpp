#include "murosimf/dataset/dataset.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "murosimf/dataset/manifest.h"
#include "murosimf/dataset/painter.h"
#include "murosimf/dataset/picture_bytes.h"
#include "murosimf/dataset/random_camera.h"
#include "murosimf/dataset/summary.h"
#include "murosimf/files/json_document.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene_pictures.h"

namespace murosimf::dataset {
namespace {

/// Painters take one picture after the other, each in a thread of its own.
class Crew {
 public:
  Crew(const Request& request, const Folder& folder) : request_(request), folder_(folder) {}

  void work(std::vector<Painter>& painters) {
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < painters.size(); ++i) threads.emplace_back([&, i] { paint(painters[i]); });
    paint(painters[0]);
    for (std::thread& thread : threads) thread.join();
    if (error_) std::rethrow_exception(error_);
  }
  [[nodiscard]] Outcome outcome() const { return {drawn_, there_ - drawn_, there_ == request_.pictures}; }

 private:
  [[nodiscard]] bool ends() const { return failed_ || (request_.options.stop && request_.options.stop()); }

  void paint(Painter& painter) {
    try {
      while (!ends()) {
        const std::uint64_t picture = next_++;
        if (picture >= request_.pictures) return;
        const bool already = folder_.has(picture);
        if (!already) painter.paint(picture);
        const std::lock_guard lock(mutex_);
        ++there_;
        if (!already) ++drawn_;
        if (request_.progress) request_.progress(there_);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      failed_ = true;
    }
  }

  const Request& request_;
  const Folder& folder_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // of these
  std::uint64_t there_ = 0, drawn_ = 0;
  std::exception_ptr error_;
};

/// What says something about the light of the scene does not count: each picture has its own.
std::unique_ptr<render::Renderer> make_renderer(const Stage& stage) {
  return scene::make_renderer(stage.scene(), stage.scene().spec().light);
}

}  // namespace

Outcome write_dataset(const Request& request) {
  check_picture_bytes();
  check_folder(request.folder);
  const Randomisation randomisation = read_randomisation(request.randomisation);
  const Stage stage(request.scene, request.options, randomisation);
  const std::uint64_t seed = stage.scene().spec().seed;
  const Folder folder(request.folder, randomisation.picture.format == "jpeg" ? "jpg" : "png",
                      randomisation.picture.validation, seed);
  const Studio studio{.stage = &stage,
                      .randomisation = &randomisation,
                      .folder = &folder,
                      .lenses = random_lenses(randomisation.lens, request.width, request.height, seed),
                      .seed = seed,
                      .normals = request.normals};
  std::vector<Painter> painters;
  std::string drawn_by;
  for (int i = 0; i < request.options.threads; ++i) {
    auto renderer = make_renderer(stage);
    drawn_by = renderer->name();
    painters.emplace_back(studio, std::move(renderer));
  }
  const nlohmann::json manifest = manifest_of(request, randomisation, stage, drawn_by);
  check_continued(request.folder, manifest);
  folder.make(request.normals);
  folder.remove_parts();
  folder.replace(manifest_name, files::json_text(manifest));
  Crew crew(request, folder);
  crew.work(painters);
  const Outcome outcome = crew.outcome();
  if (outcome.complete) write_summary(folder, stage.categories(), request.pictures);
  return outcome;
}

}  // namespace murosimf::dataset

/// recording.h - a run as an MCAP file for Foxglove, Lichtblick, PlotJuggler and `murosimf replay`, and its numbers read back.
///
///     murosimf::Recorder recorder(scene, "run.mcap");
///     scene.run(10.0);
///     recorder.finish();
///     const murosimf::Series z = murosimf::Recording("run.mcap").series("walker.torso.position.z").front();
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/scene.h"

namespace murosimf {

namespace api {
struct RecorderInside;
struct RecordingInside;
}  // namespace api

inline namespace v0 {

/// Recording changes no result. `murosimf rerun` repeats the run and what Scene::change did; what a program sets otherwise (targets, poses,
/// controllers of its own) is not recorded.
class MUROSIMF_API Recorder {
 public:
  /// The file begins with the next step; `rate` [Hz] of poses, joints and contacts, sensors have their own. A reset ends what is recorded.
  /// Throws InputError for a file that cannot be written, and for an impossible rate.
  Recorder(const Scene& scene, const std::string& file, double rate = 100);
  /// Finishes the file unless finish() was called; errors are ignored then.
  ~Recorder();
  Recorder(Recorder&&) noexcept;
  Recorder& operator=(Recorder&&) noexcept;

  /// Writes what is missing: the file is whole then. Throws Error if it could not be written.
  void finish();

 private:
  std::unique_ptr<api::RecorderInside> inside_;
};

/// A number over time.
struct Series {
  std::string name;            ///< "walker.j_l_shin.joint_position"
  std::string unit;            ///< SI
  std::vector<double> times;   ///< [s] ascending
  std::vector<double> values;  ///< as many
};

class MUROSIMF_API Recording {
 public:
  /// Throws InputError: no such file, no recording, or nothing of it can be read.
  explicit Recording(const std::string& file);
  Recording(const Recording&) = default;  // moving copies, too
  Recording& operator=(const Recording&) = default;

  /// Names of all numbers.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Numbers that match a pattern, with * and ? in its parts; missing parts at the end match everything, so does an empty pattern.
  /// Throws InputError if it matches none.
  [[nodiscard]] std::vector<Series> series(const std::string& pattern = {}) const;

 private:
  std::shared_ptr<const api::RecordingInside> inside_;
};

}  // namespace v0
}  // namespace murosimf

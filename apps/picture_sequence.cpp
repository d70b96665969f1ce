#include "apps/picture_sequence.h"

#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

constexpr double shortest = 1e-3;  // [s]

Duration checked(double every) {
  if (!(every >= shortest && every <= scene::longest_duration)) {
    throw SetupError(fmt::format("--picture-every {}: must be at least {} s", every, shortest));
  }
  return from_seconds(every);
}

}  // namespace

PictureSequence::PictureSequence(std::filesystem::path folder, double every)
    : folder_(std::move(folder)), every_(checked(every)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw SetupError(fmt::format("cannot make the folder '{}': {}", folder_.string(), error.message()));
  files::check_writable(file());
}

void PictureSequence::take(const scene::Scene& scene) {
  scene.write_view(file());
  next_ += every_;
  ++count_;
}

std::filesystem::path PictureSequence::file() const { return folder_ / fmt::format("{:04}.png", count_); }

}  // namespace murosimf::app

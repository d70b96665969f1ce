// include/murosimf/batch.h.
#include "murosimf/batch.h"

#include <fmt/format.h>

#include "murosimf/api/batch_inside.h"

namespace murosimf {

inline namespace v0 {

Batch::Batch(const std::string& scene, std::size_t worlds, const SceneOptions& options, int threads) {
  if (worlds == 0) throw InputError("a batch of no worlds");
  if (threads < 1) throw InputError(fmt::format("threads = {}: at least 1", threads));
  inside_ = std::make_unique<api::BatchInside>(scene, worlds, options, threads);
}

Batch::~Batch() = default;
Batch::Batch(Batch&&) noexcept = default;
Batch& Batch::operator=(Batch&&) noexcept = default;

api::BatchInside& Batch::inside() const {
  if (!inside_) throw Error("this batch was moved from");
  return *inside_;
}

std::size_t Batch::size() const { return inside().size(); }

double Batch::step_length() const { return inside().step_length(); }

void Batch::check(std::size_t world) const {
  if (world >= size()) throw InputError(fmt::format("world {} of a batch of {}", world, size()));
}

Scene Batch::world(std::size_t number) const {
  check(number);
  return Scene(inside().whole(number));
}

std::uint64_t Batch::state_hash(std::size_t world) const {
  check(world);
  return inside().state_hash(world);
}

void Batch::step(int steps) {
  if (steps < 0) throw InputError(fmt::format("{} steps", steps));
  inside().step(steps);
}

void Batch::reset(std::span<const std::uint8_t> which) { reset(inside().seed(), which); }

/// Each world has a seed of its own, also after a reset.
void Batch::reset(std::uint64_t seed, std::span<const std::uint8_t> which) {
  if (!which.empty() && which.size() != size()) {
    throw InputError(fmt::format("reset takes {} entries, one for each world, not {}", size(), which.size()));
  }
  inside().reset(seed, which);
}

void Batch::randomize(const std::vector<Randomized>& properties) { inside().randomize(properties); }

std::size_t Batch::joints() const { return inside().joints(); }

std::span<const double> Batch::joint_position() { return inside().show().position; }

std::span<const double> Batch::joint_target() { return inside().show().target; }

std::span<const double> Batch::joint_velocity() { return inside().show().velocity; }

std::span<const double> Batch::base_pose() { return inside().show().pose; }

std::span<const double> Batch::base_velocity() { return inside().show().base_velocity; }

std::span<const std::uint8_t> Batch::fallen() { return inside().show().fallen; }

std::span<const double> Batch::ball_position() { return inside().show_ball().position; }

std::span<const double> Batch::ball_velocity() { return inside().show_ball().velocity; }

void Batch::push(std::size_t world, std::string_view object, const Vector3& force, double duration,
                 const Vector3& moment) {
  check(world);
  inside().push(world, object, force, duration, moment);
}

std::span<const float> Batch::observe(const std::vector<std::string>& names) { return inside().observe(names); }

void Batch::set_level(const std::string& level) { inside().set_level(level); }

void Batch::set_joint_target(std::span<const double> targets) { inside().set_targets(targets); }

}  // namespace v0
}  // namespace murosimf

#include "murosimf/soccer/particle_filter.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::soccer {
namespace {

constexpr double cluster_radius = 0.5;          // [m]
constexpr double cluster_turn = 30 * pi / 180;  // [rad]

/// Mean and standard deviations of the particles within the cluster around `center`.
PoseEstimate mean_around(std::span<const Particle> particles, const Vec3d& center) noexcept {
  // Differences from the center: headings are averaged without a jump at pi.
  double sum = 0;
  Vec3d first, second;
  for (const Particle& particle : particles) {
    const Vec3d d{particle.pose.x - center.x, particle.pose.y - center.y, wrapped(particle.pose.z - center.z)};
    if (std::hypot(d.x, d.y) > cluster_radius || std::abs(d.z) > cluster_turn) continue;
    sum += particle.weight;
    first += particle.weight * d;
    second += particle.weight * Vec3d{d.x * d.x, d.y * d.y, d.z * d.z};
  }
  if (!(sum > 0)) return {center, {}};
  const Vec3d mean = (1 / sum) * first, square = (1 / sum) * second;
  const auto deviation = [](double s, double m) { return std::sqrt(std::max(0.0, s - m * m)); };
  return {{center.x + mean.x, center.y + mean.y, wrapped(center.z + mean.z)},
          // (also the variance is free of cancellation, as the differences are small)
          {deviation(square.x, mean.x), deviation(square.y, mean.y), deviation(square.z, mean.z)}};
}

double effective_number(std::span<const Particle> particles) noexcept {
  double squares = 0;
  MUROSIMF_ASSERT(!particles.empty());
  for (const Particle& particle : particles) squares += particle.weight * particle.weight;
  return 1 / squares;
}

}  // namespace

ParticleFilter::ParticleFilter(const ParticleFilterOptions& options, std::uint64_t seed, const std::string& name)
    : options_(options),
      scatter_(seed, name + "/scatter"),
      motion_(seed, name + "/motion"),
      draw_(seed, name + "/draw"),
      logs_(static_cast<std::size_t>(options.particles)),
      drawn_(static_cast<std::size_t>(options.particles)) {
  MUROSIMF_ASSERT(options.particles > 0);
}

void ParticleFilter::reseed(std::uint64_t seed) noexcept {
  for (RandomStream* stream : {&scatter_, &motion_, &draw_}) stream->reseed(seed);
}

std::vector<Particle> ParticleFilter::scatter(const Vec3d& start) const {
  const std::size_t count = logs_.size();
  std::vector<Particle> particles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = scatter_.normals(2 * i);
    const double turn = scatter_.normal(2 * i + 1);
    particles[i].pose = moved(start, {options_.prior.x * place[0], options_.prior.y * place[1], 0});
    particles[i].pose.z = wrapped(start.z + options_.prior.z * turn);
    particles[i].weight = 1 / static_cast<double>(count);
  }
  return particles;
}

void ParticleFilter::move(std::span<Particle> particles, const Vec3d& step_pose, double dt,
                          std::uint64_t step) const noexcept {
  MUROSIMF_ASSERT(dt >= 0 && particles.size() == logs_.size());
  const ParticleFilterOptions& o = options_;
  const double way = std::hypot(step_pose.x, step_pose.y), turn = std::abs(step_pose.z);
  const auto deviation = [](double moving, double amount, double resting, double time) {
    return std::sqrt(moving * moving * amount + resting * resting * time);
  };
  const Vec3d s{deviation(o.way_noise, way, o.time_noise.x, dt), deviation(o.way_noise, way, o.time_noise.y, dt),
                deviation(o.turn_noise, turn, o.time_noise.z, dt)};
  // Two draws for each particle: a step's numbers do not overlap those of the next step.
  const std::uint64_t first = 2 * step * particles.size();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto a = motion_.normals(first + 2 * i), b = motion_.normals(first + 2 * i + 1);
    particles[i].pose =
        moved(particles[i].pose, {step_pose.x + s.x * a[0], step_pose.y + s.y * a[1], step_pose.z + s.z * b[0]});
  }
}

double ParticleFilter::log_likelihood(const Vec3d& pose, std::span<const LinePoint> points,
                                      const LineDistanceField& lines) const noexcept {
  MUROSIMF_ASSERT(deviations_.size() == points.size());
  const double cosine = std::cos(pose.z), sine = std::sin(pose.z);
  double sum = 0, product = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3d& p = points[i].place;
    const double x = pose.x + cosine * p.x - sine * p.y, y = pose.y + sine * p.x + cosine * p.y;
    const double d = lines.distance(x, y) / deviations_[i];
    product *= options_.misread + (1 - options_.misread) * std::exp(-0.5 * d * d);
    if (product > 1e-200) continue;  // logarithms cost more than products
    sum += std::log(product);
    product = 1;
  }
  return sum + std::log(product);
}

void ParticleFilter::weigh(std::span<Particle> particles, std::span<const LinePoint> points,
                           const LineDistanceField& lines) noexcept {
  MUROSIMF_ASSERT(particles.size() == logs_.size());
  if (points.empty()) return;
  const double c = std::min(1.0, options_.independent_points / static_cast<double>(points.size()));
  double best = -1e300;
  deviations_.clear();
  for (const LinePoint& point : points) {  // once per picture, not per particle
    deviations_.push_back(options_.point_noise + options_.lean_noise * dot(point.place, point.place));
  }
  MUROSIMF_ASSERT(deviations_.size() == points.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    logs_[i] = c * log_likelihood(particles[i].pose, points, lines) + std::log(std::max(particles[i].weight, 1e-300));
    best = std::max(best, logs_[i]);
  }
  // Relative to the best: likelihoods of many points underflow.
  double total = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) total += particles[i].weight = std::exp(logs_[i] - best);
  for (Particle& particle : particles) particle.weight /= total;
}

bool ParticleFilter::resample(std::span<Particle> particles, std::uint64_t step) noexcept {
  MUROSIMF_ASSERT(!particles.empty() && particles.size() == drawn_.size());
  const auto count = static_cast<double>(particles.size());
  if (effective_number(particles) > 0.5 * count) return false;
  const double start = draw_.uniform(step);
  std::size_t source = 0;
  double sum = particles[0].weight;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double mark = (start + static_cast<double>(i)) / count;
    while (sum < mark && source + 1 < particles.size()) sum += particles[++source].weight;
    MUROSIMF_ASSERT(source < particles.size());
    drawn_[i] = {particles[source].pose, 1 / count};
  }
  std::copy(drawn_.begin(), drawn_.end(), particles.begin());
  return true;
}

PoseEstimate estimate(std::span<const Particle> particles) noexcept {
  if (particles.empty()) return {};
  const auto heaviest = std::max_element(particles.begin(), particles.end(),
                                         [](const Particle& a, const Particle& b) { return a.weight < b.weight; });
  PoseEstimate result{heaviest->pose, {}};
  for (int round = 0; round < 3; ++round) result = mean_around(particles, result.pose);
  return result;
}

}  // namespace murosimf::soccer

/// part.h - a part of a level of motion without the level: it gets the columns of an entity of its own.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::test {

/// An algorithm that does nothing but hold a part and the columns of poses.
template <class Part>
class Holder final : public Algorithm {
 public:
  template <class... Arguments>
  explicit Holder(Setup& setup, const Arguments&... arguments) : columns(setup), part(setup, arguments...) {}
  /// At rest at the origin; in debug builds columns begin as NaN.
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override {
    std::ranges::fill(columns.r, Vec3d{});
    std::ranges::fill(columns.R, Mat3d{});
    std::ranges::fill(columns.v, Vec3d{});
    std::ranges::fill(columns.w, Vec3d{});
    std::ranges::fill(columns.q, 0.0);
    std::ranges::fill(columns.qd, 0.0);
    std::ranges::fill(columns.Q, Quaterniond{});
    columns.remember_base();
  }
  void step(const Instant&) noexcept override {}

  dynamics::PoseColumns columns;
  Part part;
};

/// The part of a model at 1 kHz; tests call it step by step themselves.
template <class Part>
struct Alone {
  template <class... Arguments>
  explicit Alone(const Chain& chain, const Arguments&... arguments)
      : entity(simulation.world().add("robot", std::make_shared<const Model>("robot", chain))),
        holder(simulation.attach<Holder<Part>>("part", entity, 1000, arguments...)) {
    simulation.initialize();
    part = &holder.part;
  }
  [[nodiscard]] int index(const char* name) const { return entity.model().object_index(name); }
  [[nodiscard]] ObjectAccess object(const char* name) { return entity.object(name); }

  Simulation simulation;
  Entity& entity;
  Holder<Part>& holder;
  Part* part = nullptr;
};

}  // namespace murosimf::test

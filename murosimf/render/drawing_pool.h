/// drawing_pool.h - what draws one view at a time, one for each thread that draws at the same time.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/render/renderer.h"

namespace murosimf::render {

template <class Drawing>
class DrawingPool {
 public:
  /// One that no thread draws with, or a new one.
  [[nodiscard]] std::unique_ptr<Drawing> take(const RenderScene& scene) {
    // Drawings are made outside of the lock: that takes long.
    {
      const std::scoped_lock lock(mutex_);
      if (!free_.empty()) {
        auto drawing = std::move(free_.back());
        free_.pop_back();
        return drawing;
      }
    }
    return std::make_unique<Drawing>(scene);
  }
  void give_back(std::unique_ptr<Drawing> drawing, const DrawCount& drawn) {
    MUROSIMF_ASSERT(drawing != nullptr);
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(drawing));
    ++totals_.views;
    totals_.drawables += drawn.drawables;
    totals_.triangles += drawn.triangles;
  }
  /// One that has drawn nothing.
  void add(std::unique_ptr<Drawing> drawing) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(drawing));
  }
  [[nodiscard]] DrawTotals totals() const {
    const std::scoped_lock lock(mutex_);
    return totals_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<Drawing>> free_;
  DrawTotals totals_;
};

}  // namespace murosimf::render

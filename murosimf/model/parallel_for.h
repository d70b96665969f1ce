/// parallel_for.h - threads that take part in one step of an algorithm that concerns many entities.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

namespace murosimf {

class Entity;

class ParallelFor {
 public:
  virtual ~ParallelFor() = default;

  /// Calls work(i) for each entities[i], several at a time, each preferably in the thread to which that entity is assigned; returns when
  /// all are done. `work` must not throw, and must not access what it writes for another i: then the result does not depend on the
  /// assignment to threads. Not to be called within `work`.
  template <class Work>
  void for_each(std::span<const Entity* const> entities, Work&& work) {
    using Callable = std::remove_reference_t<Work>;
    share_out(
        entities, [](void* context, std::size_t i) { (*static_cast<Callable*>(context))(i); }, &work);
  }

 protected:
  using Call = void (*)(void* context, std::size_t i);

 private:
  virtual void share_out(std::span<const Entity* const> entities, Call call, void* context) noexcept = 0;
};

/// Without threads: one after the other.
class SerialFor final : public ParallelFor {
  void share_out(std::span<const Entity* const> entities, Call call, void* context) noexcept override {
    for (std::size_t i = 0; i < entities.size(); ++i) call(context, i);
  }
};

}  // namespace murosimf

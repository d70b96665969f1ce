#include "murosimf/multibody/loops.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::multibody {
namespace {

Loop::End end_at(const Model& model, int object) {
  Loop::End end{model.placement(object), {}};
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  for (int link = end.frame.link; link > 0; link = model.tree().links[link].parent) {
    end.path.insert(end.path.begin(), link);
  }
  return end;
}

Loop loop_at(const Model& model, int object, const LoopClosure& closure) {
  Loop loop{object, {end_at(model, model.object_index(closure.other)), end_at(model, object)}, closure.welded};
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  auto& [first, second] = loop.ends;
  if (first.frame.link == second.frame.link) {
    throw SetupError(
        fmt::format("model '{}', loop at '{}': '{}' is a part of the same body; name one that moves against it",
                    model.name(), model.objects()[object].name, closure.other));
  }
  // joints that both paths have in common move both frames alike
  while (!first.path.empty() && !second.path.empty() && first.path[0] == second.path[0]) {
    first.path.erase(first.path.begin());
    second.path.erase(second.path.begin());
  }
  return loop;
}

}  // namespace

std::vector<Loop> loops_of(const Model& model) {
  std::vector<Loop> loops;
  for (const int object : model.having(properties::loop_closure)) {
    loops.push_back(loop_at(model, object, *model.find(properties::loop_closure, object)));
  }
  return loops;
}

bool is_in(const Model& model, const Loop& loop, int joint) {
  MUROSIMF_ASSERT(joint >= 0 && joint < model.size());
  const int link = model.tree().link_of[joint];
  return std::ranges::any_of(loop.ends, [&](const Loop::End& end) { return std::ranges::count(end.path, link) > 0; });
}

bool is_in_loop(const Model& model, const std::vector<Loop>& loops, int joint) {
  return std::ranges::any_of(loops, [&](const Loop& loop) { return is_in(model, loop, joint); });
}

}  // namespace murosimf::multibody

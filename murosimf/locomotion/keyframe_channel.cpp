#include "murosimf/locomotion/keyframe_channel.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::locomotion {
namespace {

constexpr std::array<std::string_view, 2> sides{"left_foot.", "right_foot."};

}  // namespace

std::optional<FootAxis> foot_axis(std::string_view channel) {
  for (std::size_t side = 0; side < sides.size(); ++side) {
    if (!channel.starts_with(sides[side])) continue;
    const auto* found = std::find(foot_axes.begin(), foot_axes.end(), channel.substr(sides[side].size()));
    if (found != foot_axes.end()) return FootAxis{side, static_cast<std::size_t>(found - foot_axes.begin())};
  }
  return std::nullopt;
}

std::string channel_name(const FootAxis& foot) {
  MUROSIMF_ASSERT(foot.side < sides.size() && foot.axis < foot_axes.size());
  return fmt::format("{}{}", sides[foot.side], foot_axes[foot.axis]);
}

int joint_of_channel(const Model& model, std::string_view channel) {
  std::vector<std::string_view> known;
  for (const int joint : model.joints()) {
    if (model.objects()[joint].name == channel) return joint;
    known.emplace_back(model.objects()[joint].name);
  }
  throw SetupError(fmt::format("model '{}': {}", model.name(), unknown_name("joint or foot", channel, known)));
}

}  // namespace murosimf::locomotion

/// annotate.h - masks, boxes and keypoints of a picture that was drawn.
#pragma once

#include "murosimf/dataset/annotation.h"
#include "murosimf/dataset/arrangement.h"

namespace murosimf::dataset {

/// Numbers of instances: 1 and 2 are the goals at x < 0 and x > 0, then all that may move, in the order of labels; the same in all
/// pictures of a data set.
constexpr std::uint16_t instance_left_goal = 1, instance_right_goal = 2, instance_first_actor = 3;

/// `view` has depths and labels as seen from `from`; `drawn` shows the arrangement. What has fewer than `least_pixels` is left out.
[[nodiscard]] Annotated annotate(const Stage& stage, const Arrangement& arrangement, const sensors::View& view,
                                 const Viewpoint& from, const render::RenderScene& drawn, std::uint64_t least_pixels);

}  // namespace murosimf::dataset

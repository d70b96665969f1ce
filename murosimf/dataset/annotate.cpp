#include "murosimf/dataset/annotate.h"

#include <array>
#include <cmath>

#include "murosimf/dataset/keypoints.h"
#include "murosimf/dataset/run_lengths.h"
#include "murosimf/math/assert.h"

namespace murosimf::dataset {
namespace {

/// Pixels of one instance.
struct Pixels {
  int left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
  std::uint64_t count = 0;

  void add(int u, int v) {
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
    ++count;
  }
  [[nodiscard]] PixelBox box() const {
    PixelBox box;
    box.add(left, top);
    box.add(right + 1, bottom + 1);
    return box;
  }
};

template <class Inside>
std::string runs_of(const Pixels& pixels, int width, int height, const Inside& inside) {
  RunLengths runs;
  for (int u = pixels.left; u <= pixels.right; ++u) {
    const auto column = static_cast<std::uint64_t>(u) * static_cast<std::uint64_t>(height);
    for (int v = pixels.top; v <= pixels.bottom; ++v) {
      if (inside(u, v)) runs.add(column + static_cast<std::uint64_t>(v), 1);
    }
  }
  return run_length_text(runs.finish(static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height)));
}

class Annotator {
 public:
  Annotator(const Stage& stage, const Arrangement& arrangement, const sensors::View& view, const Viewpoint& from,
            std::uint64_t least_pixels)
      : stage_(stage),
        arrangement_(arrangement),
        view_(view),
        from_(from),
        finder_(from, view),
        least_pixels_(least_pixels),
        width_(view.labels.width()),
        height_(view.labels.height()),
        pixels_(instance_first_actor + stage.actors().size()) {
    result_.instances = imaging::NumberImage(width_, height_);
    result_.classes = imaging::GrayImage(width_, height_);
  }

  Annotated annotate(const render::RenderScene& drawn) {
    sort_pixels();
    find_projected(drawn);
    for (const Actor& actor : stage_.actors()) add_actor(actor);
    add_goals();
    add_ground();
    return std::move(result_);
  }

 private:
  void sort_pixels() {
    for (int v = 0; v < height_; ++v) {
      for (int u = 0; u < width_; ++u) sort_pixel(u, v);
    }
  }

  void sort_pixel(int u, int v) {
    const std::uint16_t label = view_.labels(u, v);
    std::uint16_t instance = 0, kind = class_nothing;
    if (label == sensors::label_ground) kind = class_ground;
    if (label == sensors::label_line) kind = class_line;
    if (label == sensors::label_goal) {
      const auto place = from_.place({static_cast<double>(u), static_cast<double>(v)}, view_.depth(u, v));
      instance = place ? goal_at(*place) : std::uint16_t{0};
      kind = instance > 0 ? class_goal : class_thing;  // poles, ramps
    }
    if (label >= sensors::label_moving_entity) {
      const auto number = static_cast<std::size_t>(label - sensors::label_moving_entity);
      MUROSIMF_ASSERT(number < stage_.actors().size());
      instance = static_cast<std::uint16_t>(instance_first_actor + number);
      kind = stage_.actors()[number].category;
    }
    result_.instances(u, v) = instance;
    result_.classes(u, v) = static_cast<std::uint8_t>(kind);
    if (instance > 0) pixels_[instance].add(u, v);
    if (kind == class_ground || kind == class_line) ground_.add(u, v);
  }

  /// 0: it belongs to none.
  [[nodiscard]] std::uint16_t goal_at(const Vec3d& place) const {
    const scene_file::FieldSize& field = stage_.field();
    if (stage_.goals().empty() || std::abs(place.x) < 0.5 * field.length - 0.1 ||
        std::abs(place.x) > 0.5 * field.length + field.goal_depth + 0.2 ||
        std::abs(place.y) > 0.5 * field.goal_width + field.post_width + 0.1) {
      return 0;
    }
    return place.x < 0 ? instance_left_goal : instance_right_goal;
  }

  void find_projected(const render::RenderScene& drawn) {
    projected_.assign(pixels_.size(), ProjectedBox(from_));
    std::vector<std::uint16_t> instance_of(stage_.world().entities().size(), 0);
    for (std::size_t i = 0; i < stage_.actors().size(); ++i) {
      instance_of[stage_.actors()[i].place] = static_cast<std::uint16_t>(instance_first_actor + i);
    }
    drawn.for_drawables(0, [&](const render::Drawable& piece, const Transformd& pose) {
      std::uint16_t instance = instance_of[static_cast<std::size_t>(piece.owner)];
      if (instance == 0) instance = goal_at(pose.position);
      if (instance > 0 && pixels_[instance].count >= least_pixels_)
        projected_[instance].add(piece, pose, drawn.meshes());
    });
  }

  [[nodiscard]] Annotation annotation(std::uint16_t instance, std::uint16_t category, const std::string& name) const {
    const Pixels& pixels = pixels_[instance];
    Annotation one{.instance = instance, .category = category, .name = name, .box = pixels.box()};
    one.full = projected_[instance].box();
    one.area = pixels.count;
    one.runs = runs_of(pixels, width_, height_, [&](int u, int v) { return result_.instances(u, v) == instance; });
    return one;
  }

  void add_actor(const Actor& actor) {
    const auto instance = static_cast<std::uint16_t>(instance_first_actor + (&actor - stage_.actors().data()));
    if (pixels_[instance].count < least_pixels_) return;
    Annotation one = annotation(instance, actor.category, actor.entity->name());
    const std::size_t first = arrangement_.frame.first[actor.place];
    const Vec3d& base = arrangement_.frame.position[first];
    one.pose = {base, arrangement_.frame.orientation[first]};
    one.own = arrangement_.camera.starts_with(actor.entity->name() + ".");
    if (actor.role == Actor::Role::ball) one.keypoints = {finder_.inside(base, actor.label, 2 * actor.reach)};
    if (actor.role == Actor::Role::robot) one.keypoints = robot_keypoints(finder_, actor, arrangement_.frame);
    result_.annotations.push_back(std::move(one));
  }

  void add_goals() {
    for (const GoalPoints& goal : stage_.goals()) {
      const std::uint16_t instance = goal.side < 0 ? instance_left_goal : instance_right_goal;
      if (pixels_[instance].count < least_pixels_) continue;
      Annotation one = annotation(instance, class_goal, goal.side < 0 ? "goal_left" : "goal_right");
      for (const Vec3d& place : goal.places) one.keypoints.push_back(finder_.of_goal(place));
      result_.annotations.push_back(std::move(one));
    }
  }

  /// Floor, field and lines, with the crossings of lines.
  void add_ground() {
    if (ground_.count < least_pixels_) return;
    Annotation one{.instance = 0, .category = class_ground, .name = "ground", .box = ground_.box()};
    one.area = ground_.count;
    one.runs = runs_of(ground_, width_, height_, [&](int u, int v) {
      return result_.classes(u, v) == class_ground || result_.classes(u, v) == class_line;
    });
    for (const FieldPoint& point : stage_.crossings()) one.keypoints.push_back(finder_.on_ground(point.place));
    result_.annotations.push_back(std::move(one));
  }

  const Stage& stage_;
  const Arrangement& arrangement_;
  const sensors::View& view_;
  const Viewpoint& from_;
  KeypointFinder finder_;
  std::uint64_t least_pixels_;
  int width_, height_;
  std::vector<Pixels> pixels_;  // by instance
  Pixels ground_;
  std::vector<ProjectedBox> projected_;  // by instance
  Annotated result_;
};

}  // namespace

Annotated annotate(const Stage& stage, const Arrangement& arrangement, const sensors::View& view, const Viewpoint& from,
                   const render::RenderScene& drawn, std::uint64_t least_pixels) {
  return Annotator(stage, arrangement, view, from, least_pixels).annotate(drawn);
}

}  // namespace murosimf::dataset

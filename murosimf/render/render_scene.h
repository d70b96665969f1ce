/// render_scene.h - the pieces of a picture: of robots, ball and goals, and their present poses.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "murosimf/geometry/manifold.h"
#include "murosimf/render/look.h"
#include "murosimf/render/render_mesh.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/world/world.h"

namespace murosimf::render {

/// A surface on an object of a model.
struct ShownMesh {
  int object = 0;
  RenderMesh solid;  ///< [m] object frame
  Color color;
  bool as_it_is = false;  ///< the color counts even if it is gray: a material has it
};

/// A shape on an object of a model.
struct ShownShape {
  int object = 0;
  PlacedShape placed;
};

/// Appearance of an entity. Parts with an alpha of 0 are not drawn. Gray, the default color of shapes, is drawn in the entity's own
/// color, except on meshes that have it as it is.
struct EntityAppearance {
  std::vector<ShownMesh> meshes;
  std::vector<ShownShape> shapes;
};
using AppearanceOf = std::function<EntityAppearance(const Entity&)>;

/// The color in which an entity shows a part of `color`.
[[nodiscard]] Color color_on(const Entity& entity, const Color& color);

/// All shapes of the model.
[[nodiscard]] EntityAppearance appearance_of_shapes(const Entity& entity);

enum class Form { sphere, half_sphere, tube, cylinder, box, mesh };

/// One piece to draw. Solids of the forms have the size 1 and are scaled.
struct Drawable {
  int owner = 0, object = 0;
  Transformd place;  ///< of the solid in the frame of the object
  Vec3d scale{1, 1, 1};
  Form form = Form::box;
  int mesh = -1;  ///< RenderScene::meshes
  Color color;
  bool own_color = false;  ///< it has the color of its entity
  std::uint16_t label = 0;
  double radius = 0;           ///< [m] bounding radius about its origin
  Vec3d box_middle, box_half;  ///< [m] a box around it, in the axes of `place`
  bool paneled = false;        ///< a ball: light with patterns shows its panels
  int foot = -1;               ///< 0 or 1: of the model's first or second foot, where standing feet are marked
};

/// Poses at one moment, for drawing beside a running simulation: it must stay unchanged while it is shown.
struct ShownMoment {
  const PoseFrame* frame = nullptr;
  std::vector<int> standing_feet;              ///< by entity: 0 or 1, another number to mark none; may be empty
  std::vector<std::optional<Color>> colors{};  ///< by entity: instead of its own color; may be empty
  bool panels = true;                          ///< balls show theirs
};

/// The entities of a world that have shapes, without the ground.
class RenderScene {
 public:
  /// `moving_entities` get labels of their own. The world must outlive it, and its entities must exist.
  RenderScene(const World& world, const std::vector<Entity*>& moving_entities,
              const AppearanceOf& appearance = appearance_of_shapes);

  /// Finds the columns of poses; to be called when all algorithms are attached.
  void locate();

  /// Draws the foot on which a kinematic walker stands in this color (paper, Fig. 4).
  void mark_standing_feet(const Color& color);

  /// Shows the poses of that moment, and reads no column; null: shows the poses of the columns.
  void show(const ShownMoment* moment) { moment_ = moment; }

  /// Makes the label of each piece `first_piece_label` plus its number (drawables()), to find out what a pixel shows.
  static constexpr std::uint16_t first_piece_label = 16;
  void label_pieces();

  [[nodiscard]] const std::vector<Drawable>& drawables() const { return drawables_; }
  [[nodiscard]] const std::vector<RenderMesh>& meshes() const { return meshes_; }
  [[nodiscard]] const Entity* owner(const Drawable& drawable) const { return owners_[drawable.owner].entity; }
  /// Markings of the first entity that has some; null if none has.
  [[nodiscard]] const Markings* markings() const { return markings_; }
  /// Nets to look at: where boxes of the material "net" lie level above goals that do not move.
  [[nodiscard]] const std::vector<GoalNet>& nets() const { return nets_; }

  /// Calls visit(piece, pose) for each piece of the entities that are present; poses [m] in the world, extrapolated by `ahead` [s].
  template <class Visit>
  void for_drawables(double ahead, const Visit& visit) const;

 private:
  struct Owner {
    const Entity* entity;
    std::vector<Transformd> rest;    // poses of entities that do not move
    std::span<const Vec3d> r, v, w;  // empty for entities that do not move
    std::span<const Mat3d> R;
    std::span<const double> stance_foot, dynamic;  // empty for entities that never stand kinematically
    /// 0 or 1; another number if it does not stand kinematically at present.
    [[nodiscard]] int standing_foot() const {
      const bool stands = !stance_foot.empty() && !dynamic.empty() && dynamic[0] == 0;
      return !stands ? -2 : stance_foot[0] != 0 ? 1 : 0;
    }
  };
  void add_entity(Entity& entity, const std::vector<Entity*>& moving_entities, const AppearanceOf& appearance);
  void add_net(const Transformd& at, const Shape& shape);
  void add_shape(Drawable drawable, const PlacedShape& shape);
  void add_round(Drawable drawable, const Capsule& capsule);
  int add_mesh(const RenderMesh& solid, const void* identity = nullptr);
  [[nodiscard]] Transformd pose_of(int owner, int object, double ahead) const;
  [[nodiscard]] bool is_present(int owner) const;
  [[nodiscard]] int standing_foot(int owner) const;
  [[nodiscard]] std::optional<Drawable> as_shown(const Drawable& drawable) const;

  std::vector<Owner> owners_;        // by entity of the world
  std::vector<Drawable> drawables_;  // by owner and object
  std::vector<RenderMesh> meshes_;
  std::vector<const void*> identities_;  // of meshes that several robots share
  const Markings* markings_ = nullptr;
  std::vector<GoalNet> nets_;
  Color standing_{};  // of feet that are marked
  const ShownMoment* moment_ = nullptr;
};

// ---- definitions ----

template <class Visit>
void RenderScene::for_drawables(double ahead, const Visit& visit) const {
  int owner = -1, object = -1;
  Transformd at;
  for (const Drawable& drawable : drawables_) {
    if (!is_present(drawable.owner)) continue;
    if (drawable.owner != owner || drawable.object != object) at = pose_of(drawable.owner, drawable.object, ahead);
    owner = drawable.owner;
    object = drawable.object;
    const Transformd place{at.position + at.orientation * drawable.place.position,
                           at.orientation * drawable.place.orientation};
    if (const std::optional<Drawable> changed = as_shown(drawable)) {
      visit(*changed, place);
    } else {
      visit(drawable, place);
    }
  }
}

}  // namespace murosimf::render

/// scenery.h - what there is to be drawn: pieces of robots, ball and goals, and where they are now.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/world.h"
#include "murosimf/render/solid.h"

namespace murosimf::render {

/// A surface on an object of a model.
struct Looks {
  int object = 0;
  Solid solid;  ///< [m] object frame
  Color color;
};

/// A shape on an object of a model.
struct ShownShape {
  int object = 0;
  PlacedShape placed;
};

/// What an entity looks like. Gray, the color that things have by default, is drawn in the entity's own color.
struct EntityLooks {
  std::vector<Looks> solids;
  std::vector<ShownShape> shapes;
};
using LooksOf = std::function<EntityLooks(const Entity&)>;

/// The color in which an entity shows something of `color`.
[[nodiscard]] Color color_on(const Entity& entity, const Color& color);

/// All shapes of the model.
[[nodiscard]] EntityLooks looks_of_shapes(const Entity& entity);

enum class Form { sphere, half_sphere, tube, cylinder, box, mesh };

/// One thing to draw. Solids of the forms have the size 1 and are scaled.
struct Piece {
  int owner = 0, object = 0;
  geometry::Pose place;  ///< of the solid in the frame of the object
  Vec3d scale{1, 1, 1};
  Form form = Form::box;
  int mesh = -1;  ///< Scenery::meshes
  Color color;
  std::uint16_t label = 0;
  double radius = 0;  ///< [m] about its origin, all of it
};

/// The things of a world that have shapes, all but the ground.
class Scenery {
 public:
  /// `movers`: those that get labels of their own. The world must outlive it, and its entities must be there already.
  Scenery(const World& world, const std::vector<Entity*>& movers, const LooksOf& looks = looks_of_shapes);

  /// Reads the columns that there are; to be called when all of them are there.
  void locate();

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<Solid>& meshes() const { return meshes_; }
  [[nodiscard]] const Entity* owner(const Piece& piece) const { return owners_[piece.owner].entity; }
  /// Of the first entity that has some; null if none has.
  [[nodiscard]] const Markings* markings() const { return markings_; }

  /// Calls visit(piece, pose) for each piece; poses [m] in the world, moved on by `ahead` [s].
  template <class Visit>
  void for_pieces(double ahead, const Visit& visit) const;

 private:
  struct Owner {
    const Entity* entity;
    std::vector<geometry::Pose> rest;  // of what nothing moves
    std::span<const Vec3d> r, v, w;    // none of what nothing moves
    std::span<const Mat3d> R;
  };
  void add_entity(Entity& entity, const std::vector<Entity*>& movers, const LooksOf& looks);
  void add_shape(Piece piece, const PlacedShape& shape);
  void add_round(Piece piece, const Capsule& capsule);
  int add_mesh(const Solid& solid, const void* identity = nullptr);
  [[nodiscard]] geometry::Pose pose_of(const Owner& owner, int object, double ahead) const;

  std::vector<Owner> owners_;
  std::vector<Piece> pieces_;  // by owner and object
  std::vector<Solid> meshes_;
  std::vector<const void*> identities_;  // of meshes that several robots share
  const Markings* markings_ = nullptr;
};

// ---- definitions ----

template <class Visit>
void Scenery::for_pieces(double ahead, const Visit& visit) const {
  int owner = -1, object = -1;
  geometry::Pose at;
  for (const Piece& piece : pieces_) {
    if (piece.owner != owner || piece.object != object) at = pose_of(owners_[piece.owner], piece.object, ahead);
    owner = piece.owner;
    object = piece.object;
    visit(piece, geometry::Pose{at.position + at.orientation * piece.place.position,
                                at.orientation * piece.place.orientation});
  }
}

}  // namespace murosimf::render

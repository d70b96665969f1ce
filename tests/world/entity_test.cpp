#include "murosimf/world/entity.h"

#include <limits>

#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/world/world.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::difference;
using fixtures::error_of;
using fixtures::says;
using namespace properties;

ModelPtr robot() {
  static const ModelPtr model = std::make_shared<const Model>(fixtures::two_legged());
  return model;
}

/// A property whose value is no row of numbers.
struct Letter {
  char letter = 'a';
};
void append_hash(Hasher& hasher, const Letter& value) { hasher.add(static_cast<std::uint64_t>(value.letter)); }
constexpr Property<Letter> letter{{"letter", "-", "-", "for this test", Scope::base}};

// Rule: a column exists once it is requested; then it is always the same one.
TEST(EntityTest, ColumnsOnDemand) {
  Entity entity("blue1", robot());
  EXPECT_EQ(entity.find(joint_position), nullptr);
  EXPECT_TRUE(entity.columns().empty());
  const double* rows = entity.column(joint_position).values.data();
  entity.column(position);
  entity.column(walk_command);
  EXPECT_EQ(entity.column(joint_position).values.data(), rows);
  EXPECT_EQ(entity.find(joint_position)->values.data(), rows);
  EXPECT_EQ(entity.columns().size(), 3u);
  EXPECT_EQ(entity.find(joint_velocity), nullptr);
}

// Rule: one row per object, a single one for properties of the base.
TEST(EntityTest, RowsFollowTheScope) {
  Entity entity("blue1", robot());
  EXPECT_EQ(entity.column(joint_position).rows(), static_cast<std::size_t>(robot()->size()));
  EXPECT_EQ(entity.column(walk_command).rows(), 1u);
  EXPECT_EQ(entity.column(walk_command).numbers(), 3u);
  EXPECT_EQ(entity.column(letter).numbers(), 0u);
}

// Rule: one name, one type; the message names both sides.
TEST(EntityTest, TypeClash) {
  constexpr Property<Vec3d> other{{"joint_position", "m", "-", "of another owner"}};
  Entity entity("blue1", robot());
  entity.column(joint_position);
  EXPECT_TRUE(says(error_of([&] { entity.column(other); }), {"entity 'blue1'", "different type", "'joint_position'"}));
  EXPECT_EQ(entity.find(other), nullptr);
}

TEST(EntityTest, FrozenColumns) {
  Entity entity("blue1", robot());
  const double* rows = entity.column(joint_position).values.data();
  entity.columns().freeze();
  EXPECT_EQ(entity.column(joint_position).values.data(), rows);
  EXPECT_TRUE(says(error_of([&] { entity.column(joint_velocity); }), {"entity 'blue1'", "'joint_velocity'", "frozen"}));
  EXPECT_EQ(entity.find(joint_velocity), nullptr);
}

// Rule: columns that no algorithm writes show at once in debug builds (NaN), and is zero in release builds, for every number of
// a row, rotations included.
TEST(EntityTest, FreshColumns) {
  Entity entity("blue1", robot());
  entity.column(joint_position);
  entity.column(orientation);
  entity.column(external_damping);
  for (const auto& [name, column] : entity.columns()) {
    for (std::size_t row = 0; row < column->rows(); ++row) {
      for (std::size_t i = 0; i < column->numbers(); ++i) {
#ifndef NDEBUG
        EXPECT_TRUE(std::isnan(column->get(row, i))) << name;
#else
        EXPECT_EQ(column->get(row, i), 0) << name;
#endif
      }
    }
  }
  EXPECT_EQ(entity.column(letter).values[0].letter, 'a');
}

// Rule: entity -> object -> property reads and writes the column's row of that object and no other.
TEST(EntityTest, TypedAccess) {
  Entity entity("blue1", robot());
  auto& q = entity.column(joint_position).values;
  std::fill(q.begin(), q.end(), 0.0);
  entity.object("left_knee").set(joint_position, 0.25);
  for (int i = 0; i < robot()->size(); ++i) EXPECT_EQ(q[i], i == robot()->object_index("left_knee") ? 0.25 : 0);
  EXPECT_EQ(entity.object("left_knee").get(joint_position), 0.25);
  EXPECT_EQ(entity.object("left_knee").get(mass), 0.3);  // constants can be read the same way
  EXPECT_EQ(entity.object("left_knee").name(), "left_knee");
  entity.column(walk_command);
  entity.base().set(walk_command, {1, 2, 3});
  EXPECT_EQ(difference(entity.base().get(walk_command), {1, 2, 3}), 0);
  EXPECT_TRUE(
      says(error_of([&] { (void)entity.base().get(joint_velocity); }), {"'blue1'", "'trunk'", "'joint_velocity'"}));
  EXPECT_TRUE(
      says(error_of([&] { entity.base().set(joint_velocity, 1); }), {"'blue1'", "'trunk'", "'joint_velocity'"}));
}

// Rule: by name there are the same numbers, with their unit.
TEST(EntityTest, AccessByName) {
  Entity entity("blue1", robot());
  entity.column(joint_position);
  entity.column(external_force);
  const std::vector<double> angle{0.5};
  entity.object("right_knee").set("joint_position", angle);
  const Quantity q = entity.object("right_knee").get("joint_position");
  EXPECT_EQ(q.numbers, angle);
  EXPECT_EQ(q.unit, "rad | m");
  EXPECT_EQ(entity.object("right_knee").get(joint_position), 0.5);
  const std::vector<double> push{1, 2, 3, 4, 5, 6};
  entity.base().set("external_force", push);
  EXPECT_EQ(difference(entity.base().get(external_force).f, {1, 2, 3}), 0);  // force first
  EXPECT_EQ(difference(entity.base().get(external_force).n, {4, 5, 6}), 0);
  EXPECT_EQ(entity.base().get("external_force").numbers, push);
  const Quantity m = entity.object("right_knee").get("mass");
  EXPECT_EQ(m.numbers, (std::vector<double>{0.3}));
  EXPECT_EQ(m.unit, "kg");
}

// Rule: people see rotations row by row, quaternions as w x y z.
TEST(EntityTest, OrderOfNumbers) {
  Entity entity("blue1", robot());
  entity.column(orientation);
  entity.column(base_quaternion);
  entity.base().set(orientation, {{1, 4, 7}, {2, 5, 8}, {3, 6, 9}});  // given by columns
  EXPECT_EQ(entity.base().get("orientation").numbers, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  const std::vector<double> rows{9, 8, 7, 6, 5, 4, 3, 2, 1};
  entity.base().set("orientation", rows);
  EXPECT_EQ(difference(entity.base().get(orientation).x, {9, 6, 3}), 0);
  entity.base().set(base_quaternion, {0.1, 0.2, 0.3, 0.4});
  EXPECT_EQ(entity.base().get("base_quaternion").numbers, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
}

// Rule: what cannot be set by name is refused, and nothing changes.
TEST(EntityTest, RefusedValues) {
  Entity entity("blue1", robot());
  entity.column(walk_command);
  entity.base().set(walk_command, {1, 2, 3});
  const auto set = [&](std::string_view name, const std::vector<double>& numbers) {
    return error_of([&] { entity.base().set(name, numbers); });
  };
  EXPECT_TRUE(says(set("walk_command", {1, 2}), {"'blue1'", "'trunk'", "'walk_command' takes 3 numbers, not 2"}));
  EXPECT_TRUE(says(set("walk_command", {1, 2, 3, 4}), {"takes 3 numbers, not 4"}));
  EXPECT_TRUE(says(set("walk_command", {}), {"takes 3 numbers, not 0"}));
  entity.column(gait_phase);
  EXPECT_TRUE(says(set("gait_phase", {1, 2}), {"takes 1 number, not 2"}));
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(says(set("walk_command", {7, 8, nan_value}), {"'walk_command' cannot be"}));
  EXPECT_TRUE(says(set("walk_command", {7, infinity, 9}), {"cannot be inf"}));
  EXPECT_TRUE(says(set("mass", {2}), {"'mass' is a constant of the model"}));
  EXPECT_EQ(difference(entity.base().get(walk_command), {1, 2, 3}), 0);
}

// Rule: unknown names are answered with the nearest one.
TEST(EntityTest, UnknownNames) {
  Entity entity("blue1", robot());
  entity.column(joint_position);
  EXPECT_TRUE(says(error_of([&] { (void)entity.base().get("joint_positon"); }),
                   {"'blue1'", "'trunk'", "unknown property 'joint_positon'", "did you mean 'joint_position'?"}));
  const std::vector<double> one{1};
  EXPECT_TRUE(says(error_of([&] { entity.base().set("joint_positon", one); }), {"did you mean 'joint_position'?"}));
  EXPECT_TRUE(says(error_of([&] { (void)entity.object("left_kne"); }),
                   {"entity 'blue1'", "unknown object 'left_kne'", "did you mean 'left_knee'?"}));
  // no row of numbers: not for people
  entity.column(letter);
  EXPECT_TRUE(says(error_of([&] { (void)entity.base().get("letter"); }), {"unknown property 'letter'"}));
  EXPECT_EQ(entity.base().get(letter).letter, 'a');
}

// Rule: what the whole entity has once belongs to the base; elsewhere it is refused, typed and by name.
TEST(EntityTest, BaseScope) {
  Entity entity("blue1", robot());
  entity.column(gait_phase).values[0] = 0;
  ObjectAccess knee = entity.object("left_knee");
  const std::vector<double> one{1};
  EXPECT_TRUE(
      says(error_of([&] { (void)knee.get(gait_phase); }), {"'left_knee'", "'gait_phase'", "only the base 'trunk'"}));
  EXPECT_TRUE(says(error_of([&] { knee.set(gait_phase, 1); }), {"only the base 'trunk'"}));
  EXPECT_TRUE(says(error_of([&] { (void)knee.get("gait_phase"); }), {"only the base 'trunk'"}));
  EXPECT_TRUE(says(error_of([&] { knee.set("gait_phase", one); }), {"only the base 'trunk'"}));
  EXPECT_EQ(entity.base().get(gait_phase), 0);
}

// Rule: the list of an object's properties is what get() can show: each can be shown.
TEST(EntityTest, ListOfProperties) {
  Entity entity("blue1", robot());
  entity.column(joint_position);
  entity.column(gait_phase);
  entity.column(letter);
  EXPECT_EQ(entity.object("left_ankle").properties(), (std::vector<std::string_view>{"joint_position"}));
  const auto names = entity.base().properties();
  EXPECT_EQ(names.size(), 5u);  // joint_position, gait_phase, mass, center_of_mass, inertia
  for (const auto name : names) EXPECT_FALSE(entity.base().get(name).numbers.empty()) << name;
}

// Rule: names of entities fit into files and command lines; places are numbers.
TEST(EntityTest, NamesAndPlaces) {
  for (const char* bad : {"", "blue 1", "blue/1", "a.b", "*", "r\xc3\xb6\x62ot"}) {
    EXPECT_TRUE(says(error_of([&] { Entity(bad, robot()); }), {"entity name", "use letters"})) << bad;
  }
  EXPECT_EQ(error_of([] { Entity("Blue-team_1", robot()); }), "no error");
  EntityOptions options;
  options.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(error_of([&] { Entity("blue1", robot(), options); }), {"'blue1'", "finite"}));
  options.position.y = 0;
  options.heading = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(says(error_of([&] { Entity("blue1", robot(), options); }), {"'blue1'", "finite"}));
}

// Rule: the first reason for which an entity was frozen stays.
TEST(EntityTest, FrozenEntity) {
  Entity entity("blue1", robot());
  EXPECT_FALSE(entity.frozen());
  entity.freeze("first");
  entity.freeze("second");
  EXPECT_TRUE(entity.frozen());
  EXPECT_EQ(entity.frozen_reason(), "first");
}

// Rule: entities of a world have different names; unknown ones are answered with the nearest.
TEST(EntityTest, World) {
  World world;
  Entity& blue = world.add("blue1", robot());
  world.add("ball", robot());
  EXPECT_EQ(&world.entity("blue1"), &blue);
  EXPECT_EQ(world.find("green"), nullptr);
  EXPECT_TRUE(says(error_of([&] { world.add("blue1", robot()); }), {"two entities", "'blue1'"}));
  EXPECT_TRUE(
      says(error_of([&] { (void)world.entity("blue2"); }), {"unknown entity 'blue2'", "did you mean 'blue1'?"}));
  EXPECT_EQ(world.entities().size(), 2u);
  world.freeze_columns();
  EXPECT_NE(error_of([&] { blue.column(position); }), "no error");
}

/// Two robots with some numbers; columns made in this order or the other.
void fill(World& world, bool reversed) {
  for (const char* name : {"blue1", "blue2"}) {
    Entity& entity = world.add(name, robot());
    if (reversed) entity.column(walk_command);
    entity.column(orientation);
    entity.column(joint_position);
    entity.column(letter);
    if (!reversed) entity.column(walk_command);
    double number = 0.125;
    for (const auto& [column_name, column] : entity.columns()) {
      for (std::size_t row = 0; row < column->rows(); ++row) {
        for (std::size_t i = 0; i < column->numbers(); ++i) column->set(row, i, number += 0.5);
      }
    }
  }
}

// Rule: the hash is that of the state: it does not depend on the order in which columns were made.
TEST(EntityTest, StateHashIgnoresTheOrderOfColumns) {
  World a, b;
  fill(a, false);
  fill(b, true);
  EXPECT_EQ(a.state_hash(), b.state_hash());
}

/// Pose and velocity of objects that only shape the model follow from others.
bool is_worked_out(const Entity& entity, const ColumnBase& column, std::size_t row) {
  const auto& name = column.info().name;
  return entity.model().objects()[static_cast<int>(row)].structural &&
         (name == position.name || name == orientation.name || name == linear_velocity.name ||
          name == angular_velocity.name);
}

// Rule: the last bit of any number of any column changes the hash; so do a value that is no row of numbers, one more
// column, and freezing. Undoing a change brings the old hash back.
TEST(EntityTest, StateHashSeesEveryBit) {
  World world;
  fill(world, false);
  const std::uint64_t before = world.state_hash();
  for (const auto& entity : world.entities()) {
    for (const auto& [name, column] : entity->columns()) {
      for (std::size_t row = 0; row < column->rows(); ++row) {
        for (std::size_t i = 0; i < column->numbers(); ++i) {
          if (is_worked_out(*entity, *column, row)) continue;
          const double number = column->get(row, i);
          column->set(row, i, std::nextafter(number, 1e9));
          EXPECT_NE(world.state_hash(), before) << entity->name() << ' ' << name << ' ' << row << ' ' << i;
          column->set(row, i, number);
        }
      }
    }
  }
  EXPECT_EQ(world.state_hash(), before);
  Entity& blue = world.entity("blue1");
  blue.column(letter).values[0].letter = 'b';
  EXPECT_NE(world.state_hash(), before);
  blue.column(letter).values[0].letter = 'a';
  EXPECT_EQ(world.state_hash(), before);
  blue.freeze("test");
  const std::uint64_t frozen = world.state_hash();
  EXPECT_NE(frozen, before);
  blue.column(gait_phase).values[0] = 0;
  EXPECT_NE(world.state_hash(), frozen);
}

// Rule: it matters which entity has a number.
TEST(EntityTest, StateHashTellsEntitiesApart) {
  World world, other;
  fill(world, false);
  fill(other, false);
  EXPECT_EQ(world.state_hash(), other.state_hash());
  world.entity("blue1").column(joint_position).values[3] = 1;
  other.entity("blue2").column(joint_position).values[3] = 1;
  EXPECT_NE(world.state_hash(), other.state_hash());
}

}  // namespace
}  // namespace murosimf

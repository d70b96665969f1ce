#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/world/setup.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::error_of;
using fixtures::says;
using namespace properties;

// Inside a test "Setup" would be a private member of testing::Test: write murosimf::Setup.
class SetupAccess : public ::testing::Test {
 protected:
  static ModelPtr robot() {
    static const ModelPtr model = std::make_shared<const Model>(fixtures::two_legged());
    return model;
  }
  /// What an algorithm would declare that takes these spans.
  template <class Take>
  AccessSet declare(const Take& take) {
    AccessSet set;
    murosimf::Setup setup(world_, blue_, set);
    take(setup);
    return set;
  }

  World world_;
  Entity& blue_ = world_.add("blue", robot());
  Entity& red_ = world_.add("red", robot());
};

// Rule: taking a span is the declaration, with entity, column and mode; reading and writing give the same memory.
TEST_F(SetupAccess, TakingASpanDeclares) {
  AccessSet set;
  murosimf::Setup setup(world_, blue_, set);
  const std::span<const double> q = setup.read(joint_position);
  const std::span<Vec3d> r = setup.write(position);
  const std::span<const Vec3d> command = setup.input(walk_command, {1, 2, 3});
  EXPECT_EQ(q.data(), blue_.column(joint_position).values.data());
  EXPECT_EQ(r.data(), blue_.column(position).values.data());
  EXPECT_EQ(q.size(), static_cast<std::size_t>(robot()->size()));
  EXPECT_EQ(command.size(), 1u);
  ASSERT_EQ(set.all().size(), 3u);
  EXPECT_EQ(set.all()[0].mode, AccessMode::read);
  EXPECT_EQ(set.all()[1].mode, AccessMode::write);
  EXPECT_EQ(set.all()[2].mode, AccessMode::input);
  EXPECT_EQ(set.all()[0].column, &blue_.column(joint_position));
  EXPECT_EQ(set.all()[0].entity, &blue_);
  EXPECT_TRUE(set.writes(&blue_.column(position)));
  EXPECT_FALSE(set.writes(&blue_.column(joint_position)));
  EXPECT_TRUE(set.touches(&blue_.column(joint_position)));
  EXPECT_FALSE(set.touches(&red_.column(position)));
  EXPECT_EQ(&setup.model(), robot().get());
  EXPECT_EQ(&setup.entity(), &blue_);
  EXPECT_EQ(&setup.world(), &world_);
}

// Rule: the same declaration twice counts once; reading and writing the same column are two declarations.
TEST_F(SetupAccess, DeclaredTwice) {
  const AccessSet set = declare([](murosimf::Setup& setup) {
    (void)setup.read(position);
    (void)setup.read(position);
    (void)setup.write(position);
  });
  EXPECT_EQ(set.all().size(), 2u);
}

// Rule: an input has its start value until it is set; taking it again does not reset it.
TEST_F(SetupAccess, InputHasAStartValue) {
  AccessSet set;
  murosimf::Setup setup(world_, blue_, set);
  const auto first = setup.input(joint_target, 0.5);
  for (const double number : first) EXPECT_EQ(number, 0.5);
  blue_.object("left_knee").set(joint_target, 0.75);
  const auto second = setup.input(joint_target, 0.1);
  EXPECT_EQ(second.data(), first.data());
  EXPECT_EQ(second[robot()->object_index("left_knee")], 0.75);
  EXPECT_EQ(second[0], 0.5);
}

// Rule: the start value of an input also holds if another algorithm has read the column earlier: the order of attaching
// decides nothing about values.
TEST_F(SetupAccess, InputHasAStartValueAfterAReader) {
  AccessSet set;
  murosimf::Setup setup(world_, blue_, set);
  (void)setup.read(joint_target);
  for (const double number : setup.input(joint_target, 0.5)) EXPECT_EQ(number, 0.5);
}

// Rule: `of` gives the same algorithm's access to another entity.
TEST_F(SetupAccess, OtherEntity) {
  AccessSet set;
  murosimf::Setup setup(world_, blue_, set);
  (void)setup.read(position);
  const auto other = setup.of(red_).write(position);
  EXPECT_EQ(other.data(), red_.column(position).values.data());
  ASSERT_EQ(set.all().size(), 2u);
  EXPECT_EQ(set.all()[1].entity, &red_);
  EXPECT_TRUE(set.writes(&red_.column(position)));
  EXPECT_FALSE(set.writes(&blue_.column(position)));
}

// Rule: two algorithms conflict if one writes what the other reads or writes, whatever the order of asking.
TEST_F(SetupAccess, ConflictTable) {
  const AccessSet reads = declare([](murosimf::Setup& s) { (void)s.read(position); });
  const AccessSet reads_too = declare([](murosimf::Setup& s) { (void)s.read(position); });
  const AccessSet inputs = declare([](murosimf::Setup& s) { (void)s.input(position, {}); });
  const AccessSet writes = declare([](murosimf::Setup& s) { (void)s.write(position); });
  const AccessSet writes_too = declare([](murosimf::Setup& s) { (void)s.write(position); });
  const AccessSet writes_other = declare([](murosimf::Setup& s) { (void)s.write(linear_velocity); });
  const AccessSet writes_red = declare([this](murosimf::Setup& s) { (void)s.of(red_).write(position); });
  const AccessSet nothing;
  const struct {
    const AccessSet &a, &b;
    bool expected;
    const char* what;
  } table[] = {
      {reads, reads_too, false, "read/read"},
      {reads, inputs, false, "read/input"},
      {inputs, inputs, false, "input/input"},
      {reads, writes, true, "read/write"},
      {inputs, writes, true, "input/write"},
      {writes, writes_too, true, "write/write"},
      {reads, writes_other, false, "other property"},
      {writes, writes_other, false, "other property, writing"},
      {reads, writes_red, false, "other entity"},
      {writes, writes_red, false, "other entity, writing"},
      {nothing, writes, false, "nothing"},
  };
  for (const auto& row : table) {
    EXPECT_EQ(conflict(row.a, row.b), row.expected) << row.what;
    EXPECT_EQ(conflict(row.b, row.a), row.expected) << row.what << ", turned round";
  }
}

// Rule: one shared column among many is enough for a conflict.
TEST_F(SetupAccess, ConflictInOneOfMany) {
  const AccessSet a = declare([](murosimf::Setup& s) {
    (void)s.read(position);
    (void)s.read(orientation);
    (void)s.write(joint_velocity);
  });
  const AccessSet b = declare([](murosimf::Setup& s) {
    (void)s.read(position);
    (void)s.write(external_force);
    (void)s.write(orientation);
  });
  EXPECT_TRUE(conflict(a, b));
  EXPECT_TRUE(conflict(b, a));
}

// Rule: a column that is read must be written or be an input of an algorithm; the message names reader, property, entity and the
// algorithms that write other things there.
TEST_F(SetupAccess, EveryReadIsWritten) {
  const AccessSet reader = declare([](murosimf::Setup& s) { (void)s.read(joint_position); });
  const AccessSet writer = declare([](murosimf::Setup& s) { (void)s.write(joint_position); });
  const AccessSet input = declare([](murosimf::Setup& s) { (void)s.input(joint_position, 0); });
  const AccessSet other = declare([](murosimf::Setup& s) { (void)s.write(position); });
  const AccessSet both = declare([](murosimf::Setup& s) {
    (void)s.read(joint_position);
    (void)s.write(joint_position);
  });
  const AccessSet red_writer = declare([this](murosimf::Setup& s) { (void)s.of(red_).write(joint_position); });
  const auto check = [](const std::vector<NamedAccess>& all) {
    return error_of([&] { check_every_read_is_written(all); });
  };
  EXPECT_EQ(check({}), "no error");
  EXPECT_EQ(check({{"encoder", &reader}, {"servo", &writer}}), "no error");
  EXPECT_EQ(check({{"servo", &writer}, {"encoder", &reader}}), "no error");
  EXPECT_EQ(check({{"encoder", &reader}, {"control", &input}}), "no error");
  EXPECT_EQ(check({{"filter", &both}}), "no error");
  EXPECT_EQ(check({{"control", &input}}), "no error");
  EXPECT_TRUE(says(check({{"encoder", &reader}}), {"'encoder' reads 'joint_position' of 'blue'",
                                                   "but no algorithm writes it", "no algorithm writes anything"}));
  EXPECT_TRUE(says(check({{"encoder", &reader}, {"poses", &other}}),
                   {"'encoder' reads 'joint_position' of 'blue'", "'poses' writes other properties"}));
  EXPECT_TRUE(
      says(check({{"encoder", &reader}, {"poses", &other}, {"more", &other}}), {"'poses', 'more' write other"}));
  // the writer of another robot does not help, and is not named
  const std::string message = check({{"encoder", &reader}, {"red_servo", &red_writer}});
  EXPECT_TRUE(says(message, {"'encoder'", "no algorithm writes anything"}));
  EXPECT_EQ(message.find("red_servo"), std::string::npos);
}

// Rule: an algorithm that is constructed after the columns were frozen is refused, if it needs a new column.
TEST_F(SetupAccess, FrozenWorld) {
  (void)declare([](murosimf::Setup& s) { (void)s.read(position); });
  world_.freeze_columns();
  EXPECT_EQ(error_of([&] { (void)declare([](murosimf::Setup& s) { (void)s.read(position); }); }), "no error");
  EXPECT_TRUE(says(error_of([&] { (void)declare([](murosimf::Setup& s) { (void)s.write(joint_velocity); }); }),
                   {"'blue'", "'joint_velocity'", "frozen"}));
}

}  // namespace
}  // namespace murosimf

/// urdfdom_test - what the reader makes of URDF files is what urdfdom, the reference reader, makes of them.
///
/// Files: random robots, and those of teams where they are there (robot_data.h).
#include <algorithm>
#include <fstream>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include "murosimf/math/random.h"
#include "murosimf/robot_formats/urdf/urdf_reader.h"
#include "tests/oracle/random_urdf.h"
#include "tests/robot_data.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

constexpr int poses = 1000;
constexpr double rounding = 1e-12;  // [m], [kg m^2], [1]: both sides compute in double

Eigen::Vector3d to_eigen(const Vec3d& v) { return {v.x, v.y, v.z}; }
Eigen::Vector3d to_eigen(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }
Eigen::Matrix3d to_eigen(const Mat3d& m) {
  Eigen::Matrix3d result;
  result << to_eigen(m.x), to_eigen(m.y), to_eigen(m.z);
  return result;
}

Eigen::Isometry3d to_eigen(const Transformd& place) {
  return Eigen::Translation3d(to_eigen(place.position)) * Eigen::Quaterniond(to_eigen(place.orientation));
}
Eigen::Isometry3d to_eigen(const urdf::Pose& pose) {
  const auto& q = pose.rotation;
  return Eigen::Translation3d(to_eigen(pose.position)) * Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

const robot_formats::BodyDescription& body_of(const robot_formats::RobotDescription& description,
                                              const std::string& name) {
  for (const robot_formats::BodyDescription& body : description.bodies) {
    if (body.name == name) return body;
  }
  throw std::runtime_error("no body " + name);
}

bool moves(const urdf::Joint& joint) { return joint.type != urdf::Joint::FIXED; }

void compare_joint(const robot_formats::BodyDescription& body, const urdf::Joint& joint) {
  SCOPED_TRACE(joint.name);
  EXPECT_LT(difference(to_eigen(body.place), to_eigen(joint.parent_to_joint_origin_transform)), rounding);
  ASSERT_EQ(body.joints.size(), moves(joint) ? 1u : 0u);
  if (!moves(joint)) return;
  const robot_formats::JointDescription& ours = body.joints[0];
  EXPECT_EQ(ours.name, joint.name);
  EXPECT_EQ(ours.kind == Kind::prismatic, joint.type == urdf::Joint::PRISMATIC);
  EXPECT_LT((to_eigen(ours.axis) - to_eigen(joint.axis).normalized()).norm(), rounding);
  EXPECT_EQ(ours.range.has_value(), joint.type != urdf::Joint::CONTINUOUS);
  if (ours.range) {
    EXPECT_EQ(ours.range->x, joint.limits->lower);
    EXPECT_EQ(ours.range->y, joint.limits->upper);
  }
  EXPECT_EQ(ours.effort_limit, joint.limits ? joint.limits->effort : 0);
  EXPECT_EQ(ours.rate_limit, joint.limits ? joint.limits->velocity : 0);
  EXPECT_EQ(ours.damping, joint.dynamics ? joint.dynamics->damping : 0);
  EXPECT_EQ(ours.friction, joint.dynamics ? joint.dynamics->friction : 0);
}

void compare_mass(const robot_formats::MassProperties& ours, const urdf::Link& link) {
  EXPECT_EQ(ours.mass, link.inertial ? link.inertial->mass : 0);
  if (!link.inertial) return;
  const urdf::Inertial& theirs = *link.inertial;
  const Eigen::Isometry3d place = to_eigen(theirs.origin);
  EXPECT_LT((to_eigen(ours.center) - place.translation()).norm(), rounding);
  Eigen::Matrix3d tensor;
  tensor << theirs.ixx, theirs.ixy, theirs.ixz, theirs.ixy, theirs.iyy, theirs.iyz, theirs.ixz, theirs.iyz, theirs.izz;
  const Eigen::Matrix3d turned = place.linear() * tensor * place.linear().transpose();
  const SymMat3d& I = ours.inertia;
  Eigen::Matrix3d mine;
  mine << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  EXPECT_LT((mine - turned).cwiseAbs().maxCoeff(), rounding);
}

/// Half sizes of a simple shape, in the order of its numbers; empty for a mesh.
std::vector<double> sizes(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return {box->half_size.x, box->half_size.y, box->half_size.z};
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return {cylinder->radius, cylinder->half_length};
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return {sphere->radius};
  return {};
}
std::vector<double> sizes(const urdf::Geometry& geometry) {
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
    return {0.5 * box->dim.x, 0.5 * box->dim.y, 0.5 * box->dim.z};
  }
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    return {cylinder->radius, 0.5 * cylinder->length};
  }
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) return {sphere->radius};
  return {};
}

void compare_collisions(const robot_formats::BodyDescription& body, const urdf::Link& link) {
  std::vector<const robot_formats::ShapeDescription*> ours;
  for (const robot_formats::ShapeDescription& shape : body.shapes) {
    if (shape.placed.collides) ours.push_back(&shape);
  }
  ASSERT_EQ(ours.size(), link.collision_array.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const PlacedShape& placed = ours[i]->placed;
    const urdf::Collision& collision = *link.collision_array[i];
    EXPECT_EQ(sizes(placed.shape), sizes(*collision.geometry));
    if (!ours[i]->mesh.empty()) continue;  // a hull is placed at its middle
    const Transformd place{placed.position, placed.orientation};
    EXPECT_LT(difference(to_eigen(place), to_eigen(collision.origin)), rounding);
  }
}

/// Their pose of every link, by name, for joint positions by name.
void their_poses(const urdf::Link& link, const Eigen::Isometry3d& pose, const std::map<std::string, double>& q,
                 std::map<std::string, Eigen::Isometry3d>& all) {
  all[link.name] = pose;
  for (const auto& child : link.child_links) {
    const urdf::Joint& joint = *child->parent_joint;
    Eigen::Isometry3d next = pose * to_eigen(joint.parent_to_joint_origin_transform);
    if (moves(joint)) {
      const Eigen::Vector3d axis = to_eigen(joint.axis).normalized();
      const double position = q.at(joint.name);
      next = joint.type == urdf::Joint::PRISMATIC ? next * Eigen::Translation3d(position * axis)
                                                  : next * Eigen::AngleAxisd(position, axis);
    }
    their_poses(*child, next, q, all);
  }
}

std::vector<Eigen::Isometry3d> our_poses(const robot_formats::RobotDescription& description,
                                         const std::map<std::string, double>& q) {
  std::vector<Eigen::Isometry3d> all{Eigen::Isometry3d::Identity()};
  for (std::size_t i = 1; i < description.bodies.size(); ++i) {
    const robot_formats::BodyDescription& body = description.bodies[i];
    Vec3d shift = body.place.position;
    Mat3d turn = body.place.orientation;
    for (const robot_formats::JointDescription& joint : body.joints) {
      const double position = q.at(joint.name);
      if (joint.kind == Kind::prismatic) {
        shift += turn * (position * joint.axis);
      } else {
        turn = turn * rotation(joint.axis, position);
      }
    }
    all.push_back(all[static_cast<std::size_t>(body.parent)] * to_eigen(Transformd{shift, turn}));
  }
  return all;
}

void compare_poses(const robot_formats::RobotDescription& description, const urdf::ModelInterface& theirs, int count) {
  const RandomStream random(1, "urdfdom_test");
  std::uint64_t number = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    std::map<std::string, double> q;
    for (const auto& [name, joint] : theirs.joints_) q[name] = random.uniform(number++, -3, 3);
    std::map<std::string, Eigen::Isometry3d> expected;
    their_poses(*theirs.getRoot(), Eigen::Isometry3d::Identity(), q, expected);
    const auto found = our_poses(description, q);
    for (std::size_t k = 0; k < found.size(); ++k) {
      worst = std::max(worst, difference(found[k], expected.at(description.bodies[k].name)));
    }
  }
  EXPECT_LT(worst, rounding);
}

void compare(const std::filesystem::path& file, int count) {
  const auto theirs = urdf::parseURDFFile(file.string());
  ASSERT_TRUE(theirs);
  const robot_formats::RobotDescription description = robot_formats::urdf::read_urdf(file);
  EXPECT_EQ(description.name, theirs->getName());
  ASSERT_EQ(description.bodies.size(), theirs->links_.size());
  EXPECT_EQ(description.bodies[0].name, theirs->getRoot()->name);
  for (const auto& [name, link] : theirs->links_) {
    SCOPED_TRACE(name);
    const robot_formats::BodyDescription& body = body_of(description, name);
    compare_mass(body.solid, *link);
    compare_collisions(body, *link);
    if (!link->parent_joint) continue;
    EXPECT_EQ(description.bodies[static_cast<std::size_t>(body.parent)].name, link->getParent()->name);
    compare_joint(body, *link->parent_joint);
  }
  compare_poses(description, *theirs, count);
}

TEST(urdf_against_urdfdom, RandomRobots) {
  const auto file = fixtures::temp_folder() / "urdfdom_random.urdf";
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::ofstream(file) << oracle::RandomUrdf(seed).text();
    compare(file, 10);
  }
}

void compare_if_there(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is not there; MUROSIMF_TEST_DATA names the folder of robots";
  }
  compare(file, poses);
}

TEST(urdf_against_urdfdom, WolfgangOp) { compare_if_there(wolfgang_urdf()); }

TEST(urdf_against_urdfdom, BoosterK1) { compare_if_there(k1_urdf()); }

}  // namespace
}  // namespace murosimf

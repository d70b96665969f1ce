// Frames are in columns of their robot: requests, lists of cameras, their hash, and what is refused.
#include "murosimf/sensors/camera_frame.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "tests/fixtures.h"

namespace murosimf::sensors {
namespace {

using fixtures::error_of;
using fixtures::says;

CameraInfo info(const std::string& name) { return {.name = name, .lens = imaging::Lens({.fx = 500, .fy = 500})}; }

/// With a left and a right eye.
struct Robot {
  Robot() {
    (void)setup.write(properties::position);
    right = &write_frame(setup, info("right_eye"));
    left = &write_frame(setup, info("left_eye"));
  }
  World world;
  AccessSet access;
  Entity& entity = world.add("robot", std::make_shared<const Model>("dot", Chain{}.base()));
  Setup setup{world, entity, access};
  CameraFrame *left = nullptr, *right = nullptr;
};

TEST(CameraFrames, AreListedByName) {
  const Robot robot;
  EXPECT_EQ(frames_of(robot.entity), (std::vector<const CameraFrame*>{robot.left, robot.right}));
  EXPECT_EQ(robot.left->info->name, "left_eye");
}

TEST(CameraFrames, AreWantedByWhoReadsThem) {
  Robot robot;
  EXPECT_FALSE(robot.left->wanted || robot.right->wanted);
  AccessSet others;
  murosimf::Setup reader(robot.world, robot.entity, others);
  EXPECT_EQ(&read_frame(reader, "left_eye"), robot.left);
  EXPECT_TRUE(robot.left->wanted);
  EXPECT_FALSE(robot.right->wanted);
  ASSERT_EQ(others.all().size(), 1U);
  EXPECT_EQ(others.all()[0].mode, AccessMode::read);
  EXPECT_EQ(&want_frames(robot.entity, "right_eye"), robot.right);
  EXPECT_TRUE(robot.right->wanted);
}

TEST(CameraFrames, WhatThereIsNoneOfIsNamed) {
  Robot robot;
  EXPECT_TRUE(says(error_of([&] { (void)want_frames(robot.entity, "left_eve"); }),
                   {"'robot': unknown camera 'left_eve'; did you mean 'left_eye'?"}));
  EXPECT_EQ(error_of([&] { (void)write_frame(robot.setup, info("left_eye")); }),
            "'robot' has two cameras called 'left_eye'");
  Entity& blind = robot.world.add("blind", robot.entity.model_ptr());
  AccessSet access;
  murosimf::Setup setup(robot.world, blind, access);
  EXPECT_EQ(error_of([&] { (void)read_frame(setup, "left_eye"); }), "'blind' has no camera 'left_eye', nor any other");
}

CameraFrame picture() {
  CameraFrame frame;
  frame.time = Duration{5};
  frame.number = 2;
  frame.color = imaging::ColorImage(2, 1, {1, 2, 3});
  frame.mosaic = imaging::GrayImage(2, 1, 4);
  frame.depth = imaging::DepthImage(2, 1, 5.0F);
  frame.labels = imaging::LabelImage(2, 1, 6);
  return frame;
}

// Every layer, every pixel, its shape, and the instant.
TEST(CameraFrames, HashIsOfAllThatIsShown) {
  const std::uint64_t hash = hash_of(picture());
  EXPECT_EQ(hash_of(picture()), hash);
  const auto changed = [&](const auto& change) {
    CameraFrame frame = picture();
    change(frame);
    return hash_of(frame) != hash;
  };
  EXPECT_TRUE(changed([](CameraFrame& f) { f.time = Duration{6}; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.number = 3; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.color(1, 0).red = 9; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.color(1, 0).green = 9; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.color(0, 0).blue = 9; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.mosaic(1, 0) = 9; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.depth(1, 0) = 9; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.labels(0, 0) = 9; }));
  EXPECT_TRUE(changed([](CameraFrame& f) { f.labels = imaging::LabelImage(1, 2, 6); }))
      << "as many pixels, but upright";
  // sizes say which pixel belongs to which layer
  CameraFrame wide, many;
  wide.mosaic = imaging::GrayImage(2, 1, 0);
  wide.depth = imaging::DepthImage(0, 1);
  many.mosaic = imaging::GrayImage(1, 1, 0);
  many.labels = imaging::LabelImage(1, 1, 0);
  EXPECT_NE(hash_of(wide), hash_of(many));
  CameraFrame high, two;
  high.mosaic = imaging::GrayImage(1, 2, 1);
  two.mosaic = imaging::GrayImage(1, 1, 1);
  two.depth = imaging::DepthImage(1, 1, 0.0F);
  EXPECT_NE(hash_of(high), hash_of(two)) << "the same numbers, but of another layer";
  // colors are told apart although they are one number
  CameraFrame one = picture(), other = picture();
  one.color(0, 0) = {1, 0, 0};
  other.color(0, 0) = {0, 1, 0};
  EXPECT_NE(hash_of(one), hash_of(other));
  other.color(0, 0) = {0, 0, 1};
  EXPECT_NE(hash_of(one), hash_of(other));
}

}  // namespace
}  // namespace murosimf::sensors

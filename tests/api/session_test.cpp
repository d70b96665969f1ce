// include/murosimf/session.h: steered from another thread, a run stays the same run.
#include "murosimf/session.h"

#include <gtest/gtest.h>

#include <thread>

namespace murosimf::api {
namespace {

TEST(ApiSession, IsSteeredFromAnotherThread) {
  Scene scene("walk", {.set = {"walker.level=simplified_dynamics"}});
  Session session(scene, {.paused = true, .stays = true});
  std::thread run([&] { session.run(60); });
  session.step(500);
  while (session.status().time < 0.5) std::this_thread::yield();
  session.change("walker.level=full_dynamics");
  EXPECT_THROW(session.change("walker.level=ful"), InputError);
  EXPECT_TRUE(session.status().paused);
  session.step(500);
  while (session.status().time < 1) std::this_thread::yield();
  session.seek(0.25);
  EXPECT_DOUBLE_EQ(session.status().time, 0.25);
  session.finish();
  run.join();
  Scene truth("walk", {.set = {"walker.level=simplified_dynamics"}});
  truth.run(0.25);
  EXPECT_EQ(scene.state_hash(), truth.state_hash());
  EXPECT_THROW(session.seek(0.1), Error);
}

TEST(ApiSession, EndsByItself) {
  Scene scene("walk");
  Session session(scene);
  session.run(0.5);
  EXPECT_DOUBLE_EQ(scene.time(), 0.5);
  EXPECT_THROW(Session(scene, {.speed = -1.0}), InputError);
}

struct Throws final : Controller {
  void step(ControlCycle& cycle) override {
    if (cycle.time > 0.2) throw std::range_error("enough");
  }
};

TEST(ApiSession, TellsWhatAControllerThrows) {
  Scene scene = Scene::of_robot("kid21", {.set = {"robot.level=simplified_dynamics"}});
  scene.robot().set_controller(std::make_shared<Throws>());
  Session session(scene);
  EXPECT_THROW(session.run(1.0), std::range_error);
  EXPECT_LT(scene.time(), 0.3);
}

}  // namespace
}  // namespace murosimf::api

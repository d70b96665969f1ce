// include/murosimf/web_page.h: a page and a program have a scene by turns. Who looks: python/tests/package/test_page.py.
#include "murosimf/web_page.h"

#include <gtest/gtest.h>

#include <optional>

namespace murosimf::api {
namespace {

class ApiWebPage : public testing::Test {
 protected:
  void SetUp() override {
    try {
      page_.emplace(scene_);
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();  // this build has no server
    }
  }

  Scene scene_{"walk", {.set = {"walker.level=simplified_dynamics"}}};
  std::optional<WebPage> page_;
};

TEST_F(ApiWebPage, ChangesNoResult) {
  EXPECT_EQ(page_->address().rfind("http://127.0.0.1:", 0), 0u);
  const auto run = [](Scene& scene) {
    scene.run(0.3);
    scene.change("walker.level=full_dynamics");
    scene.run(0.1);
  };
  {
    WebPage::Turn turn(*page_);
    run(scene_);
    turn.breathe();
    scene_.step();
  }
  Scene truth("walk", {.set = {"walker.level=simplified_dynamics"}});
  run(truth);
  truth.step();
  const WebPage::Turn turn(*page_);
  EXPECT_EQ(scene_.state_hash(), truth.state_hash());
}

TEST_F(ApiWebPage, FollowsJumps) {
  {
    const WebPage::Turn turn(*page_);
    scene_.run(0.2);
  }
  {
    const WebPage::Turn turn(*page_, WebPage::Use::jump);
    scene_.reset(7);
  }
  const WebPage::Turn turn(*page_);
  EXPECT_EQ(scene_.time(), 0);
}

TEST_F(ApiWebPage, RefusesImpossibleOptions) {
  EXPECT_THROW(WebPage(scene_, {.address = "nowhere:port"}), InputError);
  EXPECT_THROW(WebPage(scene_, {.speed = -1}), InputError);
}

}  // namespace
}  // namespace murosimf::api

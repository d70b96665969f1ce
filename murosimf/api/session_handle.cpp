// include/murosimf/session.h.
#include "murosimf/session.h"

#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/session/session.h"

namespace murosimf {

namespace api {

struct SessionInside {
  std::shared_ptr<SceneInside> scene;
  session::Session session;
};

}  // namespace api

inline namespace v0 {

using api::told;

Session::Session(const Scene& scene, const SessionOptions& options) {
  api::SceneInside& inside = scene.inside();
  inside_ = told([&] {
    const session::SessionOptions all{.speed = options.speed, .paused = options.paused, .stays = options.stays};
    return std::unique_ptr<api::SessionInside>(
        new api::SessionInside{scene.inside_, session::Session(inside.scene, all)});
  });
  inside.begun = true;
}

Session::~Session() = default;

void Session::run(double end) {
  told([&] { inside_->session.run(from_seconds(end)); });
  inside_->scene->check_failure();
}

void Session::pause() { inside_->session.pause(); }
void Session::go_on() { inside_->session.go_on(); }
void Session::step(std::int64_t steps) { inside_->session.step(steps); }
void Session::set_speed(std::optional<double> speed) {
  told([&] { inside_->session.set_speed(speed); });
}

void Session::change(const std::string& assignment) { change(std::vector<std::string>{assignment}); }
void Session::change(const std::vector<std::string>& assignments) {
  told([&] { inside_->session.change(assignments).get(); });
}
void Session::reset(std::optional<std::uint64_t> seed) {
  told([&] { inside_->session.reset(seed).get(); });
}
void Session::seek(double time) {
  told([&] { inside_->session.seek(from_seconds(time)).get(); });
}
void Session::finish() { inside_->session.finish(); }

SessionStatus Session::status() const {
  const session::SessionStatus now = inside_->session.status();
  return {seconds(now.time), seconds(now.end), seconds(now.first), seconds(now.last),
          now.paused,        now.factor,       now.branch};
}

}  // namespace v0
}  // namespace murosimf

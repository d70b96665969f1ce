// include/murosimf/web_page.h.
#include <chrono>
#include <exception>
#include <future>
#include <thread>
#include <utility>

#include "murosimf/api/shared_source.h"
#include "murosimf/api/told.h"
#include "murosimf/network/socket.h"
#include "murosimf/session/session.h"
#include "murosimf/web/web_view.h"
#include "murosimf/web_page.h"

namespace murosimf {

namespace api {
namespace {

network::Address address_of(const std::string& text) {
  try {
    return network::parse_address(text);
  } catch (const network::NetworkError& error) {
    throw InputError(error.what());
  }
}

}  // namespace

struct WebPageInside {
  WebPageInside(std::shared_ptr<SceneInside> of, const WebPageOptions& options)
      : scene(std::move(of)),
        session(std::make_unique<SharedSource>(scene), {.speed = options.speed, .paused = true}),
        view(scene->scene, session, {.address = address_of(options.address)}),
        thread([this] { run(); }) {}
  ~WebPageInside() {
    session.finish();
    if (thread.joinable()) thread.join();
  }

  void run() {
    try {
      session.run(Duration::max());
    } catch (...) {
      trouble = std::current_exception();
    }
  }

  std::shared_ptr<SceneInside> scene;
  session::Session session;
  web::WebView view;
  std::exception_ptr trouble;   // of the thread, which has ended with it
  std::promise<void> returned;  // of the program's turn
  bool ended = false;           // the program alone has the scene
  std::thread thread;           // last: it uses the others
};

}  // namespace api

inline namespace v0 {

using api::told;

WebPage::WebPage(const Scene& scene, const WebPageOptions& options) {
  scene.inside().begin();
  inside_ = told([&] { return std::make_unique<api::WebPageInside>(scene.inside_, options); });
}

WebPage::~WebPage() = default;

std::string WebPage::address() const { return inside_->view.page_address(); }
void WebPage::pause() { inside_->session.pause(); }

WebPage::Turn::Turn(WebPage& page, Use use) : page_(page) { take(use); }

WebPage::Turn::~Turn() { give(); }

void WebPage::Turn::breathe() {
  give();
  take(Use::step);
}

/// The page's thread waits in the middle of a request until the turn is over.
void WebPage::Turn::take(Use use) {
  api::WebPageInside& inside = *page_.inside_;
  if (inside.ended) return;
  inside.returned = {};
  auto taken = std::make_shared<std::promise<void>>();
  const std::shared_future<void> returned = inside.returned.get_future().share();
  std::future<void> waits = taken->get_future();
  const auto call = [taken, returned](scene::Scene&) {
    taken->set_value();
    returned.wait();
  };
  const std::future<void> done = use == Use::step ? inside.session.visit(call) : inside.session.load(call);
  using namespace std::chrono_literals;
  while (waits.wait_for(1ms) != std::future_status::ready) {
    if (done.wait_for(0ms) != std::future_status::ready) continue;
    inside.ended = true;  // the run ended before it came to the request
    inside.thread.join();
    if (inside.trouble) told([&] { std::rethrow_exception(std::exchange(inside.trouble, nullptr)); });
    return;
  }
  taken_ = true;
}

void WebPage::Turn::give() {
  if (std::exchange(taken_, false)) page_.inside_->returned.set_value();
}

}  // namespace v0
}  // namespace murosimf

/// web_view.h - a running scene for browsers and other viewers: the page, its WebSocket, and Foxglove's.
///
///     session::Session session(scene, {.speed = 1.0});
///     web::WebView view(scene, session, {.address = {"127.0.0.1", 8080}});
///     say(view.addresses());
///     session.run(60s);
///
/// The server runs in a separate thread; it reads the scene only by copies of poses and visits of the session. Observation changes no result.
#pragma once

#include <memory>
#include <string>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/network/socket.h"
#include "murosimf/session/session.h"

namespace murosimf::league {
class GameTask;
}

namespace murosimf::web {

struct WebOptions {
  network::Address address;
  const league::GameTask* game = nullptr;            ///< game with the displayed score; must outlive the view
  const drawing::DebugDrawSource* others = nullptr;  ///< source of displayed drawings; must outlive the view
};

class WebView {
 public:
  /// Scene and session must outlive it. Throws SetupError: the port is in use, this build has no server.
  WebView(scene::Scene& scene, session::Session& session, const WebOptions& options);
  ~WebView();
  WebView(const WebView&) = delete;
  WebView& operator=(const WebView&) = delete;

  /// Address of the page: "http://127.0.0.1:8080/"; for other computers, with the token.
  [[nodiscard]] std::string page_address() const;
  /// For viewers, with the token: "ws://127.0.0.1:8080/?token=..."
  [[nodiscard]] std::string socket_address() const;
  /// Reason why there is no page at that address, in one line; empty: there is one.
  [[nodiscard]] static std::string no_page();
  [[nodiscard]] int clients() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace murosimf::web

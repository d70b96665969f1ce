#include "murosimf/web/web_view.h"

#include <set>

#include <fmt/format.h>

#include "murosimf/web/camera_subscriptions.h"
#include "murosimf/web/entry.h"
#include "murosimf/web/foxglove_conversation.h"
#include "murosimf/web/page.h"
#include "murosimf/web/page_conversation.h"
#include "murosimf/web/server.h"

namespace murosimf::web {
namespace {

constexpr std::string_view page_missing =
    "<!doctype html><title>MuRoSimF</title><p>This program was built without its page for browsers, since npm was "
    "missing. "
    "Foxglove can look on at this address all the same.";

}  // namespace

struct WebView::Inside {
  Inside(scene::Scene& scene, session::Session& session, const WebOptions& options)
      : cameras(session),
        live(session, scene.simulation().poses(), cameras, options.game, options.others),
        foxglove(session, cameras, options.others),
        token(new_token()),
        server(options_of(options)) {}

  Server::Options options_of(const WebOptions& given) {
    const std::string_view page = compressed_page();
    const auto talk_to_foxglove = [this] { return std::make_unique<FoxgloveConversation>(foxglove); };
    const Answer answer{.bytes = page.empty() ? page_missing : page,
                        .type = "text/html; charset=utf-8",
                        .gzip = !page.empty()};
    return {.address = given.address,
            .token = token,
            .protocols = {{"murosimf.v1", [this] { return std::make_unique<PageConversation>(live); }},
                          {"foxglove.sdk.v1", talk_to_foxglove},
                          {"foxglove.websocket.v1", talk_to_foxglove}},
            .pages = {{"/", answer}},
            .look = [this] {
              live.look();
              foxglove.look();
              std::set<std::string> wanted = foxglove.wanted_cameras();
              wanted.insert(live.wanted_cameras().begin(), live.wanted_cameras().end());
              cameras.want(wanted);
            }};
  }

  CameraSubscriptions cameras;
  LiveScene live;         // accessed by the server's thread only
  FoxgloveLive foxglove;  // likewise
  const std::string token;
  Server server;  // last member: its thread uses the others
};

WebView::WebView(scene::Scene& scene, session::Session& session, const WebOptions& options)
    : inside_(std::make_unique<Inside>(scene, session, options)) {}
WebView::~WebView() = default;

std::string WebView::page_address() const {
  const std::string address = to_text(inside_->server.address());
  return fmt::format("http://{}/{}", address, is_loopback(address) ? "" : "?token=" + inside_->token);
}

std::string WebView::socket_address() const {
  return fmt::format("ws://{}/?token={}", to_text(inside_->server.address()), inside_->token);
}

std::string WebView::no_page() {
  return compressed_page().empty() ? "the page for browsers is missing: this program was built without npm" : "";
}

int WebView::clients() const { return inside_->server.clients(); }

}  // namespace murosimf::web

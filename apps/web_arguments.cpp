#include "apps/web_arguments.h"

#include "apps/error_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

constexpr auto usual_port = "8080";

network::Address address_of(const std::string& where) {
  try {
    return network::parse_address(where);
  } catch (const network::NetworkError& error) {
    throw SetupError(error.what());
  }
}

}  // namespace

void add_web(const Command& command, WebArguments& arguments) {
  command
      .add("--web", arguments.web,
           "Show the run in browsers, and let them steer it: PORT of this computer alone, or HOST:PORT")
      .value_if_alone(usual_port);
  const Option html =
      command.add("--html", arguments.html, "Write the run to this file (HTML), which plays in any browser, offline");
  command.add("--html-rate", arguments.html_rate, "Frames per simulated second in it").needs(html).shows_default();
}

void check(const WebArguments& arguments) {
  if (!arguments.web.empty()) with_context("--web", [&] { (void)address_of(arguments.web); });
  if (!arguments.html.empty()) files::claim_output("--html", arguments.html);
}

std::unique_ptr<web::HtmlRecording> make_html_recording(scene::Scene& scene, const WebArguments& arguments,
                                                        const drawing::DebugDrawSource* others) {
  if (arguments.html.empty()) return nullptr;
  return std::make_unique<web::HtmlRecording>(scene, web::HtmlOptions{.file = arguments.html,
                                                                      .rate = arguments.html_rate,
                                                                      .others = others});
}

std::unique_ptr<web::WebView> web_view_of(scene::Scene& scene, session::Session& session, const WebArguments& arguments,
                                          const ShownInBrowsers& shown) {
  if (arguments.web.empty()) return nullptr;
  auto view = with_context("--web", [&] {
    return std::make_unique<web::WebView>(scene, session,
                                          web::WebOptions{.address = address_of(arguments.web),
                                                          .game = shown.game,
                                                          .others = shown.others});
  });
  const std::string missing = web::WebView::no_page();
  if (missing.empty()) {
    say_note("page: " + view->page_address());
  } else {
    say_warning(missing);
  }
  say_note("Foxglove: " + view->socket_address());
  say_note("Ctrl-C ends it");
  return view;
}

}  // namespace murosimf::app

/// web_arguments.h - the options of `murosimf run` that show it in browsers: while it runs, or as a file.
#pragma once

#include <memory>
#include <string>

#include "apps/command.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/league/game_task.h"
#include "murosimf/session/session.h"
#include "murosimf/web/html_recording.h"
#include "murosimf/web/web_view.h"

namespace murosimf::app {

struct WebArguments {
  std::string web;        ///< [HOST:]PORT; empty: no page
  std::string html;       ///< file; empty: none
  double html_rate = 25;  ///< [Hz]
};

void add_web(const Command& command, WebArguments& arguments);

/// Throws SetupError: an address that is none, a file that could not be written.
void check(const WebArguments& arguments);

/// Null if none is asked for. Before the first step. `others`: what other programs draw; null: they do not.
[[nodiscard]] std::unique_ptr<web::HtmlRecording> make_html_recording(scene::Scene& scene,
                                                                      const WebArguments& arguments,
                                                                      const drawing::DebugDrawSource* others);

/// What browsers show besides the scene; all of it must outlive the view.
struct ShownInBrowsers {
  const league::GameTask* game = nullptr;            ///< whose score; null: no referee
  const drawing::DebugDrawSource* others = nullptr;  ///< what other programs draw; null: they do not
};

/// Shows the session in browsers from now on and prints its addresses. Null without a page. Throws SetupError, with the option.
[[nodiscard]] std::unique_ptr<web::WebView> web_view_of(scene::Scene& scene, session::Session& session,
                                                        const WebArguments& arguments, const ShownInBrowsers& shown);

}  // namespace murosimf::app

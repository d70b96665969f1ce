/// web_arguments.h - the options of `murosimf run` that show it in browsers: while it runs, or as a file.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "apps/command.h"
#include "murosimf/league/game_task.h"
#include "murosimf/runtime/clock.h"
#include "murosimf/session/session.h"
#include "murosimf/web/html_recording.h"

namespace murosimf::app {

struct WebArguments {
  std::string web;        ///< [HOST:]PORT; empty: nobody looks on
  std::string html;       ///< file; empty: none
  double html_rate = 25;  ///< [Hz]
};

void add_web(const Command& command, WebArguments& arguments);

/// Throws SetupError: an address that is none, a file that could not be written.
void check(const WebArguments& arguments);

/// Null if none is asked for. Before the first step.
[[nodiscard]] std::unique_ptr<web::HtmlRecording> make_html_recording(scene::Scene& scene,
                                                                      const WebArguments& arguments);

/// Runs the scene with a server at `arguments.web`, whose addresses are said first; at `end` it pauses until a signal comes. Throws SetupError.
/// `game`: null if nobody referees.
Lateness run_with_server(scene::Scene& scene, const WebArguments& arguments, const league::GameTask* game,
                         const session::SessionOptions& options, Duration end,
                         const std::function<void(Duration)>& progress);

}  // namespace murosimf::app

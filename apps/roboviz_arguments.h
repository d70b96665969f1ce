/// roboviz_arguments.h - the option --roboviz: a port for programs that draw with the protocol of RoboViz.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/command.h"
#include "murosimf/drawing/roboviz_server.h"
#include "murosimf/scene/run_report.h"

namespace murosimf::app {

/// `where`: [HOST:]PORT; empty: no other program draws.
void add_roboviz(const Command& command, std::string& where);

/// Opens the port and prints where it is; null if no other program draws. Throws SetupError.
[[nodiscard]] std::unique_ptr<drawing::RobovizServer> roboviz_server(const std::string& where);

/// For reports; nothing if there is no port.
[[nodiscard]] std::optional<scene::DrawingPackets> packets_of(const drawing::RobovizServer* door);

}  // namespace murosimf::app

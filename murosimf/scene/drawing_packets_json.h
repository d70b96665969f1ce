/// drawing_packets_json.h - packets with drawings, as part of reports.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "murosimf/scene/run_report.h"

namespace murosimf::scene {

/// null, or {packets, ignored}
[[nodiscard]] inline nlohmann::json json_of(const std::optional<DrawingPackets>& drawings) {
  if (!drawings) return nullptr;
  return {{"packets", drawings->packets}, {"ignored", drawings->ignored}};
}

}  // namespace murosimf::scene

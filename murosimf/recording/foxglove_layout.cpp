// The layout that is supplied with recordings (recorder.h).
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/recording/recording_header.h"

namespace murosimf::recording {
namespace {

using nlohmann::json;

/// Panels beside each other, or one above the other; `share` [%] is that of the first.
json split(const char* direction, const json& first, const json& second, int share) {
  return {{"direction", direction}, {"first", first}, {"second", second}, {"splitPercentage", share}};
}

/// The first joint of the first robot: commanded and actual position.
json curves(const std::vector<std::string>& robots) {
  json paths = json::array();
  if (robots.empty()) return paths;
  for (const char* topic : {"/joints", "/targets"}) {
    paths.push_back({{"value", fmt::format("{}.joints[0].position", topic)},
                     {"enabled", true},
                     {"timestampMethod", "receiveTime"}});
  }
  return paths;
}

}  // namespace

/// The panels that are useful for any recording, filled with its topics.
std::string foxglove_layout(const std::vector<std::string>& robots) {
  json layout;
  layout["configById"]["3D!bodies"] = {{"followTf", "world"},
                                       {"followMode", "follow-none"},
                                       {"topics",
                                        {{"/scene", {{"visible", true}}}, {"/contact_forces", {{"visible", true}}}}},
                                       {"scene", {{"transforms", {{"visible", false}}}}},
                                       {"cameraState",
                                        {{"distance", 8},
                                         {"phi", 55},
                                         {"thetaOffset", 90},
                                         {"targetOffset", {0, 0, 0}},
                                         {"target", {0, 0, 0}},
                                         {"targetOrientation", {0, 0, 0, 1}},
                                         {"perspective", true},
                                         {"fovy", 45},
                                         {"near", 0.05},
                                         {"far", 200}}}};
  layout["configById"]["Plot!joints"] = {{"paths", curves(robots)}, {"showLegend", true}, {"isSynced", true}};
  layout["configById"]["RosOut!events"] = {{"topicToRender", "/events"}};
  layout["configById"]["RosOut!warnings"] = {{"topicToRender", "/warnings"}};
  layout["globalVariables"] = json::object();
  layout["userNodes"] = json::object();
  layout["playbackConfig"] = {{"speed", 1}};
  layout["layout"] =
      split("row", "3D!bodies",
            split("column", "Plot!joints", split("row", "RosOut!events", "RosOut!warnings", 50), 60), 65);
  return layout.dump(2) + "\n";
}

}  // namespace murosimf::recording

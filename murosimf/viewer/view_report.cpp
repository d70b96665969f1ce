#include "murosimf/viewer/view_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/scene/drawing_packets_json.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::viewer {

/// The report of the run, and what the window has shown.
std::string to_json(Viewer& viewer, const WindowReport& shown, const std::optional<scene::DrawingPackets>& packets) {
  using nlohmann::json;
  const scene::Scene& scene = viewer.running().scene();
  const scene::RunReport report = make_report(scene);
  json document{{"schema", files::json_schema("view")},
                {"scene", report.scene},
                {"pictures", shown.pictures},
                {"wall_s", shown.wall},
                {"pictures_per_s", shown.wall > 0 ? static_cast<double>(shown.pictures) / shown.wall : 0},
                {"scene_ms", shown.scene_ms},
                {"drawn_by", shown.drawn_by},
                {"simulated_s", report.simulated},
                {"state_hash", viewer.recorded() ? json() : json(fmt::format("{:016x}", report.state_hash))},
                {"paused", viewer.status().paused},
                {"branch", viewer.status().branch},
                {"branches", viewer.branches().size()},
                {"selected", viewer.selected() ? json(viewer.outline().path_text(*viewer.selected())) : json()},
                {"screenshots", shown.files},
                {"drawings", scene::json_of(packets)},
                {"commands", json::array()},
                {"marks", json::array()},
                {"messages", json::array()},
                {"entities", json::array()}};
  for (const Command& command : scene.simulation().commands()) {
    document["commands"].push_back({{"time_s", seconds(command.time)}, {"text", command.text}});
  }
  for (const TimeMark& mark : viewer.events().marks()) {
    document["marks"].push_back({{"time_s", mark.time}, {"branch", mark.branch}, {"text", mark.text}});
  }
  for (const Message& message : viewer.messages()) {
    document["messages"].push_back({{"text", message.text}, {"error", message.error}});
  }
  for (const scene::EntityReport& entity : report.entities) {
    const Vec3d& r = entity.position;
    document["entities"].push_back({{"name", entity.name},
                                    {"level", entity.level},
                                    {"contact", entity.contact},
                                    {"position", {r.x, r.y, r.z}},
                                    {"falls", entity.falls},
                                    {"present", entity.present}});
  }
  return files::json_text(document);
}

std::string to_text(Viewer& viewer, const WindowReport& shown) {
  return fmt::format(
      "{}: {:.3f} s simulated, {} pictures in {:.1f} s ({:.1f} per second, {:.1f} ms for the scene), drawn by {}\n",
      viewer.running().scene().spec().name, seconds(viewer.running().scene().simulation().now()), shown.pictures,
      shown.wall, static_cast<double>(shown.pictures) / std::max(1e-9, shown.wall), shown.scene_ms, shown.drawn_by);
}

}  // namespace murosimf::viewer

// Robots with their levels and laws; the tree of entities and objects with the properties of open ones.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

template <class Entries>
std::vector<std::string> names_of(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  return names;
}

/// The level is exchanged during the run, with the present motion.
void choose_level(Panels& panels, int entity, const EntityState& state, float width) {
  const auto levels = names_of(catalog::levels());
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleColor(ImGuiCol_Text, vec4(color_of_level(state.level)));
  const auto level = panels.gui.choice(state.name + " level", state.level, levels);
  ImGui::PopStyleColor();
  tip("level of detail");
  if (level) panels.viewer.steering.switch_level(entity, levels[*level]);
}

void choose_contact(Panels& panels, int entity, const EntityState& state, float width) {
  const auto laws = names_of(catalog::contacts());
  ImGui::SetNextItemWidth(width);
  const auto law =
      panels.gui.choice(state.name + " contact", state.contact.empty() ? "no contact forces" : state.contact, laws);
  tip("law of contact with the ground");
  if (law) panels.viewer.steering.switch_contact(entity, laws[*law]);
}

std::string state_text(const EntityState& state) {
  std::string line;
  if (!state.present) line += "  not there";
  if (state.frozen) line += "  frozen";
  if (state.falls > 0) line += fmt::format("  {} fall{}", state.falls, state.falls == 1 ? "" : "s");
  return line;
}

/// Outline and inspection may be of different instants: only entities of both are shown.
void robots_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  const std::size_t count = std::min(viewer.outline().size(), viewer.seen().entities.size());
  const bool roomy = std::ranges::count_if(viewer.outline(), &EntityOutline::is_robot) <= 8;
  for (std::size_t i = 0; i < count; ++i) {
    const EntityOutline& outline = viewer.outline()[i];
    const EntityState& state = viewer.seen().entities[i];
    if (!outline.moves) continue;
    const int entity = static_cast<int>(i);
    const bool selected = viewer.selected_entity() == entity;
    ImGui::PushID(entity);
    ImGui::PushStyleColor(ImGuiCol_Text, vec4({0.4 + 0.6 * outline.color.red, 0.4 + 0.6 * outline.color.green,
                                               0.4 + 0.6 * outline.color.blue}));
    const std::string key = outline.label >= 0 && outline.label < 9 ? fmt::format("{}  ", outline.label + 1)
                            : outline.is_ball                       ? "0  "
                                                                    : "    ";
    if (ImGui::Selectable((key + outline.name + "##who").c_str(), selected)) viewer.select(ObjectPath{entity, 0});
    panels.gui.remember(outline.name);
    ImGui::PopStyleColor();
    if (const std::string more = state_text(state); !more.empty()) {
      ImGui::SameLine();
      text(more, {0.95, 0.7, 0.4});
    }
    if (roomy || selected) {
      const float width = ImGui::GetContentRegionAvail().x;
      ImGui::BeginDisabled(viewer.recorded());
      if (outline.is_robot) choose_level(panels, entity, state, 0.56F * width);
      if (outline.is_robot) ImGui::SameLine();
      choose_contact(panels, entity, state, -1);
      ImGui::EndDisabled();
    }
    ImGui::PopID();
  }
}

void object_row(Panels& panels, const ObjectPath& path, const std::string& name) {
  Viewer& viewer = panels.viewer;
  const bool selected = viewer.selected() == path;
  const ImGuiTreeNodeFlags flags =
      ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth | (selected ? ImGuiTreeNodeFlags_Selected : 0);
  const bool open = ImGui::TreeNodeEx(name.c_str(), flags);
  panels.gui.remember(viewer.outline().path_text(path));
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) viewer.select(path);
  viewer.open_objects[path] = open || selected;
  if (!open) return;
  properties_of(panels, path);
  ImGui::TreePop();
}

/// With a filter, the tree is open where something matches.
void tree_tab(Panels& panels) {
  Viewer& viewer = panels.viewer;
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", "objects with this in their names", panels.state.filter.data(),
                           panels.state.filter.size());
  const std::string filter(panels.state.filter.data());
  for (std::size_t i = 0; i < viewer.outline().size(); ++i) {
    const EntityOutline& outline = viewer.outline()[i];
    const bool open = ImGui::TreeNodeEx(outline.name.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    panels.gui.remember(outline.name);
    if (!open) continue;
    for (int object = 0; object < outline.model->size(); ++object) {
      const std::string& name = outline.model->objects()[static_cast<std::size_t>(object)].name;
      if (!filter.empty() && name.find(filter) == std::string::npos) continue;
      object_row(panels, {static_cast<int>(i), object}, name);
    }
    ImGui::TreePop();
  }
}

/// All numbers in one editable field.
void edit_value(Panels& panels, const ObjectPath& path, const PropertyValue& property) {
  PanelState& state = panels.state;
  const bool edited = state.edited == path && state.edited_property == property.name;
  std::string shown;
  for (const double number : property.numbers)
    shown += (shown.empty() ? "" : "  ") + (edited ? fmt::format("{}", number) : number_text(number));
  std::array<char, 128> buffer{};
  if (edited) {
    buffer = state.edit;
  } else {
    std::snprintf(buffer.data(), buffer.size(), "%s", shown.c_str());
  }
  ImGui::SetNextItemWidth(-1);
  const std::string id = "##" + property.name;
  const bool entered = ImGui::InputText(id.c_str(), buffer.data(), buffer.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  panels.gui.remember(property.name);
  panels.gui.remember(panels.viewer.outline().path_text(path) + "." + property.name);
  if (ImGui::IsItemActive()) {
    state.edited = path;
    state.edited_property = property.name;
    state.edit = buffer;
  } else if (edited) {
    state.edited_property.clear();
  }
  if (!entered) return;
  PropertyValue next = property;
  next.numbers.clear();
  const char* place = buffer.data();
  char* end = nullptr;
  for (double number = std::strtod(place, &end); end != place; number = std::strtod(place, &end)) {
    next.numbers.push_back(number);
    place = end;
    while (*place == ' ' || *place == ',') ++place;
  }
  if (*place != '\0' || next.numbers.empty()) {
    panels.viewer.tell(fmt::format("'{}' are no numbers", buffer.data()), true);
  } else {
    panels.viewer.steering.set_property(path, next);
  }
}

/// The most frequently used items, shown first.
std::vector<const PropertyValue*> usual_first(const std::vector<PropertyValue>& properties) {
  constexpr std::array<std::string_view, 10> usual{"position",         "orientation",    "linear_velocity",
                                                   "angular_velocity", "joint_position", "joint_velocity",
                                                   "joint_target",     "joint_torque",   "walk_command",
                                                   "applied_force"};
  std::vector<const PropertyValue*> sorted;
  for (const PropertyValue& property : properties) sorted.push_back(&property);
  std::ranges::stable_sort(sorted, {},
                           [&](const PropertyValue* p) { return std::ranges::find(usual, p->name) - usual.begin(); });
  return sorted;
}

}  // namespace

/// Values come with the next inspection after the selection.
void properties_of(Panels& panels, const ObjectPath& path) {
  Viewer& viewer = panels.viewer;
  const auto values = std::ranges::find(viewer.seen().objects, path, &ObjectValues::path);
  if (values == viewer.seen().objects.end()) return text("...", faint);
  if (!ImGui::BeginTable("properties", 2, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.48F);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.52F);
  for (const PropertyValue* shown : usual_first(values->properties)) {
    const PropertyValue& property = *shown;
    ImGui::PushID(property.name.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (!property.constant) ImGui::AlignTextToFramePadding();
    if (property.constant || property.numbers.size() > 9) {
      text(property.name, faint);
    } else if (ImGui::Selectable(property.name.c_str())) {
      viewer.plots.add(viewer.outline(), path, property.name, false);
    }
    panels.gui.remember("plot " + property.name);
    tip(fmt::format("{} [{}]\n{}", property.name, property.unit,
                    property.constant ? "constant of the model" : "click: plot it over time"));
    ImGui::TableNextColumn();
    if (property.constant || viewer.recorded()) {
      std::string numbers;
      for (const double number : property.numbers) numbers += (numbers.empty() ? "" : "  ") + number_text(number);
      text(numbers, property.constant ? faint : Color{0.9, 0.92, 0.95});
    } else {
      edit_value(panels, path, property);
    }
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void left_panel(Panels& panels, const Area& area) {
  begin_part("left", area);
  if (ImGui::BeginTabBar("left tabs")) {
    const bool robots = ImGui::BeginTabItem("Robots");
    panels.gui.remember("Robots");
    if (robots) {
      ImGui::BeginChild("robots");
      robots_tab(panels);
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    const bool tree = ImGui::BeginTabItem("Tree");
    panels.gui.remember("Tree");
    if (tree) {
      ImGui::BeginChild("tree");
      tree_tab(panels);
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

}  // namespace murosimf::viewer

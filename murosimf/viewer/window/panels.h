/// panels.h - the parts of the window around the picture. Each reads the viewer, and passes user input to it.
///
/// Only for the .cpp files of this folder: it includes ImGui.
#pragma once

#include <array>
#include <string>

#include "murosimf/viewer/timeline_layout.h"
#include "murosimf/viewer/viewer.h"
#include "murosimf/viewer/window/gui.h"
#include "murosimf/viewer/window/picture.h"

namespace murosimf::viewer {

inline constexpr Color faint{0.6, 0.62, 0.65};  ///< of explanatory text

/// A rectangle of the window [px].
struct Area {
  double x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool holds(const Pixel& pixel) const {
    return pixel.x >= x && pixel.x < x + width && pixel.y >= y && pixel.y < y + height;
  }
};

/// State of panels kept from picture to picture.
struct PanelState {
  PictureQuality quality;
  double plot_seconds = 10;  ///< of simulated time that plots show
  ObjectPath edited;         ///< object of the focused property
  std::string edited_property;
  std::array<char, 128> edit{};   ///< its text
  std::array<char, 64> filter{};  ///< of the tree
  bool scrubs = false;            ///< the timeline is being dragged
  double scrubbed_to = -1;        ///< [s]
  int scrubbed_branch = 0;
  Area timeline;                                     ///< area of the times, for scripts
  double timeline_end = 1;                           ///< [s]
  std::vector<imaging::ColorImage> camera_pictures;  ///< of the selected entity, by camera
  double frames_per_second = 0;
  std::string drawn_by;
};

/// Input of panels.
struct Panels {
  Gui& gui;
  Viewer& viewer;
  PanelState& state;
  const KeyMap& keys;
};

void toolbar(Panels& panels, const Area& area);
/// Robots with their levels and laws, and the tree of entities, objects, properties.
void left_panel(Panels& panels, const Area& area);
/// The selection, its sensors, plots, algorithms, events, view.
void right_panel(Panels& panels, const Area& area, std::vector<std::unique_ptr<Texture>>& camera_pictures);
void timeline_panel(Panels& panels, const Area& area);
void field_map(Panels& panels, const Area& area);
void help_window(Panels& panels, const Area& area);

// Parts of these.
void properties_of(Panels& panels, const ObjectPath& path);
void sensors_tab(Panels& panels, std::vector<std::unique_ptr<Texture>>& camera_pictures);
void plots_tab(Panels& panels);
void events_tab(Panels& panels);
void algorithms_tab(Panels& panels);
void view_tab(Panels& panels);
void joints_tab(Panels& panels);
/// Curves of the last `window` [s] until `now` [s].
void draw_plot(const Plot& plot, double now, double window, double width, double height);
[[nodiscard]] std::string number_text(double number);

/// Begins a fixed part of the window; ImGui::End() ends it.
void begin_part(const char* name, const Area& area);

/// Contacts, forces, names and the like over the picture in `area`; a push in preparation.
void paint_overlays(const Overlays& overlays, const sensors::Perspective& view, const Area& area);
void paint_pull(const MouseControl::Pull& pull, const sensors::Perspective& view, const Area& area);
/// Debug drawings.
void paint_drawings(const std::vector<render::SeenShape>& shapes, const Area& area);
/// A frame around the selection.
void paint_selection(const Viewer& viewer, const sensors::Perspective& view, const Area& area);

}  // namespace murosimf::viewer

/// gl_target.h - memory to draw into: colors, depths and labels of one size.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <vector>

#include "murosimf/render/opengl/gl_handles.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render {

class GlTarget {
 public:
  /// `samples` to a pixel apply to colors alone. Throws SetupError if the driver does not support it.
  GlTarget(int width, int height, int samples);

  [[nodiscard]] bool fits(int width, int height, int samples) const;
  /// Directs drawing here, to the attachments of `layers`, cleared; rows of the view only.
  void begin(const sensors::Perspective& view, const sensors::Layers& layers, const Color& background);
  /// Restricts drawing to these layers.
  void draw_layers(const sensors::Layers& layers);
  /// Copies what was drawn, row 0 first.
  void read(const sensors::Perspective& view, const sensors::Layers& layers, sensors::View& into);

 private:
  void read_colors(int first, int rows, imaging::ColorImage& into);

  int width_, height_, samples_;
  GlFramebuffer frame_, resolved_;
  GlRenderbuffer color_, depth_buffer_, depth_, label_, resolved_color_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace murosimf::render

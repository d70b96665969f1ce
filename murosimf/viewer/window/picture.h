/// picture.h - the scene as a texture: a frame of poses drawn by the renderer of cameras.
///
/// The renderer draws into its own context, without the window, and its picture is copied into a texture of the window: simple, the
/// same pixels as `murosimf render`, and 2 to 3 ms at 1280x720.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "murosimf/render/renderer.h"
#include "murosimf/viewer/mouse_control.h"
#include "murosimf/viewer/viewer.h"

namespace murosimf::viewer {

struct PictureQuality {
  int samples = 4;
  bool shadows = true;
  friend bool operator==(const PictureQuality&, const PictureQuality&) = default;
};

class ScenePicture {
 public:
  /// Follows changes of the viewer's scene. Throws SetupError if drawing is impossible here. No context of the window may be
  /// current in all calls but show().
  explicit ScenePicture(Viewer& viewer);

  /// Draws the viewer's present frame.
  void draw(const sensors::Perspective& view, const PictureQuality& quality, sensors::View& into);
  [[nodiscard]] std::optional<Hit> pick(const sensors::Perspective& view, const Pixel& pixel);
  [[nodiscard]] std::string drawn_by() const { return renderer_->name(); }
  /// Whether the processor draws, not a graphics card.
  [[nodiscard]] bool software() const { return renderer_->on_processor(); }

 private:
  void renew(const PictureQuality& quality);

  Viewer& viewer_;
  std::unique_ptr<render::Renderer> renderer_;
  render::ShownMoment moment_;
  int generation_ = 0, changes_ = 0;
  PictureQuality quality_;
  sensors::View picked_;
};

/// A texture of the current context.
class Texture {
 public:
  Texture() = default;
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;
  void fill(const imaging::ColorImage& image);
  [[nodiscard]] unsigned name() const { return name_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  unsigned name_ = 0;
  int width_ = 0, height_ = 0;
};

/// The present contents of the window, row 0 at the top.
[[nodiscard]] imaging::ColorImage read_window(int width, int height);

}  // namespace murosimf::viewer

#include "murosimf/viewer/window/picture.h"

#include <algorithm>
#include <cmath>

#include <epoxy/gl.h>

#include "murosimf/model/error.h"
#include "murosimf/scene/scene_pictures.h"

namespace murosimf::viewer {
namespace {

constexpr Color standing_foot{1, 0.85, 0};
constexpr int coarse_shadows = 1024;  // [px]

}  // namespace

ScenePicture::ScenePicture(Viewer& viewer) : viewer_(viewer) { renew({}); }

void ScenePicture::renew(const PictureQuality& quality) {
  renderer_.reset();  // it may belong to a scene that was replaced
  viewer_.session()
      .visit([&](scene::Scene& scene) {
        scene_file::LightSpec light = scene.spec().light;
        light.samples = quality.samples;
        light.shadows = quality.shadows;
        renderer_ = scene::make_renderer(scene, light);
        changes_ = scene.parts().changes_to_see;
      })
      .get();
  renderer_->mark_standing_feet(standing_foot);
  renderer_->label_pieces();
  if (software()) renderer_->set_shadow_side(coarse_shadows);
  renderer_->show(&moment_);
  generation_ = viewer_.generation();
  quality_ = quality;
}

/// The scene of the picture is made anew when the scene, its appearance or the quality has changed.
void ScenePicture::draw(const sensors::Perspective& view, const PictureQuality& quality, sensors::View& into) {
  const bool other = generation_ != viewer_.generation() || changes_ != viewer_.seen().changes_to_see;
  if (other || !(quality == quality_)) renew(quality);
  moment_.frame = viewer_.poses().frame();
  moment_.standing_feet.clear();
  for (const EntityState& entity : viewer_.seen().entities) {
    const bool marked = viewer_.overlay.standing_feet && entity.standing_foot >= 0;
    moment_.standing_feet.push_back(marked ? entity.standing_foot : -2);
  }
  if (moment_.frame) renderer_->draw(view, {}, 0, into);
  if (const std::string trouble = renderer_->trouble(); !trouble.empty()) throw SetupError(trouble);
}

/// A picture of a few pixels around the pointer is enough to find what is there.
std::optional<Hit> ScenePicture::pick(const sensors::Perspective& view, const Pixel& pixel) {
  if (generation_ != viewer_.generation() || !viewer_.poses().frame()) return std::nullopt;
  moment_.frame = viewer_.poses().frame();
  sensors::Perspective one = view;
  const double across = (view.right - view.left) / view.width, down = (view.bottom - view.top) / view.height;
  one.left = view.left + (std::floor(pixel.x)) * across;
  one.right = one.left + across;
  one.top = view.top + std::floor(pixel.y) * down;
  one.bottom = one.top + down;
  one.width = one.height = 1;
  renderer_->draw(one, {.color = false, .depth = true, .labels = true}, 0, picked_);
  const double depth = picked_.depth.empty() ? INFINITY : picked_.depth(0, 0);
  if (!std::isfinite(depth)) return std::nullopt;
  const Vec3d optical{0.5 * (one.left + one.right), 0.5 * (one.top + one.bottom), 1};
  Hit hit{std::nullopt, view.eye + view.axes * (depth * optical)};
  const int piece = picked_.labels(0, 0) - int{render::RenderScene::first_piece_label};
  const auto& pieces = renderer_->scene().drawables();
  if (piece >= 0 && static_cast<std::size_t>(piece) < pieces.size()) {
    const render::Drawable& shown = pieces[static_cast<std::size_t>(piece)];
    hit.path = ObjectPath{shown.owner, shown.object};
  }
  return hit;
}

Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

/// The texture's memory is used again while the size stays the same.
void Texture::fill(const imaging::ColorImage& image) {
  if (image.empty()) return;
  const bool is_new = name_ == 0 || image.width() != width_ || image.height() != height_;
  if (name_ == 0) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (is_new) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width(), image.height(), 0, GL_RGB, GL_UNSIGNED_BYTE,
                 image.pixels().data());
    width_ = image.width();
    height_ = image.height();
  } else {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, image.pixels().data());
  }
}

/// Rows of OpenGL begin at the bottom.
imaging::ColorImage read_window(int width, int height) {
  imaging::ColorImage upside_down(width, height), image(width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.pixels().data());
  for (int v = 0; v < height; ++v) std::ranges::copy(upside_down.row(height - 1 - v), image.row(v).begin());
  return image;
}

}  // namespace murosimf::viewer

#include "murosimf/render/opengl/gl_target.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::render {
namespace {

void allocate(GLuint name, GLenum format, int width, int height, int samples) {
  MUROSIMF_ASSERT(width > 0 && height > 0 && samples >= 1);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  if (samples > 1) {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  } else {
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  }
}

void attach(GLenum where, GLuint name) { glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, name); }

void check_frame(int width, int height, int samples) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR) return;
  throw SetupError(
      fmt::format("the OpenGL driver cannot draw pictures of {}x{} pixels with {} samples", width, height, samples));
}

}  // namespace

GlTarget::GlTarget(int width, int height, int samples) : width_(width), height_(height), samples_(samples) {
  glBindFramebuffer(GL_FRAMEBUFFER, *frame_);
  allocate(*color_, GL_RGBA8, width, height, samples);
  attach(GL_COLOR_ATTACHMENT0, *color_);
  allocate(*depth_buffer_, GL_DEPTH_COMPONENT32F, width, height, samples);
  // Depths and labels have no meaningful mean: targets with several samples have colors alone.
  attach(GL_DEPTH_ATTACHMENT, *depth_buffer_);
  if (samples == 1) {
    allocate(*depth_, GL_R32F, width, height, 1);
    attach(GL_COLOR_ATTACHMENT1, *depth_);
    allocate(*label_, GL_R16UI, width, height, 1);
    attach(GL_COLOR_ATTACHMENT2, *label_);
  }
  check_frame(width, height, samples);
  if (samples == 1) return;
  glBindFramebuffer(GL_FRAMEBUFFER, *resolved_);
  allocate(*resolved_color_, GL_RGBA8, width, height, 1);
  attach(GL_COLOR_ATTACHMENT0, *resolved_color_);
  check_frame(width, height, 1);
}

bool GlTarget::fits(int width, int height, int samples) const {
  return width == width_ && height == height_ && samples == samples_;
}

void GlTarget::begin(const sensors::Perspective& view, const sensors::Layers& layers, const Color& background) {
  MUROSIMF_ASSERT(view.first_row >= 0 && view.first_row + view.rows <= height_);
  glBindFramebuffer(GL_FRAMEBUFFER, *frame_);
  glViewport(0, 0, width_, height_);
  // Only the rows of this view: a camera with a rolling shutter draws a picture in several parts.
  glScissor(0, view.first_row, width_, view.rows);
  glEnable(GL_SCISSOR_TEST);
  draw_layers(layers);
  const std::array<GLfloat, 4> sky{static_cast<GLfloat>(background.red), static_cast<GLfloat>(background.green),
                                   static_cast<GLfloat>(background.blue), 1};
  constexpr std::array<GLfloat, 4> far{std::numeric_limits<GLfloat>::infinity(), 0, 0, 0};
  constexpr std::array<GLuint, 4> nothing{sensors::label_background, 0, 0, 0};
  constexpr GLfloat deepest = 1;
  if (layers.color) glClearBufferfv(GL_COLOR, 0, sky.data());
  if (layers.depth) glClearBufferfv(GL_COLOR, 1, far.data());
  if (layers.labels) glClearBufferuiv(GL_COLOR, 2, nothing.data());
  glClearBufferfv(GL_DEPTH, 0, &deepest);
}

void GlTarget::draw_layers(const sensors::Layers& layers) {
  const std::array<GLenum, 3> buffers{layers.color ? GL_COLOR_ATTACHMENT0 : GLenum{GL_NONE},
                                      layers.depth ? GL_COLOR_ATTACHMENT1 : GLenum{GL_NONE},
                                      layers.labels ? GL_COLOR_ATTACHMENT2 : GLenum{GL_NONE}};
  glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
}

void GlTarget::read_colors(int first, int rows, imaging::ColorImage& into) {
  MUROSIMF_ASSERT(first >= 0 && rows >= 0 && first + rows <= height_);
  bytes_.resize(std::size_t{4} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows));
  if (samples_ > 1) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, *frame_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, *resolved_);
    // Multisampled buffers cannot be read directly: the copy takes the mean of the samples.
    glBlitFramebuffer(0, first, width_, first + rows, 0, first, width_, first + rows, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, *resolved_);
  }
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, first, width_, rows, GL_RGBA, GL_UNSIGNED_BYTE, bytes_.data());
  imaging::Rgb* pixel = into.row(first).data();
  for (std::size_t i = 0; i < bytes_.size(); i += 4) *pixel++ = {bytes_[i], bytes_[i + 1], bytes_[i + 2]};
}

void GlTarget::read(const sensors::Perspective& view, const sensors::Layers& layers, sensors::View& into) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, *frame_);
  MUROSIMF_ASSERT(view.first_row >= 0 && view.first_row + view.rows <= height_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);  // rows of the pictures are not padded
  if (layers.depth) {
    imaging::fit(into.depth, width_, height_);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glReadPixels(0, view.first_row, width_, view.rows, GL_RED, GL_FLOAT, into.depth.row(view.first_row).data());
  }
  if (layers.labels) {
    imaging::fit(into.labels, width_, height_);
    glReadBuffer(GL_COLOR_ATTACHMENT2);
    glReadPixels(0, view.first_row, width_, view.rows, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                 into.labels.row(view.first_row).data());
  }
  if (layers.color) {
    imaging::fit(into.color, width_, height_);
    read_colors(view.first_row, view.rows, into.color);
  }
}

}  // namespace murosimf::render

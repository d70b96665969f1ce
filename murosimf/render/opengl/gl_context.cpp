#include "murosimf/render/opengl/gl_context.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/opengl/driver_memory.h"

namespace murosimf::render {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw SetupError(
      fmt::format("no pictures by OpenGL: {} (Debian and Ubuntu: install libegl1, libegl-mesa0 and "
                  "libgl1-mesa-dri; no graphics card or window system is needed)",
                  reason));
}

/// Checks for libraries without which epoxy ends the program.
void check_libraries() {
  // The libraries stay loaded: epoxy finds them by the same names.
  const auto loads = [](const char* name) { return dlopen(name, RTLD_LAZY | RTLD_LOCAL) != nullptr; };
  if (!loads("libEGL.so.1")) refuse("libEGL.so.1 is not installed");
  if (!loads("libOpenGL.so.0") && !loads("libGL.so.1")) refuse("neither libOpenGL.so.0 nor libGL.so.1 is installed");
}

/// Whether Mesa says that the processor draws, which is quicker to know than by a context.
bool is_named_software(EGLDeviceEXT device) {
  const char* const extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  return extensions && std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

/// Graphics cards first; none if EGL does not list them.
std::vector<EGLDeviceEXT> devices() {
  const bool can_list = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
                        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base");
  if (!can_list || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) return {};
  std::vector<EGLDeviceEXT> found(16);
  EGLint count = 0;
  if (!eglQueryDevicesEXT(static_cast<EGLint>(found.size()), found.data(), &count)) return {};
  MUROSIMF_ASSERT(count >= 0 && static_cast<std::size_t>(count) <= found.size());
  found.resize(static_cast<std::size_t>(count));
  return found;
}

/// Displays to try: of devices, then Mesa's own without a card. Never one of a window system.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> found;
  for (EGLDeviceEXT device : devices())
    found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return found;
}

/// A context of the display; none if it cannot provide one.
EGLContext make_context(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") || !eglBindAPI(EGL_OPENGL_API)) {
    return EGL_NO_CONTEXT;
  }
  constexpr std::array<EGLint, 7> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                         EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count)) return EGL_NO_CONTEXT;
  if (count == 0) config = nullptr;  // EGL_KHR_no_config_context
  constexpr std::array<EGLint, 7> version{
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
}

}  // namespace

bool finds_graphics_card() {
  try {
    check_driver_memory();
    check_libraries();
    const std::vector<EGLDeviceEXT> listed = devices();
    if (!listed.empty() && std::ranges::all_of(listed, is_named_software)) return false;
    return !GlContext().software();
  } catch (const SetupError&) {
    return false;
  }
}

struct GlContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

GlContext::GlContext() : handles_(std::make_unique<Handles>()) {
  check_driver_memory();
  check_libraries();
  for (EGLDisplay display : displays()) {
    EGLContext context = make_context(display);
    if (context == EGL_NO_CONTEXT) continue;
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      eglDestroyContext(display, context);
      continue;
    }
    *handles_ = {display, context};
    renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    // Contexts are current in one thread at a time: another thread may draw with it later.
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    return;
  }
  refuse("no EGL device can do OpenGL 3.3");
}

// Displays are shared by all contexts of the program, and remain.
GlContext::~GlContext() { eglDestroyContext(handles_->display, handles_->context); }

bool GlContext::software() const {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "SwiftShader"}) {
    if (renderer_.find(name) != std::string::npos) return true;
  }
  return false;
}

GlContext::Current::Current(const GlContext& context) : context_(context) {
  eglBindAPI(EGL_OPENGL_API);  // the setting belongs to the thread
  MUROSIMF_ASSERT(context_.handles_->context != EGL_NO_CONTEXT);
  eglMakeCurrent(context_.handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_.handles_->context);
}

GlContext::Current::~Current() {
  eglMakeCurrent(context_.handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace murosimf::render

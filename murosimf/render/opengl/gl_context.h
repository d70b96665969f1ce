/// gl_context.h - OpenGL without any window system: a context of EGL that draws into memory.
#pragma once

#include <memory>
#include <string>

namespace murosimf::render {

/// Whether a device of EGL is a graphics card that can do OpenGL 3.3.
[[nodiscard]] bool finds_graphics_card();

/// One context. Only one thread may use it at a time, between `Current`'s constructor and destructor.
class GlContext {
 public:
  /// Uses the first EGL device with OpenGL 3.3. Throws SetupError with the packages to install.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// While it lives, OpenGL calls of this thread apply to the context.
  class Current {
   public:
    explicit Current(const GlContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    const GlContext& context_;
  };

  /// Name that the driver reports: "llvmpipe (LLVM 15.0.6, 256 bits)".
  [[nodiscard]] const std::string& renderer() const { return renderer_; }
  /// Whether the processor draws, not a graphics card.
  [[nodiscard]] bool software() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  std::string renderer_;
};

}  // namespace murosimf::render

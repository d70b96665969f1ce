#include "murosimf/render/renderer.h"

#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/render/opengl_renderer.h"
#include "murosimf/render/software_renderer.h"

namespace murosimf::render {
namespace {

constexpr const char* variable = "MUROSIMF_RENDERER";

bool wants_opengl() {
  const char* const wanted = std::getenv(variable);
  const std::string_view name = wanted ? wanted : "";
  if (name.empty()) return has_graphics_card();
  if (name == "opengl") return true;
  if (name == "software") return false;
  throw SetupError(fmt::format("{}={}: must be 'opengl' or 'software'", variable, name));
}

}  // namespace

std::unique_ptr<Renderer> make_renderer(const World& world, const std::vector<Entity*>& moving_entities,
                                        const AppearanceOf& appearance, const RendererOptions& options) {
  if (wants_opengl()) return std::make_unique<OpenGlRenderer>(world, moving_entities, appearance, options);
  return std::make_unique<SoftwareRenderer>(world, moving_entities, appearance, options);
}

}  // namespace murosimf::render

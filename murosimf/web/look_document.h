/// look_document.h - light, materials and surroundings of a scene for the page, as in every other picture (render/look.h).
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "murosimf/render/light.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::web {

/// The key `look` of a scene document; numbers of surfaces and of the pile are appended to `data`, which keeps a multiple of four bytes.
[[nodiscard]] nlohmann::json look_document(const render::Light& light, const render::RenderScene& looks,
                                           std::string& data);

}  // namespace murosimf::web

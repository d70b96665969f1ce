// [air] of a scene file.
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {

const Section<AirSpec>& air_section() {
  static const Section<AirSpec> section("[air]",
                                        {{"density", &AirSpec::density, "kg/m^3", "0: there is no air", between(0, 10)},
                                         {"wind", &AirSpec::wind, "m/s", "in the world, everywhere the same",
                                          up_to(100)}});
  return section;
}

void read_air(const files::TomlTable& scene, SceneSpec& spec) {
  if (const toml::table* node = scene.table("air")) air_section().read(*node, spec.air);
}

}  // namespace murosimf::scene_file

#include "murosimf/render/light.h"

#include <array>

namespace murosimf::render {
namespace {

constexpr std::array named{
    NamedLight{"hall", "lamps above, soft shadows' worth of light from everywhere", {}},
    NamedLight{"day",
               "low sun through windows",
               {.toward = {0.7, -0.45, 0.55},
                .lamp = {1.05, 1.0, 0.88},
                .sky = {0.38, 0.44, 0.54},
                .ground = {0.20, 0.22, 0.19},
                .background = {0.62, 0.76, 0.90}}},
    NamedLight{"night",
               "one weak lamp in the dark",
               {.toward = {0.2, 0.5, 0.8},
                .lamp = {0.12, 0.11, 0.085},
                .sky = {0.03, 0.032, 0.045},
                .ground = {0.012, 0.013, 0.015},
                .background = {0.04, 0.045, 0.07}}},
};

}  // namespace

std::span<const NamedLight> lights() { return named; }

}  // namespace murosimf::render

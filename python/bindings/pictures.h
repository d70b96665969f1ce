/// pictures.h - pictures as arrays.
#pragma once

#include <nanobind/nanobind.h>

#include "murosimf/sensors.h"

namespace murosimf::python {

/// (rgb, mosaic, depth, labels), None where the picture is without.
[[nodiscard]] nanobind::tuple layers_of(Image image);

}  // namespace murosimf::python

#include "pictures.h"

#include <initializer_list>
#include <utility>
#include <vector>

#include "arrays.h"

namespace murosimf::python {
namespace {

template <class Number>
nb::object layer(std::vector<Number> numbers, std::initializer_list<std::size_t> shape) {
  return numbers.empty() ? nb::none() : nb::cast(array_of(std::move(numbers), shape));
}

}  // namespace

nb::tuple layers_of(Image image) {
  const auto height = static_cast<std::size_t>(image.height), width = static_cast<std::size_t>(image.width);
  return nb::make_tuple(layer(std::move(image.rgb), {height, width, 3}),
                        layer(std::move(image.mosaic), {height, width}), layer(std::move(image.depth), {height, width}),
                        layer(std::move(image.labels), {height, width}));
}

}  // namespace murosimf::python

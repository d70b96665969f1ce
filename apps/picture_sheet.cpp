#include "apps/picture_sheet.h"

#include <algorithm>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/picture_files.h"
#include "murosimf/files/output_file.h"
#include "murosimf/render/caption.h"
#include "murosimf/render/image_png.h"

namespace murosimf::app {
namespace {

constexpr int largest_sheet = 16384;  // [px]

void paste(const imaging::ColorImage& picture, int left, int top, imaging::ColorImage& into) {
  for (int v = 0; v < picture.height(); ++v) {
    std::ranges::copy(picture.row(v), into.row(top + v).subspan(static_cast<std::size_t>(left)).begin());
  }
}

}  // namespace

SheetSize read_sheet(const RenderOptions& options) {
  const std::optional<PictureSize> sheet = size_in(options.sheet);
  if (!sheet) throw SetupError(fmt::format("--sheet '{}': write COLUMNSxROWS, like 4x3", options.sheet));
  if (has_numbers(options)) {
    throw SetupError(fmt::format("--sheet: --layer {} has numbers, which a sheet does not keep", options.layer));
  }
  const PictureSize each = read_size(options.size.empty() ? sheet_picture : options.size);
  const auto too_large = [](int count, int side) { return std::int64_t{count} * side > largest_sheet; };
  if (too_large(sheet->width, each.width) || too_large(sheet->height, each.height)) {
    throw SetupError(fmt::format("--sheet {}: more than {} pixels wide or high", options.sheet, largest_sheet));
  }
  return {sheet->width, sheet->height};
}

bool write_sheet(PictureSource& source, Simulation& simulation, const RenderOptions& options, double duration) {
  const SheetSize size = read_sheet(options);
  const int count = size.columns * size.rows;
  const Duration begin = simulation.now();
  imaging::ColorImage sheet;
  for (int i = 0; i < count; ++i) {
    run_with_progress(simulation, begin + from_seconds(count == 1 ? 0 : duration * i / (count - 1)));
    auto taken = interrupted() ? std::nullopt : source.take(simulation.now());
    if (!taken) return false;
    auto& picture = std::get<imaging::ColorImage>(*taken);
    render::draw_caption(picture, fmt::format("{:.2f} s", seconds(simulation.now())));
    if (sheet.empty()) sheet = {size.columns * picture.width(), size.rows * picture.height()};
    paste(picture, i % size.columns * picture.width(), i / size.columns * picture.height(), sheet);
  }
  files::write_file(options.out, render::image_png(sheet));
  return true;
}

}  // namespace murosimf::app

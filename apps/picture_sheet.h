/// picture_sheet.h - a contact sheet: pictures of a running scene in rows, in one PNG file.
#pragma once

#include "apps/picture_source.h"

namespace murosimf::app {

struct SheetSize {
  int columns = 0, rows = 0;
};

inline constexpr const char* sheet_picture = "480x270";  ///< size of each if none is given

/// "4x3", as given to --sheet; checks also that all of it has at most 16384 pixels a side. Throws SetupError.
[[nodiscard]] SheetSize read_sheet(const RenderOptions& options);

/// `duration` [s] from now, at equal distances, the first picture now and the last one at the end. False if it was interrupted: nothing is
/// written then.
bool write_sheet(PictureSource& source, Simulation& simulation, const RenderOptions& options, double duration);

}  // namespace murosimf::app

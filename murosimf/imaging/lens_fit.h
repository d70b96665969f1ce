/// lens_fit.h - one lens in the words of another model.
#pragma once

#include <string>

#include "murosimf/imaging/lens.h"

namespace murosimf::imaging {

struct LensFit {
  LensSpec spec;
  double largest_error = 0;  ///< [px], between where both see the same ray, over the whole picture
  double usual_error = 0;    ///< [px], root of the mean square of that
  Pixel where;               ///< of the largest error, in the picture of the first lens
};

/// The lens of the other model that sees rays where `lens` sees them: least squares over pixels of the whole picture,
/// of focal lengths, center, skew if there is one, and all coefficients; of ray_polynomial a1 is 1, since the focal length says
/// the same. Source: Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", J. SIAM 11 (1963).
/// Throws SetupError if there is no such model, or if it cannot show what the lens sees.
[[nodiscard]] LensFit fit_lens(const Lens& lens, const std::string& model);

}  // namespace murosimf::imaging

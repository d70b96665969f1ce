/// pair_law.h - how two moving bodies push each other: chosen by name, for a whole scene.
///
/// * island_gauss_seidel (default): nothing is pushed here; the island solver settles all contacts of touching
///   entities together (island_contact.h).
/// * carry: either body is implicit in its own acceleration alone, B = h b with b = b_n n n^T + b_t (1 - n n^T):
///   A feels f0 - B a_A, B feels -f0 - B a_B. What they feel together, e = -B (a_A + a_B), should be nothing; half of
///   it is given back to either one in the next step, so the momentum is late but not lost. For steps up to 2 ms.
/// * kelvin_voigt: explicit spring and damper with viscous friction up to mu f_n:
///   f_n = max(0, k depth - d v_n),  f_t = -min(mu f_n, ct |v_t|) v_t / |v_t|.
///
/// Source: measured with the project's prototype; carry is a Gauss-Seidel splitting with a delayed correction.
#pragma once

#include <span>
#include <string_view>

namespace murosimf::collision {

enum class PairLaw { island_gauss_seidel, carry, kelvin_voigt };

struct PairLawEntry {
  std::string_view name, meaning;
  PairLaw law;
};

[[nodiscard]] std::span<const PairLawEntry> pair_laws();

}  // namespace murosimf::collision

/// doctor_cases.h - what the doctor changes of a scene, one thing at a time.
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/studies/doctor.h"

namespace murosimf::studies {

struct DoctorCase {
  std::string label;                   ///< "0.5 ms"
  std::vector<std::string> overrides;  ///< PATH=VALUE
  std::optional<std::uint64_t> seed;   ///< instead of the scene's
};

struct CasesOfDimension {
  std::string name;
  std::string skipped;  ///< why there are none
  std::vector<DoctorCase> cases;
};

/// Of those that are asked for, in the order of doctor_dimensions(). `scene`: as it is. Throws SetupError for unknown dimensions.
[[nodiscard]] std::vector<CasesOfDimension> doctor_cases(const DoctorOptions& options, const scene::Scene& scene);

}  // namespace murosimf::studies

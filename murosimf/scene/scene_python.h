/// scene_python.h - algorithms of a scene that are classes in Python ([[algorithms]]).
#pragma once

#include <string>
#include <vector>

#include "murosimf/control_software/python/python_algorithm.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Reading a file must not run code that it names, unless the command line or a program permits it. Requests over a network cannot permit
/// it. `where`: the place at which `software` is named. Throws SetupError.
void refuse_software_of_file(const SceneParts& parts, const std::string& where, const std::string& software);

/// A class that was loaded, and what the scene file says of it.
struct LoadedClass {
  const scene_file::AlgorithmSpec* spec;
  control_software::PythonClass made;
  bool senses;
};
using LoadedClasses = std::vector<LoadedClass>;

/// Loads all of them; none for a run that is only shown. Throws SetupError with the place in the scene file.
[[nodiscard]] LoadedClasses load_classes(SceneParts& parts);

/// Attaches those that sense, or all others, once. Throws SetupError likewise.
void attach_classes(SceneParts& parts, LoadedClasses& classes, bool that_sense);

/// Why an algorithm has ended the run, with its name; empty: none has.
[[nodiscard]] std::string end_of_run(const SceneParts& parts);

}  // namespace murosimf::scene

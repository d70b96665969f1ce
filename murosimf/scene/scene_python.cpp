#include "murosimf/scene/scene_python.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::scene {
namespace {

using control_software::PythonAlgorithm;
using control_software::PythonClass;

constexpr double usual_rate = 100;  // [Hz] as of controllers

Entity& entity_of(const SceneParts& parts, const scene_file::AlgorithmSpec& spec) {
  World& world = parts.simulation->world();
  return spec.on.empty() ? world.common() : world.entity(spec.on);
}

PythonClass load(const SceneParts& parts, const scene_file::AlgorithmSpec& spec) {
  return with_context(spec.where, [&] {
    PythonClass made(entity_of(parts, spec), {.target = spec.target,
                                              .folder = parts.spec.file.parent_path(),
                                              .options = spec.options,
                                              .seed = parts.spec.seed,
                                              .budget = from_seconds(spec.call_budget),
                                              .algorithm = spec.name,
                                              .of_whole_scene = spec.on.empty()});
    if (spec.on.empty() && !made.traits().gives.empty()) {
      throw SetupError(fmt::format("'{}' gives readings, so it needs a robot: on = \"NAME\"", spec.name));
    }
    return made;
  });
}

void attach(SceneParts& parts, const scene_file::AlgorithmSpec& spec, PythonClass made) {
  const double of_class = made.traits().rate > 0 ? made.traits().rate : usual_rate;
  const double rate = spec.rate > 0 ? spec.rate : of_class;
  const bool senses = !made.traits().gives.empty();
  if (!senses && (spec.delay > 0 || !spec.noise.empty()))
    throw SetupError(
        fmt::format("{}: delay and noise are of sensors, and '{}' gives no readings", spec.where, spec.name));
  const control_software::PythonReadingOptions sensor{
      .name = spec.name, .rate = rate, .delay = spec.delay, .noise = spec.noise, .seed = parts.spec.seed};
  const Rate execution = senses ? control_software::execution_rate(sensor, parts.spec.rate) : Rate(rate);
  with_context(spec.where, [&] {
    parts.algorithms.push_back(&parts.simulation->attach<PythonAlgorithm>(
        spec.name, entity_of(parts, spec), execution, std::move(made), parts.simulation->world().common(),
        parts.moving_entities,
        control_software::PythonAlgorithmOptions{.sensor = sensor,
                                                 .budget = from_seconds(spec.call_budget),
                                                 .notes = parts.crashes}));
  });
}

}  // namespace

void refuse_software_of_file(const SceneParts& parts, const std::string& where, const std::string& software) {
  if (parts.libraries || (where.starts_with("--set") && !parts.files.only_from)) return;
  throw SetupError(fmt::format(
      "{}: this file has control software loaded, '{}', which may do what it likes; if you trust it: --libraries",
      where, software));
}

LoadedClasses load_classes(SceneParts& parts) {
  LoadedClasses classes;
  if (parts.only_shown) return classes;
  for (const scene_file::AlgorithmSpec& spec : parts.spec.algorithms) {
    refuse_software_of_file(parts, spec.where, spec.target);
    PythonClass made = load(parts, spec);
    const bool senses = made.phase() == Phase::sense;
    classes.push_back({&spec, std::move(made), senses});
  }
  return classes;
}

void attach_classes(SceneParts& parts, LoadedClasses& classes, bool that_sense) {
  for (LoadedClass& one : classes) {
    if (one.senses == that_sense) attach(parts, *one.spec, std::move(one.made));
  }
}

std::string end_of_run(const SceneParts& parts) {
  for (const PythonAlgorithm* algorithm : parts.algorithms) {
    if (!algorithm->end_of_run().empty()) return fmt::format("{}: {}", algorithm->name(), algorithm->end_of_run());
  }
  return {};
}

}  // namespace murosimf::scene

#include "murosimf/scene/section_changes.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/constant_changes.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/start_overlaps.h"
#include "murosimf/scene_file/section_change.h"

namespace murosimf::scene {
namespace {

using scene_file::BallOptions;

bool equal(const scene_file::LightSpec& a, const scene_file::LightSpec& b) {
  const bool same_lamp =
      a.toward.has_value() == b.toward.has_value() && (!a.toward || norm(*a.toward - *b.toward) == 0);
  return same_lamp && a.name == b.name && a.brightness == b.brightness && a.shadows == b.shadows &&
         a.samples == b.samples;
}

ModelPtr model_of(const SceneParts& parts, const BallOptions& ball) {
  ModelPtr model = scene_file::ball_model(ball);
  check_materials(*model, parts.spec.materials);
  return model;
}

/// Constants set by the user would hide the effect of an event.
void check_constants(const scene_file::SceneSpec& spec) {
  for (const scene_file::PropertySetting& setting : spec.settings) {
    const bool of_ball = std::ranges::find(setting.entities, "ball") != setting.entities.end();
    if (!of_ball || !is_constant(setting)) continue;
    throw SetupError(
        fmt::format("{} has set a constant of the ball's model; such a ball stays as it is", setting.where));
  }
}

void exchange_ball(SceneParts& parts, const BallOptions& next, LevelStart start) {
  MUROSIMF_ASSERT(parts.ball != nullptr && parts.spec.ball.has_value());
  Entity& ball = *parts.ball;
  BallOptions& present = *parts.spec.ball;
  const auto level = [&](Setup& setup) { return catalog::make_level(ball.level, setup, {}); };
  parts.simulation->exchange_model(ball, model_of(parts, next), level, start);
  if (start == LevelStart::in_motion && ball.present()) {
    // keeps the lowest point where it is
    const Vec3d up{0, 0, next.radius - present.radius};
    ball.base().set(properties::position, ball.base().get(properties::position) + up);
  }
  present = next;
}

void recolor_ball(SceneParts& parts, const Color& color) {
  parts.spec.ball->color = color;
  parts.ball->recolor(color);
}

void change_light(SceneParts& parts, const scene_file::SceneEvent& event) {
  parts.spec.light = changed(parts.spec.light, event);
  if (parts.cameras) parts.cameras->renew_light();
  ++parts.changes_to_see;
}

/// A new size or mass is another model; a new color only concerns pictures.
void change_ball(SceneParts& parts, const scene_file::SceneEvent& event) {
  MUROSIMF_ASSERT(parts.ball != nullptr && parts.spec.ball.has_value());
  const scene_file::BallSpec next = changed(*parts.spec.ball, event);
  if (static_cast<const BallOptions&>(next) != *parts.spec.ball) {
    exchange_ball(parts, next, LevelStart::in_motion);
    parts.diagnostics.warn(overlaps_of(*parts.ball, *parts.field, parts.moving_entities));
  }
  recolor_ball(parts, next.color);
  show_changes(parts);
}

}  // namespace

void check_section_change(const SceneParts& parts, const scene_file::SceneEvent& event) {
  if (event.section == "materials" || event.section == "field") return check_surfaces(parts, event);
  if (event.section != "ball") return;
  with_context(event.where, [&] {
    if (event.key != "color") check_constants(parts.spec);
    (void)model_of(parts, changed(*parts.spec.ball, event));
  });
}

void apply_section_change(SceneParts& parts, const scene_file::SceneEvent& event) {
  with_context(event.where, [&] {
    if (event.section == "light") {
      change_light(parts, event);
    } else if (event.section == "ball") {
      change_ball(parts, event);
    } else {
      change_surfaces(parts, event);
    }
    parts.simulation->record(fmt::format("{}: {} {}", event.section, event.key, event.value));
  });
}

ChangingSections sections_in_force(const SceneParts& parts) {
  const scene_file::BallSpec ball = parts.spec.ball.value_or(scene_file::BallSpec{});
  return {parts.spec.light, ball, ball.color};
}

/// Only what differs: an exchange of the ball's model begins its algorithms anew.
void put_in_force(SceneParts& parts, const ChangingSections& sections) {
  const ChangingSections present = sections_in_force(parts);
  const bool other_ball = sections.ball != present.ball, other_color = sections.ball_color != present.ball_color;
  if (!other_ball && !other_color && equal(sections.light, present.light)) return;
  parts.spec.light = sections.light;
  if (other_ball) exchange_ball(parts, sections.ball, LevelStart::anew);
  if (other_color) recolor_ball(parts, sections.ball_color);
  show_changes(parts);
}

void show_changes(SceneParts& parts) {
  if (parts.cameras) parts.cameras->renew();
  ++parts.changes_to_see;
}

}  // namespace murosimf::scene

#include "murosimf/identification/contact_logs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/csv_file.h"
#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/material.h"

namespace murosimf::identification {
namespace {

using identification::Estimate;
using identification::Track;
using nlohmann::json;

/// The column called "x", or "something.x"; null if there is none.
const files::CsvColumn* column_of(const files::CsvTable& table, const std::string& axis, const std::string& file) {
  const files::CsvColumn* found = nullptr;
  for (const files::CsvColumn& column : table.columns) {
    if (column.name != axis && !column.name.ends_with("." + axis)) continue;
    if (found) throw SetupError(fmt::format("{}: '{}' and '{}' are both '{}'", file, found->name, column.name, axis));
    if (!column.unit.empty() && column.unit != "m") {
      throw SetupError(fmt::format("{}: '{}' is in {}; m is needed", file, column.name, column.unit));
    }
    found = &column;
  }
  return found;
}

void check_times(const files::CsvColumn& column, const std::string& file) {
  for (std::size_t i = 0; i < column.times.size(); ++i) {
    if (!std::isfinite(column.values[i])) {
      throw SetupError(fmt::format("{}: '{}' at {} s is no finite number", file, column.name, column.times[i]));
    }
    if (i > 0 && !(column.times[i] > column.times[i - 1])) {
      throw SetupError(
          fmt::format("{}: time {} s is not after {} s before it", file, column.times[i], column.times[i - 1]));
    }
  }
}

void put_in(Track& track, const files::CsvColumn* column, double Vec3d::*axis) {
  if (!column) return;
  check_times(*column, track.name);
  if (track.times.empty()) {
    track.times = column->times;
    track.places.resize(track.times.size());
  }
  if (column->times != track.times) {
    throw SetupError(
        fmt::format("{}: '{}' has cells at other times than the columns before", track.name, column->name));
  }
  MUROSIMF_ASSERT(column->values.size() == track.places.size());
  for (std::size_t i = 0; i < column->values.size(); ++i) track.places[i].*axis = column->values[i];
}

/// Reads a track. `needed`: "x" for runs along the ground, "z" for drops.
Track read_track(const std::string& file, const std::string& needed) {
  const files::CsvTable table = files::read_csv(file);
  const files::CsvColumn* column = column_of(table, needed, file);
  if (!column)
    throw SetupError(fmt::format("{}: it has no column '{}', nor one that ends with '.{}'", file, needed, needed));
  Track track;
  track.name = file;
  put_in(track, column, needed == "x" ? &Vec3d::x : &Vec3d::z);
  if (needed == "x") put_in(track, column_of(table, "y", file), &Vec3d::y);
  return track;
}

/// Fits runs that slow down. `factor` turns a deceleration into the number.
void add_braking(ContactFit& fit, const std::string& key, const std::vector<std::string>& runs, double factor,
                 double drag) {
  if (runs.empty()) return;
  std::vector<identification::Braking> found;
  for (const std::string& file : runs) {
    identification::Braking braking = identification::fit_braking(read_track(file, "x"), drag);
    braking.value *= factor;
    braking.error *= factor;
    found.push_back(braking);
  }
  FittedNumber number{.key = key, .estimate = {}, .runs = runs, .of_runs = {found.begin(), found.end()}, .lean = {}};
  number.estimate = identification::mean_of(number.of_runs);
  number.lean = identification::fit_lean(found);
  if (number.lean) {  // the scatter of the runs is then an effect of their direction
    number.estimate.value = number.lean->mean;
    number.estimate.error = identification::known_error(number.of_runs);
  }
  fit.numbers.push_back(std::move(number));
}

void add_bouncing(ContactFit& fit, const std::vector<std::string>& runs, const ContactFitOptions& options) {
  if (runs.empty()) return;
  FittedNumber number{.key = "restitution", .estimate = {}, .runs = runs, .of_runs = {}, .lean = {}};
  for (const std::string& file : runs) {
    number.of_runs.push_back(identification::fit_bounces(read_track(file, "z"), options.gravity, options.drag));
  }
  number.estimate = identification::mean_of(number.of_runs);
  fit.numbers.push_back(std::move(number));
}

const FittedNumber* find_number(const ContactFit& fit, const std::string& key) {
  const auto found = std::ranges::find(fit.numbers, key, &FittedNumber::key);
  return found == fit.numbers.end() ? nullptr : &*found;
}

/// The numbers of a pair by their keys, in the order of [[materials]].
std::vector<std::pair<std::string, double>> numbers_of(const PairSurface& pair) {
  return {{"friction", pair.friction},
          {"rolling", pair.rolling},
          {"torsional", pair.torsional},
          {"restitution", pair.restitution},
          {"stiffness", pair.stiffness},
          {"static_deflection", pair.static_deflection},
          {"friction_anisotropy", pair.friction_anisotropy},
          {"rolling_anisotropy", pair.rolling_anisotropy},
          {"rebound", pair.rebound},
          {"viscous_friction", pair.viscous_friction},
          {"spin_friction", pair.spin_friction}};
}

std::string fitted_line(const FittedNumber& number) {
  return fmt::format("{} = {:.4g}  # +- {:.2g}, {} {}, residual {:.2g} mm\n", number.key, number.estimate.value,
                     number.estimate.error, number.runs.size(), number.runs.size() == 1 ? "run" : "runs",
                     1e3 * number.estimate.residual);
}

std::string line_of(const ContactFit& fit, const std::string& key, double usual) {
  if (const FittedNumber* number = find_number(fit, key)) return fitted_line(*number);
  for (const std::string number : {"friction", "rolling"}) {
    const FittedNumber* fitted = find_number(fit, number);
    if (key != number + "_anisotropy" || !fitted || !fitted->lean) continue;
    return fmt::format("{} = {:.3g}  # fitted\n", key, fitted->lean->anisotropy);
  }
  return fmt::format("{} = {:g}\n", key, usual);
}

std::string lean_line(const FittedNumber& number) {
  const identification::Lean& lean = *number.lean;
  return fmt::format("{} is {:.4g} (1 - {:.2g} cos a), a from [{:.3g}, {:.3g}], where the pile leans", number.key,
                     lean.mean, lean.anisotropy, lean.direction.x, lean.direction.y);
}

json json_of(const Estimate& estimate) {
  return {{"value", estimate.value}, {"error", estimate.error}, {"residual_m", estimate.residual}};
}

}  // namespace

ContactFit fit_contact_logs(const ContactLogs& logs, const ContactFitOptions& options) {
  ContactFit fit{.body = options.body, .ground = options.ground, .numbers = {}};
  const double rolling_mass = 1 + options.inertia;  // [1] what resists, over the mass
  add_braking(fit, "friction", logs.slides, 1 / options.gravity, 0);
  add_braking(fit, "rolling", logs.rolls, rolling_mass / options.gravity, options.drag / rolling_mass);
  add_bouncing(fit, logs.drops, options);
  return fit;
}

std::string to_toml(const ContactFit& fit) {
  const PairSurface usual = MaterialTable::standard().find({.material = fit.body}, {.material = fit.ground});
  std::string text =
      "# Fitted by murosimf fit-contact (docs/materials.md). Numbers without an error were not fitted.\n";
  text += fmt::format("[[materials]]\npair = [\"{}\", \"{}\"]\n", fit.body, fit.ground);
  for (const auto& [key, value] : numbers_of(usual)) text += line_of(fit, key, value);
  for (const FittedNumber& number : fit.numbers) {
    if (!number.lean) continue;
    text += fmt::format("# {}: [field] friction_direction = [{:.3g}, {:.3g}]\n", lean_line(number),
                        number.lean->direction.x, number.lean->direction.y);
  }
  return text;
}

std::string to_text(const ContactFit& fit) {
  std::string text = fmt::format("{:<28} {:<12} {:>9} {:>9} {:>12}\n", "run", "number", "value", "error", "residual");
  const auto row = [&](const std::string& name, const std::string& key, const Estimate& of) {
    text +=
        fmt::format("{:<28} {:<12} {:>9.4g} {:>9.2g} {:>9.2g} mm\n", name, key, of.value, of.error, 1e3 * of.residual);
  };
  for (const FittedNumber& number : fit.numbers) {
    MUROSIMF_ASSERT(number.runs.size() == number.of_runs.size());
    for (std::size_t i = 0; i < number.runs.size(); ++i) row(number.runs[i], number.key, number.of_runs[i]);
    row(fmt::format("{} and {}", fit.body, fit.ground), number.key, number.estimate);
  }
  for (const FittedNumber& number : fit.numbers) {
    if (number.lean) text += lean_line(number) + "\n";
  }
  return text;
}

std::string to_json(const ContactFit& fit) {
  json numbers = json::array();
  for (const FittedNumber& number : fit.numbers) {
    json runs = json::array();
    for (std::size_t i = 0; i < number.runs.size(); ++i) {
      json run = json_of(number.of_runs[i]);
      run["file"] = number.runs[i];
      runs.push_back(std::move(run));
    }
    json one = json_of(number.estimate);
    one["key"] = number.key;
    one["runs"] = std::move(runs);
    if (number.lean) {
      one["lean"] = {{"mean", number.lean->mean},
                     {"anisotropy", number.lean->anisotropy},
                     {"direction", {number.lean->direction.x, number.lean->direction.y}}};
    }
    numbers.push_back(std::move(one));
  }
  return files::json_text({{"schema", files::json_schema("fit-contact")},
                           {"pair", {fit.body, fit.ground}},
                           {"numbers", std::move(numbers)}});
}

}  // namespace murosimf::identification

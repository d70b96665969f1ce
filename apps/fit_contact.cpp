// `murosimf fit-contact`: friction, rolling resistance and restitution of a pair of materials, from recorded slides, rolls and drops.
#include <string>
#include <vector>

#include "apps/command_line.h"
#include "apps/results.h"
#include "apps/standard_output.h"
#include "murosimf/air/air.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/identification/contact_logs.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

namespace contact_log = identification;

struct FitContactOptions {
  std::vector<std::string> rolls, slides, drops;  ///< files (CSV)
  std::vector<std::string> pair;                  ///< two names of materials
  std::string out;                                ///< part of a scene file
  double gravity = 9.81;                          ///< [m/s^2]
  bool hollow = false;                            ///< the ball
  double radius = 0, mass = 0;                    ///< [m], [kg] of what air slows down; 0: nothing
  double drag = air::usual_drag;
  std::string json;
};

void define(const Command& command, FitContactOptions& options) {
  command.add("--roll", options.rolls, "Recordings (CSV) of a ball that rolls to rest: time, x, y");
  command.add("--slide", options.slides, "Recordings of a body that slides to rest: time, x, y");
  command.add("--drop", options.drops, "Recordings of a ball that falls and bounces: time, z");
  command.add("--pair", options.pair, "Two materials: of the body, of the ground").required();
  command.add("--out", options.out, "File to write (TOML): a section [[materials]] for scenes").required();
  command.add("--gravity", options.gravity, "m/s^2").within(0.01, 100.0).shows_default();
  command.add("--hollow", options.hollow, "The ball that rolls is a shell");
  const Option radius =
      command.add("--radius", options.radius, "m, of the ball: what air takes is not friction").within(1e-3, 10.0);
  const Option mass = command.add("--mass", options.mass, "kg, of the ball").within(1e-6, 1e4);
  command.add("--drag", options.drag, "C_d of the ball in air").within(0.0, 10.0).shows_default();
  radius.needs(mass);
  mass.needs(radius);
  add_json(command, options.json);
}

contact_log::ContactFitOptions fit_options(const FitContactOptions& options) {
  if (options.pair.size() != 2) throw SetupError("--pair takes two names of materials, as in --pair ball carpet");
  const double k = options.radius > 0
                       ? air::drag_per_meter(air::AirOptions{}.density,
                                             {.radius = options.radius, .mass = options.mass, .drag = options.drag})
                       : 0;
  return {.body = options.pair[0],
          .ground = options.pair[1],
          .gravity = options.gravity,
          .inertia = options.hollow ? 2.0 / 3 : 2.0 / 5,
          .drag = k};
}

int fit_contact(const FitContactOptions& options) {
  check_json_file(options.json);
  files::claim_output("--out", options.out);
  const contact_log::ContactFitOptions how = fit_options(options);
  if (options.rolls.empty() && options.slides.empty() && options.drops.empty()) {
    throw SetupError("nothing to fit: give recordings by --roll, --slide or --drop");
  }
  const contact_log::ContactFit fit =
      contact_log::fit_contact_logs({options.rolls, options.slides, options.drops}, how);
  Results results;
  results.write([&] { files::write_file(options.out, contact_log::to_toml(fit)); });
  results.write([&] { write_result(options.json, contact_log::to_text(fit), contact_log::to_json(fit)); });
  return results.exit_code(0);
}

}  // namespace

void add_fit_contact(CommandLine& line) {
  line.add<FitContactOptions>("fit-contact", "Find friction, rolling resistance and restitution from recordings",
                              define, fit_contact);
}

}  // namespace murosimf::app

#include "murosimf/catalog/algorithm_catalog.h"

#include <algorithm>

#include "murosimf/catalog/built_in_controllers.h"
#include "murosimf/catalog/physics_options.h"
#include "murosimf/collision/contact_laws/body_explicit_laws.h"
#include "murosimf/collision/contact_laws/body_island_law.h"
#include "murosimf/collision/contact_laws/deferred_impulse_law.h"
#include "murosimf/collision/contact_laws/implicit_stick_law.h"
#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"
#include "murosimf/collision/contact_laws/paper_law.h"
#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/dynamics/full_dynamics.h"
#include "murosimf/dynamics/kinematic_walking.h"
#include "murosimf/math/assert.h"

namespace murosimf::catalog {
namespace {

/// Applies the level's own options.
LevelOptions with_own(const OptionTable<LevelOptions>& table, LevelOptions options) {
  table.apply(options.own, options);
  return options;
}

std::unique_ptr<MotionLevel> make_kinematic_walking(Setup& setup, const LevelOptions& given) {
  return std::make_unique<dynamics::KinematicWalking>(setup, with_own(reference_options(), given).reference,
                                                      given.environment);
}

/// The level has its own set of options; those of the robot are added where they fit.
std::unique_ptr<MotionLevel> make_simplified_dynamics(Setup& setup, const LevelOptions& given) {
  const LevelOptions options = with_own(reference_options(), given);
  return std::make_unique<dynamics::SimplifiedDynamics>(
      setup, dynamics::SimplifiedDynamicsOptions{.integrator = options.tree.integrator,
                                                 .base_rigid = options.base_rigid,
                                                 .reference = options.reference});
}

std::unique_ptr<MotionLevel> make_full_dynamics(Setup& setup, const LevelOptions& given) {
  const LevelOptions options = with_own(reference_and_tree_options(), given);
  return std::make_unique<dynamics::FullDynamics>(setup, dynamics::FullDynamicsOptions{.reference = options.reference,
                                                                                       .tree = options.tree});
}

std::unique_ptr<MotionLevel> make_articulated_dynamics(Setup& setup, const LevelOptions& given) {
  const LevelOptions options = with_own(tree_options(), given);
  return std::make_unique<dynamics::ArticulatedDynamics>(setup, options.tree, options.servo_law);
}

template <class Law>
std::shared_ptr<const collision::ContactLaw> make_law(const OptionValues&) {
  return std::make_shared<Law>();
}

std::shared_ptr<const collision::ContactLaw> make_paper(const OptionValues& given) {
  collision::PaperLawOptions options;
  paper_law_options().apply(given, options);
  return std::make_shared<collision::PaperLaw>(options);
}

std::shared_ptr<const collision::ContactLaw> make_paper_multipoint(const OptionValues& given) {
  collision::PaperLawOptions options{.one_point_per_body = false};
  paper_law_options().apply(given, options);
  return std::make_shared<collision::PaperLaw>(options);
}

// [s] without and with servos: docs/scenes.md, "Long steps", measured by benchmarks/step_sizes.py
constexpr LongestSteps bounded_steps{0.01, 0.01}, literal_steps{0.002, 0.001};

LongestSteps paper_steps(const OptionValues& given) {
  collision::PaperLawOptions options;
  paper_law_options().apply(values_among(paper_law_options().infos(), given), options);
  return options.bounded ? bounded_steps : literal_steps;
}

// Keys: names in a scene file; "position.z" is the height in `position`.
std::vector<LevelType> built_in_levels() {
  return {
      LevelType{"kinematic_walking", "the standing foot is fixed on the plane; cannot fall, ignores forces (paper 4.1)",
                dynamics::KinematicWalking::has, "joint_reference",
                "stance_pose stance_foot remaining_shift remaining_turn", make_kinematic_walking,
                reference_options().infos()},
      LevelType{"simplified_dynamics", "the robot as one rigid body under gravity and contact (paper 4.2)",
                dynamics::SimplifiedDynamics::has,
                "joint_reference base_rigid integrator contact position.z roll_deg pitch_deg",
                "applied_force linear_velocity angular_velocity base_quaternion", make_simplified_dynamics,
                reference_options().infos()},
      LevelType{"full_dynamics", "every link has its mass; joints move exactly as told (paper 4.3)",
                dynamics::FullDynamics::has,
                "joint_reference fixed_base integrator contact position.z roll_deg pitch_deg",
                "applied_force linear_velocity angular_velocity base_quaternion", make_full_dynamics,
                reference_and_tree_options().infos()},
      LevelType{"articulated_dynamics", "servos make torque, the whole tree moves as it must",
                dynamics::ArticulatedDynamics::has,
                "fixed_base integrator servo_law contact position.z roll_deg pitch_deg self_collision",
                "applied_force linear_velocity angular_velocity base_quaternion "
                "supply_voltage torque_enabled servo_temperature backlash_play backlash_side "
                "rotor_rate",
                make_articulated_dynamics, tree_options().infos()},
  };
}

/// The first one is the default of scenes; the numbers are the longest steps at which the law is stable.
std::vector<ContactLawType> built_in_contacts() {
  return {
      ContactLawType{"implicit_stick",
                     "compliant, implicit, with a tangential spring that sticks; the default",
                     make_law<collision::ImplicitStick>,
                     {0.01, 0.01},
                     {},
                     {},
                     {0.002, 0.002}},
      ContactLawType{"island_gauss_seidel",
                     "the same force, settled together with all contacts of what is touched",
                     make_law<collision::IslandGaussSeidel>,
                     {0.01, 0.01},
                     {},
                     {},
                     {0.002, 0.002}},
      ContactLawType{"kelvin_voigt",
                     "spring, damper and a tangential spring that sticks; explicit, for steps of 1 ms",
                     make_law<collision::KelvinVoigt>,
                     {0.002, 0.001}},
      ContactLawType{"paper",
                     "one point per body, spring and viscous friction (paper 5.3, eq. 4 and 5)",
                     make_paper,
                     bounded_steps,
                     paper_law_options().infos(),
                     paper_steps,
                     {0.001, 0.002}},
      ContactLawType{"paper_multipoint",
                     "the same spring and viscous friction at every point",
                     make_paper_multipoint,
                     bounded_steps,
                     paper_law_options().infos(),
                     paper_steps,
                     {0.001, 0.002}},
  };
}

template <class Law>
std::unique_ptr<collision::BodyContactLaw> make_body_law(const OptionValues&) {
  return std::make_unique<Law>();
}

std::unique_ptr<collision::BodyContactLaw> make_body_island(const OptionValues& given) {
  collision::BodyIslandOptions options;
  body_island_options().apply(given, options);
  return std::make_unique<collision::BodyIslandLaw>(options);
}

std::unique_ptr<collision::BodyContactLaw> make_body_paper(const OptionValues& given) {
  collision::PaperLawOptions options;
  paper_law_options().apply(given, options);
  return std::make_unique<collision::BodyPaperLaw>(options);
}

std::unique_ptr<collision::BodyContactLaw> make_body_paper_multipoint(const OptionValues& given) {
  collision::PaperLawOptions options{.one_point_per_body = false};
  paper_law_options().apply(given, options);
  return std::make_unique<collision::BodyPaperLaw>(options);
}

/// The first one is the default of scenes.
std::vector<BodyContactLawType> built_in_body_contacts() {
  return {
      BodyContactLawType{"island_gauss_seidel", "all contacts of touching entities settled together; the default",
                         make_body_island, body_island_options().infos(), 0.002},
      BodyContactLawType{"carry",
                         "either body implicit by itself, the difference given back later; up to 2 ms",
                         make_body_law<collision::DeferredImpulseLaw>,
                         {},
                         0.002},
      BodyContactLawType{"kelvin_voigt", "explicit spring, damper and viscous friction; 1 ms",
                         make_body_law<collision::BodyKelvinVoigtLaw>},
      BodyContactLawType{"paper", "spring and viscous friction at one point of two bodies (paper 5.3); 1 ms",
                         make_body_paper, paper_law_options().infos()},
      BodyContactLawType{"paper_multipoint", "the same spring and viscous friction at every point; 1 ms",
                         make_body_paper_multipoint, paper_law_options().infos()},
  };
}

}  // namespace

/// Compares whole words: one word may be part of another.
bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    if (words.substr(begin, end - begin) == word) return true;
    begin = end + 1;
  }
  return false;
}

Registries& registries() {
  // functions, not static objects: plug-ins and tests use them before and during static initialization of other files
  static Registry<LevelType> levels("level", built_in_levels());
  static Registry<ContactLawType> contacts("contact law", built_in_contacts());
  static Registry<BodyContactLawType> body_contacts("law of contact between bodies", built_in_body_contacts());
  static Registry<ControllerType> controllers("controller", built_in_controllers());
  static Registry<CommandType> commands("command");
  static Registries all{
      levels,  contacts, body_contacts, controllers, component_files::sensor_registry(), robot::robot_format_registry(),
      commands};
  return all;
}

const Registry<LevelType>& levels() { return registries().levels; }
const Registry<ContactLawType>& contacts() { return registries().contacts; }
const Registry<BodyContactLawType>& body_contacts() { return registries().body_contacts; }
const Registry<ControllerType>& controllers() { return registries().controllers; }

LongestSteps stable_steps(const ContactLawType& law, const OptionValues& given) {
  MUROSIMF_ASSERT(law.longest_steps.without_servos > 0 && law.longest_steps.with_servos > 0);
  return law.longest_steps_with ? law.longest_steps_with(given) : law.longest_steps;
}

LongestSteps accurate_steps(const ContactLawType& law, const OptionValues& given) {
  const LongestSteps stable = stable_steps(law, given), accurate = law.accurate_steps;
  return {std::min(stable.without_servos, accurate.without_servos), std::min(stable.with_servos, accurate.with_servos)};
}

/// A level gets those of the robot's options that it knows: a robot keeps options of other levels for a change of its level.
std::unique_ptr<MotionLevel> make_level(std::string_view name, Setup& setup, const LevelOptions& options) {
  const LevelType& type = levels().find(name);
  MUROSIMF_ASSERT(type.make != nullptr);
  LevelOptions known = options;
  known.own = values_among(type.options, options.own);
  return type.make(setup, known);
}

std::shared_ptr<const collision::ContactLaw> make_contact_law(std::string_view name, const OptionValues& given) {
  const ContactLawType& type = contacts().find(name);
  MUROSIMF_ASSERT(type.make != nullptr);
  return type.make(values_among(type.options, given));
}

std::unique_ptr<collision::BodyContactLaw> make_body_contact_law(std::string_view name, const OptionValues& given) {
  const BodyContactLawType& type = body_contacts().find(name);
  MUROSIMF_ASSERT(type.make != nullptr);
  return type.make(values_among(type.options, given));
}

}  // namespace murosimf::catalog

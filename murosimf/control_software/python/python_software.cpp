#include "murosimf/control_software/python/python_software.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <mutex>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/control_software/library_software.h"
#include "murosimf/control_software/python/python_interpreter.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/file_access.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

/// Property that orders the objects of classes: two writers of one property never run in parallel.
struct PythonTurn {};
[[maybe_unused]] void append_hash(Hasher&, const PythonTurn&) {}
[[maybe_unused]] void state(StateArchive&, PythonTurn&) {}
constexpr Property<PythonTurn> python_turn{
    {"python_turn", "-", "-", "objects of classes in Python are called one after the other", Scope::wiring}};

/// A call that is not ended at its limit is in code that Python cannot end: then it is left by a jump, and the run ends.
constexpr int patience = 4;

std::vector<std::string> joint_names(const Model& model) {
  std::vector<std::string> names;
  for (const int joint : model.joints()) names.push_back(model.objects()[static_cast<std::size_t>(joint)].name);
  return names;
}

std::vector<std::string> object_names(const Model& model) {
  std::vector<std::string> names;
  for (const auto& object : model.objects()) names.push_back(object.name);
  return names;
}

[[noreturn]] void refuse_target(const std::string& target) {
  throw SetupError(fmt::format("controller 'python' needs a class: options = {{class = \"module:Class\"}}{}",
                               target.empty() ? "" : fmt::format("; '{}' is none", target)));
}

bool is_name_of_module(std::string_view name) {
  const auto fits = [](char c) { return (std::isalnum(static_cast<unsigned char>(c)) != 0) || c == '_' || c == '.'; };
  return !name.starts_with('.') && std::ranges::all_of(name, fits);
}

/// A module by its file, or one that stands beside the scene; Python looks for others, unless files are limited (file_access.h).
void find_file(PythonRequest& request, const std::filesystem::path& folder) {
  if (request.module.ends_with(".py")) {
    const std::filesystem::path file = files::find_data_file(request.module, "controllers", ".py", folder);
    request.file = file.string();
    request.module = file.stem().string();
  } else if (!is_name_of_module(request.module)) {
    refuse_target(fmt::format("{}:{}", request.module, request.name));
  } else if (const std::filesystem::path beside = folder / (request.module + ".py");
             std::filesystem::is_regular_file(beside) && files::may_be_read(beside)) {
    request.file = beside.string();
  } else if (files::reads_are_limited()) {
    throw SetupError(fmt::format("no module '{}' beside the scene", request.module));
  }
  if (!request.file.empty()) files::note_file_read(request.file);
}

void take_robot(const Entity& robot, PythonRequest& request) {
  request.robot = robot.name();
  request.team = robot.options().team;
  request.model = robot.model().name();
  request.joints = joint_names(robot.model());
  request.objects = object_names(robot.model());
}

PythonRequest request_of(const Entity& robot, const PythonOptions& options) {
  const std::size_t colon = options.target.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == options.target.size()) refuse_target(options.target);
  PythonRequest request{.module = options.target.substr(0, colon),
                        .name = options.target.substr(colon + 1),
                        .folder = options.folder.empty() ? "." : options.folder.string(),
                        .options = options.options,
                        .seed = options.seed,
                        .of_scene_file = !options.algorithm.empty()};
  if (options.of_whole_scene) {
    request.robot = options.algorithm;
  } else {
    take_robot(robot, request);
  }
  find_file(request, options.folder);
  return request;
}

GuardedCall guard_of(const PythonOptions& options, const Entity& robot, std::shared_ptr<ForeignThreads> threads) {
  return {fmt::format("class '{}' of {}", options.target,
                      options.algorithm.empty() ? robot.name() : fmt::format("'{}'", options.algorithm)),
          "its step",
          patience * longest_call(options.budget),
          nullptr,
          std::move(threads),
          false};
}

/// Held during a guarded call. The guard has a lock of its own, which a call may take in its middle and then wait for the interpreter's: calls
/// of several simulations would wait for each other for ever. In a Python program, whose threads come with the interpreter's lock, the
/// guard watches no functions, and so takes none.
std::unique_lock<std::mutex> one_call() {
  static std::mutex calls;
  return in_python_program() ? std::unique_lock<std::mutex>() : std::unique_lock(calls);
}

/// After a jump out of Python nothing of it can be called again.
CallOutcome left_by_jump(CallOutcome outcome) {
  python_backend().abandon();
  outcome.kind = CallOutcome::crashed;
  return outcome;
}

}  // namespace

PythonClass::PythonClass(const Entity& robot, const PythonOptions& options)
    : target_(options.target),
      limit_(longest_call(options.budget)),
      threads_(std::make_shared<ForeignThreads>()),
      guard_(guard_of(options, robot, threads_)) {
  threads_->name = guard_.name;
  PythonRequest request = request_of(robot, options);
  PythonBackend& backend = python_backend();
  GuardedCall guard = guard_;
  guard.what = "its loading";
  guard.keeps_process = !in_python_program();  // which would take that lock
  PythonOutcome made;
  constexpr Duration longest_loading = std::chrono::seconds(60);
  guard.limit = patience * longest_loading;
  const auto alone = one_call();
  const CallOutcome outcome = guard([&] { object_.reset(backend.load(request, longest_loading, made)); });
  if (!outcome) throw SoftwareCrash(left_by_jump(outcome).text);
  if (!object_) throw SetupError(made.text);
}

Phase PythonClass::phase() const {
  constexpr std::array<std::pair<std::string_view, Phase>, 5> phases{{{"sense", Phase::sense},
                                                                      {"control", Phase::control},
                                                                      {"contact", Phase::contact},
                                                                      {"interaction", Phase::interaction},
                                                                      {"observe", Phase::observe}}};
  const auto* const found = std::ranges::find(phases, traits().phase, [](const auto& one) { return one.first; });
  MUROSIMF_ASSERT(found != phases.end());
  return found->second;
}

std::string PythonClass::name() const {
  return fmt::format("{} of {}", target_.substr(target_.rfind(':') + 1), traits().file);
}

void python_in_turns(const Setup& setup, Entity& common) { (void)setup.of(common).write(python_turn); }

std::vector<sensors::Output> PythonClass::outputs() const {
  std::vector<sensors::Output> outputs;
  for (const PythonOutput& output : traits().gives)
    outputs.push_back({.name = output.name, .unit = output.unit, .labels = output.labels});
  return outputs;
}

PythonSoftware::PythonSoftware(Setup& setup, RobotPort* port, SayLine say, PythonClass made,
                               const std::vector<Entity*>& others, sensors::Reading* reading)
    : made_(std::move(made)), say_(std::move(say)), rows_(setup, port, others, *made_.object_, reading) {}

/// call(): a PythonOutcome.
template <class Call>
CallOutcome PythonSoftware::guarded(const char* what, const Call& call) {
  PythonOutcome python;
  made_.guard_.what = what;
  const auto alone = one_call();
  CallOutcome outcome = made_.guard_([&] { python = call(*made_.object_); });
  if (!outcome) return left_by_jump(std::move(outcome));
  if (made_.threads_->ended) return outcome_of(*made_.threads_);
  if (python.kind == PythonOutcome::ends) {
    end_of_run_ = python.text;
    return outcome;
  }
  interrupted_ = python.kind == PythonOutcome::interrupted;
  if (python || interrupted_) return outcome;
  for (const std::string& line : python.traceback) say_(line);
  if (python.kind == PythonOutcome::late) {
    outcome = {CallOutcome::late, fmt::format("{}: {} did not come back within {:g} s ({})", made_.guard_.name, what,
                                              seconds(made_.limit_), python.text)};
  } else {
    outcome = {CallOutcome::threw, fmt::format("{}: {} raised {}", made_.guard_.name, what, python.text)};
  }
  return outcome;
}

/// A call that has ended well counts, unless it has written what is no number.
CallOutcome PythonSoftware::taken_over(const CallOutcome& outcome) {
  if (!outcome || interrupted_) return outcome;
  const std::string wrong = rows_.take();
  if (wrong.empty()) return outcome;
  return {CallOutcome::threw, fmt::format("{}: {}: {}", made_.guard_.name, made_.traits().where, wrong)};
}

CallOutcome PythonSoftware::start() {
  rows_.restart();
  end_of_run_.clear();
  made_.object_->print_to(say_);
  const PythonTraits& traits = made_.traits();
  if (!traits.starts && !fresh_) {
    const CallOutcome renewed =
        guarded("its __init__", [&](PythonObject& object) { return object.renew(made_.limit_); });
    if (!renewed) return renewed;
  }
  fresh_ = false;
  begun_ = true;
  if (!traits.starts) return {};
  rows_.show();
  return taken_over(guarded("its start", [&](PythonObject& object) { return object.start(0, made_.limit_); }));
}

CallOutcome PythonSoftware::step(Duration now) noexcept {
  rows_.show();
  return taken_over(guarded("its step", [&](PythonObject& object) { return object.step(seconds(now), made_.limit_); }));
}

void PythonSoftware::state(StateArchive& archive) {
  if (!made_.traits().saves) return;
  archive(begun_);
  if (!begun_) return;  // its state is what `start` makes
  std::string bytes;
  CallOutcome outcome;
  if (!archive.loads()) {
    outcome = guarded("its save", [&](PythonObject& object) { return object.save(bytes, made_.limit_); });
    archive(bytes);
  } else {
    archive(bytes);
    outcome = guarded("its load", [&](PythonObject& object) { return object.load(bytes, made_.limit_); });
  }
  if (!outcome) throw SetupError(outcome.text);
}

}  // namespace murosimf::control_software

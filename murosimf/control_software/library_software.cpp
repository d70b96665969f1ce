#include "murosimf/control_software/library_software.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/files/private_copy.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

/// Property that orders the instances of one library: two writers of one property never run in parallel.
struct LibraryTurn {};
[[maybe_unused]] void append_hash(Hasher&, const LibraryTurn&) {}
[[maybe_unused]] void state(StateArchive&, LibraryTurn&) {}

constexpr auto reload_period = std::chrono::milliseconds(250);
constexpr auto longest_writing = std::chrono::seconds(10);  // after which a file that does not change is taken as it is

/// Instances that were left in the middle of a call are never destroyed and their libraries never unloaded: their locks may be held.
void keep_for_ever(const std::shared_ptr<const ControllerLibrary>& library, void* instance) {
  static std::mutex keeping;
  static auto* kept = new std::vector<std::pair<std::shared_ptr<const ControllerLibrary>, void*>>;
  const std::lock_guard lock(keeping);
  kept->emplace_back(library, instance);
}

/// Half written, or by another program right now.
bool is_unfinished(const std::filesystem::path& file) {
  try {
    return files::is_being_written(file) || !files::is_whole_library(files::read_library(file));
  } catch (const SetupError&) {  // it is gone: a new one will come
    return true;
  }
}

}  // namespace

Duration longest_call(Duration budget) {
  using namespace std::chrono_literals;
  return budget > Duration{} ? std::max<Duration>(1s, 10 * budget) : Duration(10s);
}

void one_after_the_other(const Setup& setup, Entity& common, const ControllerLibrary& library) {
  if ((library.functions().flags & MUROSIMF_INDEPENDENT_INSTANCES) != 0) return;
  const std::string name = "library_turn:" + std::filesystem::canonical(library.file()).string();
  const Property<LibraryTurn> turn{
      {name, "-", "-", "instances of a library are called one after the other", Scope::wiring}};
  (void)setup.of(common).write(turn);
}

LibrarySoftware::LibrarySoftware(Setup& setup, RobotPort& port, SayLine say,
                                 std::shared_ptr<const ControllerLibrary> library, LibraryOptions options)
    : library_(std::move(library)),
      options_(std::move(options)),
      rows_(&port.rows()),
      robot_(setup, port, std::move(say), options_.options, options_.seed),
      threads_(std::make_shared<ForeignThreads>()),
      step_{fmt::format("library '{}' of {}", options_.file.string(), setup.entity().name()),
            "its step",
            longest_call(options_.budget),
            rows_,
            threads_,
            false},
      looked_(WallClock::now()) {
  threads_->name = step_.name;
  instance_ = create(*library_);
  try {
    robot_.check_options(step_.name);
  } catch (...) {
    destroy(library_, instance_);
    throw;
  }
}

LibrarySoftware::~LibrarySoftware() { destroy(library_, instance_); }

/// Changes of the process that the call makes are reported with the next step.
CallOutcome LibrarySoftware::guarded(const char* what, const std::function<void()>& call) {
  CallOutcome outcome = GuardedCall{step_.name, what, step_.limit, rows_, threads_, true}(call);
  changes_.add(std::exchange(outcome.changes, {}));
  return outcome;
}

/// As guarded, for calls that must succeed. Throws SoftwareCrash if the call would have ended the program, else SetupError.
void LibrarySoftware::must(const CallOutcome& outcome) {
  if (outcome) return;
  if (outcome.kind != CallOutcome::crashed) throw SetupError(outcome.text);
  give_up(outcome);
  throw SoftwareCrash(outcome.text);
}

void* LibrarySoftware::create(const ControllerLibrary& library) {
  constexpr std::size_t longest_error = 1000;
  if (!error_) error_ = &rows_->add("error", "1000 bytes", 0, longest_error, GuardedRow::Use::write);
  char* const error = error_->body<char>();
  std::fill_n(error, longest_error, '\0');
  void* instance = nullptr;
  robot_.forget_names();
  must(guarded("its create",
               [&] { instance = library.functions().create(&robot_.description(), error, longest_error); }));
  if (instance) return instance;
  error[longest_error - 1] = 0;
  const std::string reason = *error != 0 ? std::string(error) : robot_.not_found();
  throw SetupError(
      fmt::format("{}: {}", step_.name, reason.empty() ? "it takes no such robot, and does not say why" : reason));
}

void LibrarySoftware::destroy(const std::shared_ptr<const ControllerLibrary>& library, void*& instance) {
  if (!instance) return;
  const CallOutcome outcome = guarded("its destroy", [&] { library->functions().destroy(instance); });
  if (!outcome) keep_for_ever(library, instance);
  instance = nullptr;
}

void LibrarySoftware::give_up(const CallOutcome& outcome) noexcept {
  if (outcome) return;
  if (outcome.kind == CallOutcome::crashed) crash_ = outcome.text;
  if (outcome.kind == CallOutcome::threw) return destroy(library_, instance_);
  crashed_ = crashed_ || outcome.kind == CallOutcome::crashed;
  keep_for_ever(library_, instance_);  // its state is undefined after an aborted call
  instance_ = nullptr;
}

/// A library that has crashed may have damaged its memory: it is not called again.
CallOutcome LibrarySoftware::start() {
  if (crashed_) return {CallOutcome::crashed, fmt::format("{} has crashed before; it cannot begin again", step_.name)};
  news_.clear();
  const bool has_start = library_->functions().start != nullptr;
  if (!instance_ || (!has_start && !fresh_)) {
    destroy(library_, instance_);
    instance_ = create(*library_);
  }
  fresh_ = false;
  if (!has_start) return {};
  return with_threads(guarded("its start", [&] { library_->functions().start(instance_); }));
}

/// Result of a call that succeeded itself, or waited for a thread that does not return, while one of its threads has crashed.
CallOutcome LibrarySoftware::with_threads(CallOutcome outcome) noexcept {
  outcome.changes.add(std::exchange(changes_, {}));
  for (const ForeignThreads* threads : {threads_.get(), library_->threads().get()}) {
    if ((!outcome && outcome.kind != CallOutcome::late) || !threads->ended) continue;
    const ProcessChanges changes = outcome.changes;
    outcome = outcome_of(*threads);
    outcome.changes = changes;
  }
  give_up(outcome);
  return outcome;
}

CallOutcome LibrarySoftware::step(Duration now) noexcept {
  if (options_.reload) look_for_a_newer_one();
  if (crashed_) return {CallOutcome::crashed, crash_};
  return with_threads(step_([this, now] { library_->functions().step(instance_, now.count()); }));
}

std::string LibrarySoftware::news() { return std::exchange(news_, {}); }

/// The size is requested first; a second call writes at most that many bytes.
std::vector<std::byte> LibrarySoftware::saved() {
  if (!instance_ || crashed_ || !library_->functions().save) return {};
  std::size_t size = 0;
  must(guarded("its save", [&] { size = library_->functions().save(instance_, nullptr, 0); }));
  GuardedRows memory;
  const GuardedRow& row =
      memory.add("bytes of its state", fmt::format("{} bytes", size), 0, size, GuardedRow::Use::write);
  auto* const bytes = row.body<std::byte>();
  must(guarded_with(memory, "its save",
                    [&] { size = std::min(size, library_->functions().save(instance_, bytes, size)); }));
  return {bytes, bytes + size};
}

bool LibrarySoftware::loaded(const ControllerLibrary& library, void* instance, const std::vector<std::byte>& bytes) {
  MUROSIMF_ASSERT(library.functions().load != nullptr);
  bool taken = false;
  GuardedRows memory;
  const GuardedRow& row = memory.add("bytes of its state", "", 0, bytes.size(), GuardedRow::Use::read);
  std::ranges::copy(bytes, row.body<std::byte>());
  const auto* const shown = row.shown_body<const std::byte>();
  must(guarded_with(memory, "its load", [&] { taken = library.functions().load(instance, shown, bytes.size()) != 0; }));
  return taken;
}

/// As guarded, with rows of this call alone.
CallOutcome LibrarySoftware::guarded_with(const GuardedRows& rows, const char* what,
                                          const std::function<void()>& call) {
  CallOutcome outcome = GuardedCall{step_.name, what, step_.limit, &rows, threads_, true}(call);
  changes_.add(std::exchange(outcome.changes, {}));
  return outcome;
}

void LibrarySoftware::state(StateArchive& archive) {
  std::vector<std::byte> bytes = archive.loads() ? std::vector<std::byte>{} : saved();
  archive(bytes);
  if (!archive.loads() || bytes.empty() || !instance_ || !library_->functions().load) return;
  if (!loaded(*library_, instance_, bytes)) throw SetupError(fmt::format("{}: its load refuses the state", step_.name));
}

/// A file that is still being written is ignored until its time is the same twice, it is complete, and no program has it open for
/// writing.
void LibrarySoftware::look_for_a_newer_one() {
  const WallClock::time_point now = WallClock::now();
  if (now - looked_ < reload_period) return;
  looked_ = now;
  const auto written = library_->newer();
  if (!written || *written == tried_) return;
  if (*written != seen_) {
    seen_ = *written;
    since_ = now;
    return;
  }
  if (now - since_ < longest_writing && is_unfinished(options_.file)) return;
  tried_ = *written;
  exchange();
}

void LibrarySoftware::exchange() {
  std::shared_ptr<const ControllerLibrary> next;
  void* instance = nullptr;
  try {
    next = ControllerLibrary::load(options_.file);
    const std::vector<std::byte> memory = saved();
    instance = create(*next);
    const bool goes_on = !memory.empty() && next->functions().load && loaded(*next, instance, memory);
    if (!goes_on && next->functions().start) begin(*next, instance);
    std::swap(library_, next);
    std::swap(instance_, instance);
    news_ = goes_on ? "the library was loaded anew and goes on" : "the library was loaded anew and begins anew";
  } catch (const SetupError& error) {
    news_ = fmt::format("the library was not loaded anew: {}", error.what());
  } catch (const SoftwareCrash&) {
    return keep_for_ever(next, instance);
  }
  if (next) destroy(next, instance);  // the old one, or the new one that is not taken
}

void LibrarySoftware::begin(const ControllerLibrary& library, void* instance) {
  must(guarded("its start", [&] { library.functions().start(instance); }));
}

}  // namespace murosimf::control_software

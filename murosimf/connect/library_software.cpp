#include "murosimf/connect/library_software.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {
namespace {

/// By which the instances of a library know each other.
struct LibraryTurn {};
[[maybe_unused]] void append_hash(Hasher&, const LibraryTurn&) {}
[[maybe_unused]] void state(StateArchive&, LibraryTurn&) {}

constexpr auto reload_period = std::chrono::milliseconds(250);

/// Instances whose code was left in the middle of a call are never destroyed, and their libraries never unloaded.
void keep_for_ever(const std::shared_ptr<const ControllerLibrary>& library, void* instance) {
  static std::mutex keeping;
  static auto* kept = new std::vector<std::pair<std::shared_ptr<const ControllerLibrary>, void*>>;
  const std::lock_guard lock(keeping);
  kept->emplace_back(library, instance);
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
      robot_(setup, port, std::move(say), options_.options, options_.seed),
      step_{fmt::format("library '{}' of {}", options_.file.string(), setup.entity().name()), "its step",
            longest_call(options_.budget)},
      looked_(WallClock::now()) {
  instance_ = create(*library_);
  try {
    robot_.check_options(step_.who);
  } catch (...) {
    destroy(library_, instance_);
    throw;
  }
}

LibrarySoftware::~LibrarySoftware() { destroy(library_, instance_); }

CallOutcome LibrarySoftware::guarded(const char* what, const std::function<void()>& call) const {
  return GuardedCall{step_.who, what, step_.limit}(call);
}

void* LibrarySoftware::create(const ControllerLibrary& library) {
  std::array<char, 1000> error{};
  void* instance = nullptr;
  robot_.forget_names();
  const CallOutcome outcome = guarded("its create", [&] {
    instance = library.functions().create(&robot_.description(), error.data(), error.size());
  });
  if (!outcome) {
    crashed_ = crashed_ || outcome.kind == CallOutcome::crashed;
    throw SetupError(outcome.text);
  }
  if (instance) return instance;
  error.back() = 0;
  const std::string reason = error.front() != 0 ? std::string(error.data()) : robot_.not_found();
  throw SetupError(
      fmt::format("{}: {}", step_.who, reason.empty() ? "it takes no such robot, and does not say why" : reason));
}

void LibrarySoftware::destroy(const std::shared_ptr<const ControllerLibrary>& library, void*& instance) const {
  if (!instance) return;
  const CallOutcome outcome = guarded("its destroy", [&] { library->functions().destroy(instance); });
  if (!outcome) keep_for_ever(library, instance);
  instance = nullptr;
}

void LibrarySoftware::give_up(const CallOutcome& outcome) noexcept {
  if (outcome) return;
  if (outcome.kind == CallOutcome::threw) return destroy(library_, instance_);
  crashed_ = crashed_ || outcome.kind == CallOutcome::crashed;
  keep_for_ever(library_, instance_);  // nobody knows what it would do now
  instance_ = nullptr;
}

CallOutcome LibrarySoftware::start() {
  if (crashed_) return {CallOutcome::crashed, fmt::format("{} has crashed before; it cannot begin again", step_.who)};
  news_.clear();
  const bool has_start = library_->functions().start != nullptr;
  if (!instance_ || (!has_start && !fresh_)) {
    destroy(library_, instance_);
    instance_ = create(*library_);
  }
  fresh_ = false;
  if (!has_start) return {};
  CallOutcome outcome = guarded("its start", [&] { library_->functions().start(instance_); });
  give_up(outcome);
  return outcome;
}

CallOutcome LibrarySoftware::step(Duration now) noexcept {
  if (options_.reload) look_for_a_newer_one();
  if (crashed_) return {CallOutcome::crashed, news_};
  CallOutcome outcome = step_([this, now] { library_->functions().step(instance_, now.count()); });
  give_up(outcome);
  return outcome;
}

std::string LibrarySoftware::news() { return std::exchange(news_, {}); }

std::vector<std::byte> LibrarySoftware::saved() const {
  std::vector<std::byte> bytes;
  if (!instance_ || !library_->functions().save) return bytes;
  const CallOutcome outcome = guarded("its save", [&] {
    bytes.resize(library_->functions().save(instance_, nullptr, 0));
    bytes.resize(std::min(bytes.size(), library_->functions().save(instance_, bytes.data(), bytes.size())));
  });
  if (!outcome) throw SetupError(outcome.text);
  return bytes;
}

bool LibrarySoftware::loaded(const ControllerLibrary& library, void* instance,
                             const std::vector<std::byte>& bytes) const {
  bool taken = false;
  const CallOutcome outcome =
      guarded("its load", [&] { taken = library.functions().load(instance, bytes.data(), bytes.size()) != 0; });
  if (!outcome) throw SetupError(outcome.text);
  return taken;
}

void LibrarySoftware::state(StateArchive& archive) {
  std::vector<std::byte> bytes = archive.loads() ? std::vector<std::byte>{} : saved();
  archive(bytes);
  if (!archive.loads() || bytes.empty() || !instance_ || !library_->functions().load) return;
  if (!loaded(*library_, instance_, bytes)) throw SetupError(fmt::format("{}: its load refuses the state", step_.who));
}

/// A file that is still being written is left alone until it has had the same time twice.
void LibrarySoftware::look_for_a_newer_one() {
  const WallClock::time_point now = WallClock::now();
  if (now - looked_ < reload_period) return;
  looked_ = now;
  const auto written = library_->newer();
  if (!written || *written == tried_) return;
  if (*written != seen_) {
    seen_ = *written;
    return;
  }
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
  }
  if (next) destroy(next, instance);  // the old one, or the new one that is not taken
}

void LibrarySoftware::begin(const ControllerLibrary& library, void* instance) const {
  const CallOutcome outcome = guarded("its start", [&] { library.functions().start(instance); });
  if (!outcome) throw SetupError(outcome.text);
}

}  // namespace murosimf::connect

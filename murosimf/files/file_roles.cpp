#include "murosimf/files/file_roles.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/files/output_place.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

constexpr const char* is_read = ": this file is read by the same command; name another one";

struct ClaimedOutput {
  fs::path place;
  bool continued = false;  ///< it is also read
};

struct Roles {
  std::map<std::string, ClaimedOutput> outputs;  ///< by option with its file
  std::set<fs::path> inputs;                     ///< absolute, as they were opened
};

std::mutex mutex;
std::optional<Roles> roles;

/// Whether both are the same file; also for two names of a file that does not exist yet.
bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || fs::equivalent(a, b, error);
}

std::string said(const std::string& option, const fs::path& file) {
  return one_line(fmt::format("{} '{}'", option, file.string()));
}

/// A file may have been replaced since it was read: the present file of the name decides.
bool is_input(const fs::path& place) {
  if (!roles) return false;
  std::error_code error;
  std::erase_if(roles->inputs, [&](const fs::path& input) { return !fs::exists(input, error); });
  return std::ranges::any_of(roles->inputs, [&](const fs::path& input) { return are_same(place, input); });
}

void claim(const std::string& option, const fs::path& file, bool continued) {
  check_writable(file);
  const OutputPlace place(file);
  const std::lock_guard lock(mutex);
  if (!roles || !place.is_replaced()) return;
  const std::string name = said(option, file);
  for (const auto& [other, output] : roles->outputs) {
    if (other == name || !are_same(output.place, place.path())) continue;
    throw SetupError(fmt::format("{}: this is the same file as {}; each result needs one of its own", name, other));
  }
  if (!continued && is_input(place.path())) throw SetupError(name + is_read);
  roles->outputs[name] = {.place = place.path(), .continued = continued};
}

}  // namespace

FileRoles::FileRoles() {
  const std::lock_guard lock(mutex);
  MUROSIMF_ASSERT(!roles && "the files of two commands at once");
  roles.emplace();
}

FileRoles::~FileRoles() {
  const std::lock_guard lock(mutex);
  MUROSIMF_ASSERT(roles.has_value());
  roles.reset();
}

void claim_output(const std::string& option, const fs::path& file) { claim(option, file, false); }

void claim_continued(const std::string& option, const fs::path& file) { claim(option, file, true); }

void note_input(const fs::path& file) {
  const std::lock_guard lock(mutex);
  if (!roles) return;
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  if (!error && !absolute.string().starts_with("/proc/"))
    // Also if the caller ignores the exception.
    roles->inputs.insert(absolute);
  for (const auto& [name, output] : roles->outputs) {
    if (!output.continued && are_same(output.place, file)) throw SetupError(name + is_read);
  }
}

void check_not_input(const fs::path& file) {
  const std::lock_guard lock(mutex);
  if (is_input(file)) throw SetupError(said("cannot write", file) + is_read);
}

}  // namespace murosimf::files

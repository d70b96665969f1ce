#include "murosimf/dds/participant.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "murosimf/dds/backend.h"
#include "murosimf/model/error.h"

namespace murosimf::dds {

namespace fs = std::filesystem;

namespace {

/// Beside the program, where it was built, or where it was installed.
std::string module_file() {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / "murosimf-fast-dds.so";
  for (const fs::path& place : std::array{beside, fs::path(MUROSIMF_DDS_BUILT), fs::path(MUROSIMF_DDS_INSTALLED)}) {
    if (fs::is_regular_file(place, error)) return place.string();
  }
  throw SetupError(fmt::format("DDS needs the module murosimf-fast-dds.so, which is neither beside this program nor {}",
                               MUROSIMF_DDS_INSTALLED));
}

/// Never unloaded: it has threads.
JoinDomain* load() {
  const std::string file = module_file();
  void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  auto* const join = module ? reinterpret_cast<JoinDomain*>(dlsym(module, join_domain_name)) : nullptr;
  if (!join) throw SetupError(fmt::format("DDS: {} cannot be loaded: {}", file, dlerror()));
  return join;
}

}  // namespace

struct Participant::Inside {
  std::unique_ptr<Backend> backend;
};

Participant::Participant(int domain) : inside_(std::make_unique<Inside>()) {
  if (domain < 0 || domain > highest_domain) {
    throw SetupError(fmt::format("a DDS domain is a number from 0 to {}, not {}", highest_domain, domain));
  }
  static JoinDomain* const join = load();
  inside_->backend.reset(join(domain));
  if (!inside_->backend) throw SetupError(fmt::format("DDS: the domain {} cannot be joined", domain));
}

Participant::~Participant() = default;

TopicWriter& Participant::writer(const Topic& topic) {
  if (TopicWriter* const writer = inside_->backend->writer(topic)) return *writer;
  throw SetupError(fmt::format("DDS: nothing can write to '{}'", topic.name));
}

void Participant::read(const Topic& topic, Inbox& inbox, char mark) {
  if (inside_->backend->read(topic, inbox, mark)) return;
  throw SetupError(fmt::format("DDS: nothing can read '{}'", topic.name));
}

}  // namespace murosimf::dds

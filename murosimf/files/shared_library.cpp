#include "murosimf/files/shared_library.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

/// The loader's message for its last failure, without the file at its beginning.
std::string loader_message(const std::string& file) {
  const char* said = dlerror();
  std::string text = said ? said : "no reason is known";
  if (text.starts_with(file + ": ")) text.erase(0, file.size() + 2);
  return text;
}

}  // namespace

SharedLibrary::SharedLibrary(const PrivateCopy& copy, Unloading unloading, const std::string& shown) {
  const std::string file = copy.path().string();
  const int keep = unloading == Unloading::never ? RTLD_NODELETE : 0;
  // RTLD_LOCAL: two controllers may define the same names.
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | keep);
  if (!handle_) throw SetupError(one_line(fmt::format("{}: cannot be loaded: {}", shown, loader_message(file))));
}

SharedLibrary::~SharedLibrary() { dlclose(handle_); }

std::span<const std::byte> SharedLibrary::memory() const {
  MUROSIMF_ASSERT(handle_ != nullptr);
  struct Search {
    ElfW(Addr) base = 0;
    std::span<const std::byte> memory{};
  } search;
  link_map* map = nullptr;
  if (::dlinfo(handle_, RTLD_DI_LINKMAP, &map) != 0) return {};
  search.base = map->l_addr;  // identifies the library among those that dl_iterate_phdr visits
  const auto look = [](dl_phdr_info* info, std::size_t, void* given) {
    auto& sought = *static_cast<Search*>(given);
    if (info->dlpi_addr != sought.base) return 0;
    ElfW(Addr) end = 0;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const ElfW(Phdr)& segment = info->dlpi_phdr[i];
      if (segment.p_type == PT_LOAD) end = std::max(end, segment.p_vaddr + segment.p_memsz);
    }
    sought.memory = {reinterpret_cast<const std::byte*>(sought.base), end};
    return 1;
  };
  ::dl_iterate_phdr(look, &search);
  return search.memory;
}

void* SharedLibrary::symbol(const char* name) const {
  MUROSIMF_ASSERT(handle_ != nullptr && name != nullptr);
  return dlsym(handle_, name);
}

}  // namespace murosimf::files

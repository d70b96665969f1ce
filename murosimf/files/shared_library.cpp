#include "murosimf/files/shared_library.h"

#include <dlfcn.h>

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/file_roles.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

/// What the loader says of its last failure, without the file at its beginning.
std::string loader_message(const std::string& file) {
  const char* said = dlerror();
  std::string text = said ? said : "no reason is known";
  if (text.starts_with(file + ": ")) text.erase(0, file.size() + 2);
  return text;
}

}  // namespace

SharedLibrary::SharedLibrary(const std::filesystem::path& file, Unloading unloading, const std::string& shown) {
  note_input(file);
  const int keep = unloading == Unloading::never ? RTLD_NODELETE : 0;
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | keep);
  if (!handle_)
    throw SetupError(one_line(fmt::format("{}: cannot be loaded: {}", shown, loader_message(file.string()))));
}

SharedLibrary::~SharedLibrary() { dlclose(handle_); }

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace murosimf::files

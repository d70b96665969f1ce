/// shared_library.h - a shared library that is loaded while the program runs, and its functions by name. The loader gets a copy of its
/// file (private_copy.h): later changes of the file do not affect the library.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "murosimf/files/private_copy.h"

namespace murosimf::files {

enum class Unloading {
  never,        ///< for libraries that register code in lists of the program
  when_unused,  ///< when the object is destroyed
};

class SharedLibrary {
 public:
  /// Throws SetupError in one line that begins with `shown`: it is no library, or lacks symbols. The copy is not needed afterwards.
  SharedLibrary(const PrivateCopy& copy, Unloading unloading, const std::string& shown);
  ~SharedLibrary();
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  /// Its memory: code, constants, tables of virtual functions.
  [[nodiscard]] std::span<const std::byte> memory() const;

  /// Null if it has no symbol of that name. The caller is responsible for the type.
  template <class Function>
  [[nodiscard]] Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  [[nodiscard]] void* symbol(const char* name) const;

  void* handle_ = nullptr;
};

}  // namespace murosimf::files

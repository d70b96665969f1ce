/// shared_library.h - a shared library that is loaded while the program runs, and its functions by name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace murosimf::files {

enum class Unloading {
  never,        ///< for what leaves its code in lists of the program
  when_unused,  ///< when the object is destroyed
};

class SharedLibrary {
 public:
  /// Throws SetupError in one line that begins with `shown`: it is no file, no library, or lacks symbols.
  SharedLibrary(const std::filesystem::path& file, Unloading unloading, const std::string& shown);
  ~SharedLibrary();
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  /// Null if it has none of that name. The caller knows the type.
  template <class Function>
  [[nodiscard]] Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  [[nodiscard]] void* symbol(const char* name) const;

  void* handle_ = nullptr;
};

}  // namespace murosimf::files

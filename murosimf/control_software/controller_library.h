/// controller_library.h - a shared library with control software (murosimf_controller.h), loaded and checked.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/control_software/murosimf_controller.h"
#include "murosimf/files/shared_library.h"

namespace murosimf::control_software {

class ControllerLibrary {
 public:
  /// Returns the library of this file in its present version, shared by all users. Throws SetupError in one line that begins with the file: it is
  /// missing, truncated, no library, no control software, made for another ABI, or lacks functions. Throws SoftwareCrash: code that runs
  /// when it is loaded would have ended the program.
  [[nodiscard]] static std::shared_ptr<const ControllerLibrary> load(const std::filesystem::path& file);

  /// When its file was written, if that was after it had been loaded.
  [[nodiscard]] std::optional<std::filesystem::file_time_type> newer() const;

  [[nodiscard]] const murosimf_controller& functions() const { return *functions_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// Of threads that it begins.
  [[nodiscard]] const std::shared_ptr<ForeignThreads>& threads() const { return threads_; }

  ControllerLibrary(const std::filesystem::path& file, std::filesystem::file_time_type written);
  ~ControllerLibrary();
  ControllerLibrary(const ControllerLibrary&) = delete;
  ControllerLibrary& operator=(const ControllerLibrary&) = delete;

 private:
  std::filesystem::path file_;
  std::filesystem::file_time_type written_;  // when its file was
  std::shared_ptr<ForeignThreads> threads_;
  std::optional<files::SharedLibrary> library_;
  const murosimf_controller* functions_ = nullptr;
};

}  // namespace murosimf::control_software

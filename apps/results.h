/// results.h - results of a command: each is written, also when others fail.
#pragma once

#include <string>

#include "apps/error_output.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

/// A PNG file that an option names: "--out", for files::claim_output. Throws SetupError, also if its name ends as that of another
/// kind of picture: programs would read it as one.
void claim_picture(const std::string& option, const std::string& file);

class Results {
 public:
  /// Prints why it could not be written, if it throws SetupError.
  template <class Write>
  void write(const Write& write) {
    try {
      write();
    } catch (const SetupError& error) {
      say_error(error.what());
      all_ = false;
    }
  }

  /// Whether nothing is missing.
  [[nodiscard]] bool all() const { return all_; }
  /// `code` if nothing is missing.
  [[nodiscard]] int exit_code(int code) const { return all_ ? code : user_error; }

 private:
  bool all_ = true;
};

}  // namespace murosimf::app

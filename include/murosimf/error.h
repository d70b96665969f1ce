/// error.h - exceptions of the library. Every text is one line: place, error, and remedy.
#pragma once

#include <stdexcept>

#include "murosimf/version.h"

namespace murosimf {
inline namespace v0 {

/// Base of all others. Thrown itself for a call on an object that was moved from, or that is in no state for the call.
class MUROSIMF_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~Error() override;
};

/// An error in a file, an option or a value: "scenes/a.toml:3:7: unknown level 'full'; did you mean 'full_dynamics'?".
class MUROSIMF_API InputError : public Error {
 public:
  using Error::Error;
  ~InputError() override;
};

/// There is no robot, object, sensor ... of that name; the text has the nearest name.
class MUROSIMF_API UnknownName : public InputError {
 public:
  using InputError::InputError;
  ~UnknownName() override;
};

/// The run cannot go on: control software has crashed.
class MUROSIMF_API SimulationError : public Error {
 public:
  using Error::Error;
  ~SimulationError() override;
};

}  // namespace v0
}  // namespace murosimf

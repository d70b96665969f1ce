/// supervision_arguments.h - the options of a supervised run (supervise/supervision.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "murosimf/supervise/supervision.h"

namespace murosimf::app {

struct SupervisionArguments {
  std::string where;                 ///< [HOST:]PORT; empty: no supervisors
  bool paused = false;               ///< at the beginning
  std::vector<std::string> folders;  ///< of scenes and models that supervisors may choose, too
};

/// The option that says where.
Option add_supervision(const Command& command, SupervisionArguments& arguments);

/// Throws SetupError: there is no such folder.
void check(const SupervisionArguments& arguments);

/// Prints where supervisors connect, and with which token. `options`: what else they may do. Null without supervisors. Throws SetupError, with
/// the option.
[[nodiscard]] std::unique_ptr<supervise::Supervision> supervision_of(session::Session& session,
                                                                     const SupervisionArguments& arguments,
                                                                     supervise::SupervisionOptions options);

}  // namespace murosimf::app

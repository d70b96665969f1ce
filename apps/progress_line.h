/// progress_line.h - one line on the terminal that changes; nothing if standard error is no terminal.
#pragma once

#include <unistd.h>

#include <string>

#include "apps/last_words.h"

namespace murosimf::app {

class ProgressLine {
 public:
  ProgressLine() = default;
  ~ProgressLine() {
    if (shown_) show_on_terminal("\r\033[K");
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text) const {
    if (!shown_) return;
    show_on_terminal("\r\033[K" + text);
  }

 private:
  bool shown_ = isatty(STDERR_FILENO) != 0;
};

}  // namespace murosimf::app

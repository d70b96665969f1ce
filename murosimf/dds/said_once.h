/// said_once.h - a line for the user about messages that a program sends again and again: said for the first of them only.
#pragma once

#include <string>

#include "murosimf/control_software/software_maker.h"

namespace murosimf::dds {

class SaidOnce {
 public:
  void say(const control_software::SayLine& to, const std::string& line) {
    if (!said_) to(line);
    said_ = true;
  }

 private:
  bool said_ = false;
};

}  // namespace murosimf::dds

/// line_rate.h - the bit rate that a program has chosen for a terminal.
#pragma once

namespace murosimf::serial {

/// [bit/s] Any number, not only those that have a name (B57600); 0 if it is not known.
[[nodiscard]] double line_rate(int terminal) noexcept;
/// Sets it. False: it could not be.
bool set_line_rate(int terminal, double rate) noexcept;

}  // namespace murosimf::serial

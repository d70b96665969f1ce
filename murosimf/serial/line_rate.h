/// line_rate.h - the bit rate that a program has set for a terminal.
#pragma once

namespace murosimf::serial {

/// [bit/s] Any number, not only named rates (B57600); 0 if unknown.
[[nodiscard]] double line_rate(int terminal) noexcept;
/// Sets the rate. Returns false on failure.
bool set_line_rate(int terminal, double rate) noexcept;

}  // namespace murosimf::serial

/// little_endian.h - numbers as bytes of a message, independent of this machine's byte order.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace murosimf::web {

template <class Unsigned>
void put_bytes(std::string& out, Unsigned value) {
  for (unsigned i = 0; i < sizeof value; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

inline void put_u8(std::string& out, std::uint8_t value) { out.push_back(static_cast<char>(value)); }
inline void put_u16(std::string& out, std::uint16_t value) { put_bytes(out, value); }
inline void put_u32(std::string& out, std::uint32_t value) { put_bytes(out, value); }
inline void put_u64(std::string& out, std::uint64_t value) { put_bytes(out, value); }
inline void put_i16(std::string& out, std::int16_t value) { put_bytes(out, static_cast<std::uint16_t>(value)); }
inline void put_f32(std::string& out, float value) { put_bytes(out, std::bit_cast<std::uint32_t>(value)); }
inline void put_f64(std::string& out, double value) { put_bytes(out, std::bit_cast<std::uint64_t>(value)); }

}  // namespace murosimf::web

#include "murosimf/network/connection.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace murosimf::network {
namespace {

constexpr std::size_t prefix = 4;               // [byte]
constexpr std::size_t first_buffer = 4 * 1024;  // [byte]

std::uint32_t length_at(const char* bytes) {
  assert(bytes != nullptr);
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < prefix; ++i) length = length << 8 | static_cast<unsigned char>(bytes[i]);
  return length;
}

}  // namespace

Connection::Connection(Socket socket, std::size_t longest)
    : socket_(std::move(socket)), longest_(longest), incoming_(std::min(first_buffer, prefix + longest)) {}

void Connection::send(std::string_view message) {
  assert(message.size() <= std::numeric_limits<std::uint32_t>::max());
  const auto length = static_cast<std::uint32_t>(message.size());
  // The most significant byte first, as the protocol has it.
  for (int shift = 24; shift >= 0; shift -= 8) outgoing_.push_back(static_cast<char>(length >> shift & 0xff));
  outgoing_.append(message);
  flush();
}

bool Connection::flush() {
  // A part of a message may be sent: the rest waits for the next call.
  while (sent_ < outgoing_.size()) {
    const std::size_t count = socket_.send(std::span(outgoing_).subspan(sent_));
    if (count == 0) return false;
    sent_ += count;
  }
  outgoing_.clear();
  sent_ = 0;
  return true;
}

void Connection::flush_until(WallTime end) {
  while (!flush()) {
    if (!socket_.wait(end, true)) throw NetworkError("does not take what it is sent");
  }
}

/// The next message in the buffer, which grows to the arriving message after its length has been checked.
std::optional<std::string_view> Connection::next_in_buffer() {
  assert(begin_ <= end_ && end_ <= incoming_.size());
  const std::size_t there = end_ - begin_;
  if (there < prefix) return {};
  const std::size_t length = length_at(&incoming_[begin_]);
  if (length > longest_) {
    throw NetworkError(fmt::format("announces a message of {} bytes, the longest may have {}", length, longest_));
  }
  if (there < prefix + length) {
    if (prefix + length > incoming_.size()) incoming_.resize(prefix + length);
    return {};
  }
  const std::string_view message(&incoming_[begin_] + prefix, length);
  begin_ += prefix + length;
  return message;
}

/// Receives more bytes. Only called when no whole message is in the buffer, so that few bytes are moved.
void Connection::fill() {
  std::copy(incoming_.begin() + static_cast<std::ptrdiff_t>(begin_),
            incoming_.begin() + static_cast<std::ptrdiff_t>(end_), incoming_.begin());
  end_ -= begin_;
  begin_ = 0;
  end_ += socket_.receive(std::span(incoming_).subspan(end_));
  assert(end_ <= incoming_.size());
}

std::optional<std::string_view> Connection::receive() {
  for (;;) {
    // Several messages may have arrived at once.
    if (const auto message = next_in_buffer()) return message;
    const std::size_t before = end_ - begin_;
    fill();
    if (end_ == before) return {};
  }
}

std::string_view Connection::receive_until(WallTime end) {
  for (;;) {
    if (const auto message = receive()) return *message;
    if (!socket_.wait(end)) throw NetworkError("did not answer in time");
  }
}

}  // namespace murosimf::network

/// message_sink.h - destination of the messages of a FrameWriter: a file, or connected viewers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "murosimf/recording/mcap/mcap_records.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

class MessageSink {
 public:
  virtual ~MessageSink() = default;

  [[nodiscard]] virtual std::uint16_t add_schema(const std::string& name, const std::string& encoding,
                                                 std::string data) = 0;
  [[nodiscard]] virtual std::uint16_t add_channel(const std::string& topic, const std::string& encoding,
                                                  std::uint16_t schema, TextMap metadata = {}) = 0;
  virtual void write(std::uint16_t channel, Duration time, std::string_view data) = 0;
};

}  // namespace murosimf::recording

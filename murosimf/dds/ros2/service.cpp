#include "murosimf/dds/ros2/service.h"

#include <algorithm>

#include <fmt/format.h>

namespace murosimf::dds::ros2 {
namespace {

constexpr std::array<std::uint8_t, 2> cyclone{1, 16};  // vendor Eclipse Cyclone DDS

/// "simulation_interfaces/srv/GetEntities" is "simulation_interfaces::srv::dds_::GetEntities_Request_".
std::string dds_type(const std::string& type, const char* part) {
  const std::size_t first = type.find('/'), second = type.find('/', first + 1);
  return fmt::format("{}::{}::dds_::{}_{}_", type.substr(0, first), type.substr(first + 1, second - first - 1),
                     type.substr(second + 1), part);
}

}  // namespace

bool open_call(const Bytes& message, const SampleIdentity& from, ServiceCall& call) {
  if (message.size() < encapsulation_size) return false;
  call = {.request = message, .from = from};
  if (!std::equal(cyclone.begin(), cyclone.end(), from.writer.begin())) return true;
  if (message.size() < encapsulation_size + call.header.size()) return false;
  call.has_header = true;
  const auto begin = call.request.begin() + encapsulation_size;
  const auto end = begin + static_cast<std::ptrdiff_t>(call.header.size());
  std::copy(begin, end, call.header.begin());
  call.request.erase(begin, end);  // of 16 bytes: what follows stays aligned
  return true;
}

Service::Service(Participant& participant, const std::string& name, const std::string& type, Inbox& inbox, char mark)
    : answers_(participant.writer({.name = fmt::format("rr{}Reply", name),
                                   .type = dds_type(type, "Response"),
                                   .reliable = true,
                                   .large = true})) {
  participant.read({.name = fmt::format("rq{}Request", name), .type = dds_type(type, "Request"), .reliable = true},
                   inbox, mark);
}

void Service::answer(const ServiceCall& call, const Bytes& answer) {
  if (!call.has_header) return answers_.answer(answer, call.from);
  Bytes whole(answer.size() + call.header.size());
  auto at = std::copy_n(answer.begin(), encapsulation_size, whole.begin());
  at = std::copy(call.header.begin(), call.header.end(), at);
  std::copy(answer.begin() + encapsulation_size, answer.end(), at);
  answers_.answer(whole, call.from);
}

}  // namespace murosimf::dds::ros2

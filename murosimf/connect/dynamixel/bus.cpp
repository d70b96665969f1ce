#include "murosimf/connect/dynamixel/bus.h"

#include <algorithm>

namespace murosimf::connect::dynamixel {

std::vector<BusAnswer> Bus::execute(const Packet& packet) {
  Answers answers;
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool all = packet.id == broadcast_id, modern = packet.protocol == Protocol::v2;
  if (all && instruction == Instruction::ping) return ping_all(packet.protocol, answers), answers;
  if (all && instruction == Instruction::sync_write) return sync_write(packet), answers;
  if (all && instruction == Instruction::bulk_read) return bulk_read(packet, answers), answers;
  if (all && modern && instruction == Instruction::bulk_write) return bulk_write(packet), answers;
  if (all && modern && instruction == Instruction::sync_read) return sync_read(packet, answers), answers;
  if (modern && instruction == Instruction{status_instruction}) return answers;  // somebody's answer
  for (const auto& device : devices_) {
    if (device->protocol() != packet.protocol || !device->obeys(packet.id)) continue;
    if (const auto answer = device->execute(packet)) answers.push_back({device->return_delay(), to_bytes(*answer)});
  }
  return answers;
}

BusDevice* Bus::find(Protocol protocol, std::uint8_t id) const {
  for (const auto& device : devices_) {
    if (device->protocol() == protocol && device->id() == id) return device.get();
  }
  return nullptr;
}

void Bus::ping_all(Protocol protocol, Answers& answers) const {
  std::vector<const BusDevice*> in_order;
  for (const auto& device : devices_) {
    if (device->protocol() == protocol) in_order.push_back(device.get());
  }
  std::ranges::sort(in_order, {}, [](const BusDevice* device) { return device->id(); });
  for (const BusDevice* device : in_order) answers.push_back({device->return_delay(), to_bytes(*device->ping())});
}

bool Bus::read(const Packet& packet, std::uint8_t id, std::size_t address, std::size_t size, Answers& answers) const {
  const BusDevice* device = find(packet.protocol, id);
  const auto answer = device ? device->read(address, size) : std::nullopt;
  if (answer) answers.push_back({device->return_delay(), to_bytes(*answer)});
  return answer.has_value();
}

void Bus::sync_read(const Packet& packet, Answers& answers) const {
  const Bytes& parameters = packet.parameters;
  if (parameters.size() < 5) return;
  const std::size_t address = word(parameters, 0), size = word(parameters, 2);
  for (std::size_t i = 4; i < parameters.size(); ++i) {
    if (!read(packet, parameters[i], address, size, answers)) return;
  }
}

void Bus::bulk_read(const Packet& packet, Answers& answers) const {
  const Bytes& at = packet.parameters;
  const bool old = packet.protocol == Protocol::v1;  // 0, then length, id, address; else id, address(2), length(2)
  const std::size_t entry = old ? 3 : 5;
  Bytes asked;
  for (std::size_t i = old ? 1 : 0; i + entry <= at.size(); i += entry) {
    const std::uint8_t id = old ? at[i + 1] : at[i];
    if (std::ranges::find(asked, id) != asked.end()) continue;  // only the first counts
    asked.push_back(id);
    const bool answered =
        old ? read(packet, id, at[i + 2], at[i], answers) : read(packet, id, word(at, i + 1), word(at, i + 3), answers);
    if (!answered) return;
  }
}

void Bus::write(Protocol protocol, std::uint8_t id, std::size_t address, ByteView data) {
  for (const auto& device : devices_) {
    if (device->protocol() == protocol && id != broadcast_id && device->obeys(id)) (void)device->write(address, data);
  }
}

void Bus::sync_write(const Packet& packet) {
  const ByteView at = packet.parameters;
  const bool old = packet.protocol == Protocol::v1;
  const std::size_t head = old ? 2 : 4;
  if (at.size() < head) return;
  const std::size_t address = old ? at[0] : word(at, 0), size = old ? at[1] : word(at, 2);
  for (std::size_t i = head; i + 1 + size <= at.size(); i += 1 + size) {
    write(packet.protocol, at[i], address, at.subspan(i + 1, size));
  }
}

void Bus::bulk_write(const Packet& packet) {
  const ByteView at = packet.parameters;
  std::size_t i = 0;
  while (i + 5 <= at.size()) {
    const std::size_t size = word(at, i + 3);
    if (i + 5 + size > at.size()) return;
    write(packet.protocol, at[i], word(at, i + 1), at.subspan(i + 5, size));
    i += 5 + size;
  }
}

}  // namespace murosimf::connect::dynamixel

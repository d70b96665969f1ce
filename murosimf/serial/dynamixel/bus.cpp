#include "murosimf/serial/dynamixel/bus.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/serial/dynamixel/packet_checksum.h"

namespace murosimf::serial::dynamixel {

namespace {

bool reads_many(Instruction instruction) {
  using enum Instruction;
  return instruction == sync_read || instruction == bulk_read || instruction == fast_sync_read ||
         instruction == fast_bulk_read;
}

}  // namespace

std::vector<BusAnswer> Bus::execute(const Packet& packet, double rate) {
  MUROSIMF_ASSERT(rate >= 0);
  Answers answers;
  rate_ = rate;
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool all = packet.id == broadcast_id, modern = packet.protocol == Protocol::v2;
  if (modern && instruction == Instruction{status_instruction}) return answers;  // the answer of another device
  for (const auto& device : devices_) {
    if (understands(*device, packet.protocol)) device->heard();
  }
  if (all && instruction == Instruction::ping) return ping_all(packet.protocol, answers), answers;
  if (all && instruction == Instruction::sync_write) return sync_write(packet), answers;
  if (all && modern && instruction == Instruction::bulk_write) return bulk_write(packet), answers;
  if (all && reads_many(instruction)) return read_all(packet, answers), answers;
  for (const auto& device : devices_) {
    if (!understands(*device, packet.protocol) || !device->obeys(packet.id)) continue;
    if (const auto answer = device->execute(packet)) answers.push_back({device->return_delay(), to_bytes(*answer)});
  }
  return answers;
}

bool Bus::understands(const BusDevice& device, Protocol protocol) const {
  return device.protocol() == protocol && device.hears(rate_);
}

BusDevice* Bus::find(Protocol protocol, std::uint8_t id) const {
  for (const auto& device : devices_) {
    if (understands(*device, protocol) && device->id() == id) return device.get();
  }
  return nullptr;
}

void Bus::ping_all(Protocol protocol, Answers& answers) const {
  std::vector<const BusDevice*> in_order;
  for (const auto& device : devices_) {
    if (understands(*device, protocol) && device->answers_broadcast()) in_order.push_back(device.get());
  }
  // by id, since each device waits for the answers of lower ids
  std::ranges::sort(in_order, {}, [](const BusDevice* device) { return device->id(); });
  for (const BusDevice* device : in_order) answers.push_back({device->return_delay(), to_bytes(*device->ping())});
}

bool Bus::read(Protocol protocol, const Request& request, Answers& answers) const {
  const BusDevice* device = find(protocol, request.id);
  const auto answer = device ? device->read(request.address, request.size) : std::nullopt;
  if (answer) answers.push_back({device->return_delay(), to_bytes(*answer)});
  return answer.has_value();
}

/// In the order of the packet; if a device is named twice, the first entry counts.
std::vector<Bus::Request> Bus::requests(const Packet& packet) {
  const Bytes& at = packet.parameters;
  const bool old = packet.protocol == Protocol::v1;
  const auto instruction = static_cast<Instruction>(packet.instruction);
  std::vector<Request> requests;
  const auto add = [&](std::uint8_t id, std::size_t address, std::size_t size) {
    if (std::ranges::find(requests, id, &Request::id) == requests.end()) requests.push_back({id, address, size});
  };
  if (instruction == Instruction::bulk_read || instruction == Instruction::fast_bulk_read) {
    const std::size_t entry = old ? 3 : 5;  // 0, then length, id, address; else id, address(2), length(2)
    for (std::size_t i = old ? 1 : 0; i + entry <= at.size(); i += entry) {
      old ? add(at[i + 1], at[i + 2], at[i]) : add(at[i], word(at, i + 1), word(at, i + 3));
    }
    return requests;
  }
  const std::size_t head = old ? 2 : 4;
  for (std::size_t i = head; i < at.size(); ++i) {
    requests.push_back(old ? Request{at[i], at[0], at[1]} : Request{at[i], word(at, 0), word(at, 2)});
  }
  return requests;
}

void Bus::read_all(const Packet& packet, Answers& answers) const {
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool old = packet.protocol == Protocol::v1;
  if (instruction == Instruction::fast_sync_read || instruction == Instruction::fast_bulk_read) {
    if (!old) fast_read(packet, answers);
    return;
  }
  for (const Request& request : requests(packet)) {
    const BusDevice* device = find(packet.protocol, request.id);
    const bool feetech = device && device->registers().table().feetech;
    if (old && feetech != (instruction == Instruction::sync_read)) return;  // each vendor supports one of the two
    if (!read(packet.protocol, request, answers)) return;
  }
}

/// One packet for all devices: its head comes from the first, then error, id, data and the checksum of all bytes before from each. After
/// a missing device nothing follows, and the packet stays incomplete.
void Bus::fast_read(const Packet& packet, Answers& answers) const {
  const std::vector<Request> all = requests(packet);
  std::size_t length = 1;  // of the instruction, then error, id and checksum of each
  for (const Request& request : all) length += request.size + 4;
  if (length + 7 > most_bytes) return;
  Bytes bytes{0xFF, 0xFF, 0xFD, 0x00, broadcast_id};
  append_word(bytes, length);
  bytes.push_back(status_instruction);
  std::size_t sent = 0;
  for (const Request& request : all) {
    const BusDevice* device = find(packet.protocol, request.id);
    const auto answer = device ? device->read(request.address, request.size) : std::nullopt;
    if (!answer) return;
    MUROSIMF_ASSERT(!answer->parameters.empty());
    Bytes data(answer->parameters.begin() + 1, answer->parameters.end());
    data.resize(request.size);  // a refused read has no data, but keeps its place
    bytes.push_back(answer->parameters.front());
    bytes.push_back(request.id);
    append(bytes, data);
    append_word(bytes, crc16(bytes));
    answers.push_back(
        {sent == 0 ? device->return_delay() : 0, {bytes.begin() + static_cast<std::ptrdiff_t>(sent), bytes.end()}});
    MUROSIMF_ASSERT(bytes.size() > sent);
    sent = bytes.size();
  }
}

void Bus::write(Protocol protocol, std::uint8_t id, std::size_t address, ByteView data) {
  for (const auto& device : devices_) {
    if (understands(*device, protocol) && id != broadcast_id && device->obeys(id)) (void)device->write(address, data);
  }
}

/// Incomplete packets are ignored, as devices do: a sync write has no answer that could refuse it.
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

/// Devices take what is complete; the rest of a packet that is too short is ignored.
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

}  // namespace murosimf::serial::dynamixel

#include "murosimf/serial/dynamixel/bus_device.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::serial::dynamixel {
namespace {

constexpr std::uint8_t reset_all = 0xFF, reset_but_id = 0x01, reset_but_id_and_baud = 0x02;
constexpr std::int32_t no_id = 253;  // secondary ids from here on mean none

/// Number of bytes of an address or a length.
std::size_t width(Protocol protocol) { return protocol == Protocol::v1 ? 1 : 2; }

std::size_t number_at(const Packet& packet, std::size_t place) {
  MUROSIMF_ASSERT(place + width(packet.protocol) <= packet.parameters.size());
  return packet.protocol == Protocol::v1 ? packet.parameters[place] : word(packet.parameters, place);
}

}  // namespace

BusDevice::BusDevice(const ControlTable& table, std::uint8_t id) : registers_(table) { registers_.set(Item::id, id); }

bool BusDevice::obeys(std::uint8_t id) const {
  const std::int32_t secondary = registers_.has(Item::secondary_id) ? registers_.get(Item::secondary_id) : no_id;
  return id == this->id() || id == broadcast_id || (secondary < no_id && id == secondary);
}

bool BusDevice::hears(double rate) const {
  if (asleep_ > 0) return false;
  return rate <= 0 || !registers_.has(Item::baud_rate) ||
         same_rate(registers_.table().baud_rate(registers_.get(Item::baud_rate)), rate);
}

bool BusDevice::listen_at(double rate) {
  if (!registers_.has(Item::baud_rate)) return true;
  const std::optional<std::int32_t> value = registers_.table().baud_value(rate);
  if (value) registers_.set(Item::baud_rate, *value);
  return value.has_value();
}

/// Level in the counting of Dynamixel servos: 0 answers pings, 1 reads too, 2 everything.
std::int32_t BusDevice::answer_level() const {
  return registers_.get(Item::status_return_level) + (registers_.table().feetech ? 1 : 0);
}

/// Follows indirect addressing: the address of the byte that an address refers to.
std::size_t BusDevice::resolved(std::size_t address) const {
  for (const IndirectBlock& block : registers_.table().indirect) {
    if (!block.has_data(address)) continue;
    const std::size_t place = block.addresses + 2 * (address - block.data);
    return registers_.byte(place) | registers_.byte(place + 1) << 8;
  }
  return address;
}

/// Indirect addresses show bytes of other registers: they are replaced after the plain read.
Refusal BusDevice::read_bytes(std::size_t address, std::size_t size, Bytes& data) const {
  const Refusal refusal = registers_.read(address, size, data);
  if (refusal != Refusal::none || registers_.table().indirect.empty()) return refusal;
  MUROSIMF_ASSERT(data.size() >= size);
  for (std::size_t i = 0; i < size; ++i) data[data.size() - size + i] = registers_.byte(resolved(address + i));
  return Refusal::none;
}

Packet BusDevice::status(Refusal refusal, ByteView data) const {
  return status_packet(protocol(), id(), error_byte(protocol(), refusal) | alarm(), data);
}

std::optional<Packet> BusDevice::ping() const {
  if (protocol() == Protocol::v1) return status(Refusal::none);
  Bytes data;
  append_word(data, static_cast<std::size_t>(registers_.get(Item::model_number)));
  data.push_back(static_cast<std::uint8_t>(registers_.get(Item::firmware)));
  return status(Refusal::none, data);
}

std::optional<Packet> BusDevice::read(std::size_t address, std::size_t size) const {
  if (answer_level() < 1) return std::nullopt;
  Bytes data;
  const Refusal refusal = read_bytes(address, size, data);
  return status(refusal, data);
}

std::optional<Packet> BusDevice::read(const Packet& packet) const {
  const std::size_t size = width(packet.protocol);
  if (packet.parameters.size() == 2 * size) return read(number_at(packet, 0), number_at(packet, size));
  return answer_level() < 1 ? std::nullopt : std::optional(status(Refusal::length));
}

Refusal BusDevice::write(std::size_t address, ByteView data) {
  std::vector<Registers::Change> changes;
  std::size_t done = 0;
  do {  // runs of bytes that are contiguous after indirect addressing
    const std::size_t begin = resolved(address + done);
    std::size_t size = data.empty() ? 0 : 1;
    while (done + size < data.size() && resolved(address + done + size) == begin + size) ++size;
    // all fields are checked before any is written: a write is done as a whole or refused
    const Refusal refusal = registers_.plan(begin, data.subspan(done, size), eeprom_locked(), changes);
    if (refusal != Refusal::none) return refusal;
    done += size;
  } while (done < data.size());
  for (const Registers::Change& change : changes) {
    if (const Refusal refusal = check(*change.field, change.value); refusal != Refusal::none) return refusal;
  }
  for (const Registers::Change& change : changes) {  // in order: the effect of one may set another
    registers_.apply(change);
    written(*change.field);
  }
  return Refusal::none;
}

Refusal BusDevice::write(const Packet& packet) {
  const std::size_t size = width(packet.protocol);
  if (packet.parameters.size() <= size) return Refusal::length;
  return write(number_at(packet, 0), ByteView(packet.parameters).subspan(size));
}

/// A registered instruction is executed once.
Refusal BusDevice::act() {
  if (standing_by_.empty()) return Refusal::instruction;
  const Packet packet = standing_by_.front();
  standing_by_.clear();
  registers_.set(Item::registered, 0);
  return write(packet);
}

Refusal BusDevice::reset(const Packet& packet) {
  std::uint8_t option = reset_all;
  if (packet.protocol == Protocol::v2) {
    if (packet.parameters.size() != 1) return Refusal::length;
    option = packet.parameters[0];
  }
  if (option != reset_all && option != reset_but_id && option != reset_but_id_and_baud) return Refusal::range;
  if (packet.id == broadcast_id && option == reset_all) return Refusal::access;  // all devices would get the same id
  const std::int32_t old_id = id();
  registers_.restore();
  if (option != reset_all) registers_.set(Item::id, old_id);
  restart();
  return Refusal::none;
}

/// RAM has its defaults again; EEPROM keeps its values. The device is deaf while it starts.
void BusDevice::restart() {
  registers_.restore_ram();
  registers_.set(Item::registered, 0);
  registers_.set(Item::hardware_error, 0);
  standing_by_.clear();
  asleep_ = start_time;
  restarted();
}

Refusal BusDevice::do_as(const Packet& packet) {
  const bool old = packet.protocol == Protocol::v1;
  switch (static_cast<Instruction>(packet.instruction)) {
    case Instruction::write: return write(packet);
    case Instruction::reg_write:
      if (packet.parameters.size() <= width(packet.protocol)) return Refusal::length;
      standing_by_.assign(1, packet);
      registers_.set(Item::registered, 1);
      return Refusal::none;
    case Instruction::action: return act();
    case Instruction::factory_reset: return reset(packet);
    case Instruction::reboot:
      if (old) return Refusal::instruction;
      restart();
      return Refusal::none;
    case Instruction::clear: return old ? Refusal::instruction : clear(packet.parameters);
    default: return Refusal::instruction;
  }
}

std::optional<Packet> BusDevice::execute(const Packet& packet) {
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool own = packet.id == id();
  if (instruction == Instruction::ping) return own ? ping() : std::nullopt;
  if (instruction == Instruction::read) return own ? read(packet) : std::nullopt;
  const std::uint8_t answering =
      id();  // the answer carries the id of the request, though the instruction may change it
  const Refusal refusal = do_as(packet);
  if (!own || answer_level() < 2) return std::nullopt;
  Packet answer = status(refusal);
  answer.id = answering;
  return answer;
}

void BusDevice::state(StateArchive& archive) {
  archive(registers_, asleep_);
  Bytes standing_by = standing_by_.empty() ? Bytes{} : standing_by_.front().parameters;
  archive(standing_by);
  if (!archive.loads()) return;
  standing_by_.clear();
  if (standing_by.empty()) return;
  standing_by_.push_back({protocol(), id(), static_cast<std::uint8_t>(Instruction::reg_write), std::move(standing_by)});
}

}  // namespace murosimf::serial::dynamixel

#include "murosimf/dds/participant.h"

#include <cstring>
#include <deque>
#include <map>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::dds {
namespace {

using namespace eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

/// A type whose values are their encoded bytes: Fast DDS sends and delivers them as they are.
class EncodedType final : public TopicDataType {
 public:
  explicit EncodedType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = Inbox::longest_message;
    m_isGetKeyDefined = false;
    auto_fill_type_information(false);
    auto_fill_type_object(false);
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<Bytes*>(data);
    if (bytes.size() > payload->max_size) return false;
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

/// Called on threads of Fast DDS.
class Listener final : public DataReaderListener {
 public:
  Listener(Inbox& inbox, char mark) : inbox_(&inbox), mark_(mark) {}
  void on_data_available(DataReader* reader) override {
    SampleInfo info;
    while (reader->take_next_sample(&bytes_, &info) == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) inbox_->put(mark_, bytes_);
    }
  }
  void on_subscription_matched(DataReader*, const SubscriptionMatchedStatus& status) override {
    inbox_->count_writer(status.current_count_change);
  }

 private:
  Inbox* inbox_;
  char mark_;
  Bytes bytes_;
};

class Writer final : public TopicWriter {
 public:
  explicit Writer(DataWriter* writer) : writer_(writer) {}
  void write(const Bytes& message) override { writer_->write(const_cast<Bytes*>(&message)); }

 private:
  DataWriter* writer_;
};

DomainParticipantQos on_this_machine_alone() {
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  qos.wire_protocol().builtin.discovery_config.leaseDuration_announcementperiod = eprosima::fastrtps::Duration_t(0.2);
  return qos;
}

constexpr int kept_replies = 64;  // of a reliable topic, until they are acknowledged

template <class Qos>
void use_network_only(Qos& qos) {
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
}

}  // namespace

struct Participant::Inside {
  DomainParticipant* participant = nullptr;
  Publisher* publisher = nullptr;
  Subscriber* subscriber = nullptr;
  std::deque<Listener> listeners;
  std::deque<Writer> writers;

  ~Inside() {
    if (!participant) return;
    participant->delete_contained_entities();
    DomainParticipantFactory::get_instance()->delete_participant(participant);
  }
  /// A type may have several topics.
  eprosima::fastdds::dds::Topic* add(const Topic& topic) const {
    if (participant->find_type(topic.type).empty()) TypeSupport(new EncodedType(topic.type)).register_type(participant);
    auto* const made = participant->create_topic(topic.name, topic.type, TOPIC_QOS_DEFAULT);
    if (!made) throw SetupError(fmt::format("DDS: the topic '{}' cannot be made", topic.name));
    return made;
  }
};

Participant::Participant(int domain) : inside_(std::make_unique<Inside>()) {
  Log::SetVerbosity(Log::Kind::Error);
  if (domain < 0 || domain > highest_domain) {
    throw SetupError(fmt::format("a DDS domain is a number from 0 to {}, not {}", highest_domain, domain));
  }
  inside_->participant = DomainParticipantFactory::get_instance()->create_participant(static_cast<DomainId_t>(domain),
                                                                                      on_this_machine_alone());
  if (!inside_->participant) throw SetupError(fmt::format("DDS: the domain {} cannot be joined", domain));
  inside_->publisher = inside_->participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  inside_->subscriber = inside_->participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  if (!inside_->publisher || !inside_->subscriber) throw SetupError("DDS: no publisher or no subscriber can be made");
}

Participant::~Participant() = default;

/// A full history of a reliable topic drops the oldest message: a program that acknowledges nothing holds up no run.
TopicWriter& Participant::writer(const Topic& topic) {
  DataWriterQos qos;
  use_network_only(qos);
  qos.reliability().kind = topic.reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = topic.reliable ? kept_replies : 1;
  DataWriter* const writer = inside_->publisher->create_datawriter(inside_->add(topic), qos);
  if (!writer) throw SetupError(fmt::format("DDS: nothing can write to '{}'", topic.name));
  return inside_->writers.emplace_back(writer);
}

void Participant::read(const Topic& topic, Inbox& inbox, char mark) {
  DataReaderQos qos;
  use_network_only(qos);
  qos.reliability().kind = topic.reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = kept_replies;
  Listener& listener = inside_->listeners.emplace_back(inbox, mark);
  if (!inside_->subscriber->create_datareader(inside_->add(topic), qos, &listener)) {
    throw SetupError(fmt::format("DDS: nothing can read '{}'", topic.name));
  }
}

}  // namespace murosimf::dds

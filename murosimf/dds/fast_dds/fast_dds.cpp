// DDS by Fast DDS 2: the module that backend.h speaks of.
#include "murosimf/dds/backend.h"

#include <atomic>
#include <cstring>
#include <deque>
#include <functional>
#include <memory>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

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

SampleIdentity of_ours(const rtps::SampleIdentity& theirs) {
  SampleIdentity ours;
  const rtps::GUID_t& guid = theirs.writer_guid();
  std::memcpy(ours.writer.data(), guid.guidPrefix.value, rtps::GuidPrefix_t::size);
  std::memcpy(&ours.writer[rtps::GuidPrefix_t::size], guid.entityId.value, rtps::EntityId_t::size);
  ours.number = static_cast<std::int64_t>(theirs.sequence_number().to64long());
  return ours;
}

rtps::SampleIdentity of_theirs(const SampleIdentity& ours) {
  rtps::GUID_t guid;
  std::memcpy(guid.guidPrefix.value, ours.writer.data(), rtps::GuidPrefix_t::size);
  std::memcpy(guid.entityId.value, &ours.writer[rtps::GuidPrefix_t::size], rtps::EntityId_t::size);
  rtps::SampleIdentity theirs;
  theirs.writer_guid(guid);
  theirs.sequence_number(rtps::SequenceNumber_t(static_cast<std::uint64_t>(ours.number)));
  return theirs;
}

/// Called on threads of Fast DDS.
class Listener final : public DataReaderListener {
 public:
  Listener(Inbox& inbox, char mark) : inbox_(&inbox), mark_(mark) {}
  void on_data_available(DataReader* reader) override {
    SampleInfo info;
    while (reader->take_next_sample(&bytes_, &info) == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (info.valid_data)
        inbox_->put(mark_, bytes_, of_ours(info.sample_identity), of_ours(info.related_sample_identity));
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

/// Listens to itself: its readers are counted on threads of Fast DDS.
class Writer final : public TopicWriter, public DataWriterListener {
 public:
  /// False: it cannot be made.
  [[nodiscard]] bool open(Publisher& publisher, eprosima::fastdds::dds::Topic* topic, const DataWriterQos& qos) {
    writer_ = topic ? publisher.create_datawriter(topic, qos, this, StatusMask::publication_matched()) : nullptr;
    return writer_ != nullptr;
  }
  void write(const Bytes& message) override { writer_->write(const_cast<Bytes*>(&message)); }
  void answer(const Bytes& message, const SampleIdentity& request) override {
    rtps::WriteParams parameters;
    parameters.related_sample_identity(of_theirs(request));
    writer_->write(const_cast<Bytes*>(&message), parameters);
  }
  [[nodiscard]] bool has_readers() const override { return readers_ > 0; }
  void on_publication_matched(DataWriter*, const PublicationMatchedStatus& status) override {
    readers_ = status.current_count;
  }

 private:
  DataWriter* writer_ = nullptr;
  std::atomic<int> readers_{0};
};

/// Pictures go out in portions, with time between them: a reader that does not ask for lost fragments again has 212,992 bytes of buffer where the system's
/// settings are as they come.
std::shared_ptr<eprosima::fastdds::rtps::FlowControllerDescriptor> paced() {
  static const auto flow = [] {
    auto made = std::make_shared<eprosima::fastdds::rtps::FlowControllerDescriptor>();
    made->name = "pictures";
    made->max_bytes_per_period = 66'000;  // one fragment
    made->period_ms = 1;
    return made;
  }();
  return flow;
}

DomainParticipantQos on_this_machine_alone() {
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  qos.flow_controllers().push_back(paced());
  qos.wire_protocol().builtin.discovery_config.leaseDuration_announcementperiod = eprosima::fastrtps::Duration_t(0.2);
  return qos;
}

// in which fragments that were lost are asked for again; usually 3 s
const eprosima::fastrtps::Duration_t heartbeat_of_large(0.02);
constexpr int kept_replies = 64;  // of a reliable topic, until they are acknowledged

template <class Qos>
void use_network_only(Qos& qos) {
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
}

class FastDds final : public Backend {
 public:
  explicit FastDds(int domain)
      : participant_(DomainParticipantFactory::get_instance()->create_participant(static_cast<DomainId_t>(domain),
                                                                                  on_this_machine_alone())) {
    if (!participant_) return;
    publisher_ = participant_->create_publisher(PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  }
  ~FastDds() override {
    if (!participant_) return;
    participant_->delete_contained_entities();
    DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  [[nodiscard]] bool has_joined() const { return publisher_ && subscriber_; }

  [[nodiscard]] TopicWriter* writer(const Topic& topic) noexcept override;
  [[nodiscard]] bool read(const Topic& topic, Inbox& inbox, char mark) noexcept override;

 private:
  [[nodiscard]] eprosima::fastdds::dds::Topic* add(const Topic& topic) const;

  DomainParticipant* participant_;
  Publisher* publisher_ = nullptr;
  Subscriber* subscriber_ = nullptr;
  std::deque<Listener> listeners_;
  std::deque<Writer> writers_;
};

/// A type may have several topics.
eprosima::fastdds::dds::Topic* FastDds::add(const Topic& topic) const {
  if (participant_->find_type(topic.type).empty()) TypeSupport(new EncodedType(topic.type)).register_type(participant_);
  return participant_->create_topic(topic.name, topic.type, TOPIC_QOS_DEFAULT);
}

/// A full history of a reliable topic drops the oldest message: a program that acknowledges nothing holds up no run.
TopicWriter* FastDds::writer(const Topic& topic) noexcept {
  DataWriterQos qos;
  use_network_only(qos);
  qos.reliability().kind = topic.reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = topic.kept ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = topic.depth > 0 ? topic.depth : topic.reliable ? kept_replies : 1;
  if (topic.large) {
    qos.publish_mode().kind = ASYNCHRONOUS_PUBLISH_MODE;
    qos.publish_mode().flow_controller_name = paced()->name;
    qos.reliable_writer_qos().times.heartbeatPeriod = heartbeat_of_large;
  }
  Writer& writer = writers_.emplace_back();
  return writer.open(*publisher_, add(topic), qos) ? &writer : nullptr;
}

bool FastDds::read(const Topic& topic, Inbox& inbox, char mark) noexcept {
  DataReaderQos qos;
  use_network_only(qos);
  qos.reliability().kind = topic.reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = kept_replies;
  Listener& listener = listeners_.emplace_back(inbox, mark);
  auto* const made = add(topic);
  return made && subscriber_->create_datareader(made, qos, &listener);
}

}  // namespace

/// join_domain_name
extern "C" Backend* murosimf_join_dds_domain(int domain) {
  Log::SetVerbosity(Log::Kind::Error);
  auto joined = std::make_unique<FastDds>(domain);
  return joined->has_joined() ? joined.release() : nullptr;
}

}  // namespace murosimf::dds

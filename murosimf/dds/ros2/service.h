/// service.h - a service of ROS 2 over DDS: topics rq/NAMERequest and rr/NAMEReply.
///
/// How a client finds the answer to its request differs. rmw_fastrtps: the answer's related sample identity is that of the request. rmw_cyclonedds: request and
/// answer begin with 16 bytes, a number of the client and one of the request. The sender's GUID begins with the vendor of its DDS, by which
/// requests are told apart; the answer is in the form of its request.
/// Sources: rmw_fastrtps_shared_cpp (rmw_request, rmw_response), rmw_cyclonedds_cpp (cdds_request_header_t), both ROS 2 Humble to Jazzy; RTPS 2.3, 9.3.1.5
/// (vendors in GUIDs).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "murosimf/dds/participant.h"

namespace murosimf::dds::ros2 {

struct ServiceCall {
  Bytes request;  ///< with its encapsulation, without a header
  SampleIdentity from{};
  std::array<std::uint8_t, 16> header{};
  bool has_header = false;
};

/// False: it is too short to be one.
[[nodiscard]] bool open_call(const Bytes& message, const SampleIdentity& from, ServiceCall& call);

class Service {
 public:
  /// `name`: "/get_entities"; `type`: "simulation_interfaces/srv/GetEntities", or "control_msgs/action/FollowJointTrajectory_SendGoal". Requests go to the inbox, with
  /// this mark. Throws SetupError.
  Service(Participant& participant, const std::string& name, const std::string& type, Inbox& inbox, char mark);

  void answer(const ServiceCall& call, const Bytes& answer);

 private:
  TopicWriter& answers_;
};

}  // namespace murosimf::dds::ros2

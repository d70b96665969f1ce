/// rpc.h - requests and answers of a Booster robot's services: JSON in the texts of RpcMessage.
///
/// A request has {"api_id": N, ...} in its header and its parameters in its body; the answer has the same uuid, {"status": S} in its header, and a JSON
/// body or none. Numbers of requests: docs/booster.md.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "murosimf/dds/booster/messages.h"
#include "murosimf/dds/booster/robot_modes.h"

namespace murosimf::dds::booster {

/// Numbers of a request's body, by their names; true counts as 1. Others are ignored.
class RpcParameters {
 public:
  explicit RpcParameters(std::map<std::string, double, std::less<>> numbers) : numbers_(std::move(numbers)) {}
  /// Nothing: it is not there.
  [[nodiscard]] std::optional<double> find(std::string_view name) const;

 private:
  std::map<std::string, double, std::less<>> numbers_;
};

struct RpcAnswer {
  Status status = Status::success;
  std::string body{};  ///< JSON; empty: none
};

/// What a service does for a request.
using RpcHandler = std::function<RpcAnswer(const RpcParameters&)>;
using RpcHandlers = std::map<std::int64_t, RpcHandler>;

/// The answer to a request: bad request for what is no JSON or has no number, refused for a number without handler.
[[nodiscard]] RpcMessage answer_to(const RpcMessage& request, const RpcHandlers& handlers);

}  // namespace murosimf::dds::booster

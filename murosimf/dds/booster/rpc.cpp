#include "murosimf/dds/booster/rpc.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace murosimf::dds::booster {
namespace {

using Json = nlohmann::json;

/// No exceptions: a discarded value is no object.
Json object_of(const std::string& text) {
  constexpr std::size_t longest = 16384;  // [byte] of requests with nothing but numbers; nesting is bounded by it, too
  if (text.size() > longest) return Json::value_t::discarded;
  return Json::parse(text, nullptr, false);
}

std::optional<RpcParameters> parameters_of(const std::string& body) {
  std::map<std::string, double, std::less<>> numbers;
  if (body.empty()) return RpcParameters(numbers);
  const Json json = object_of(body);
  if (json.is_null()) return RpcParameters(numbers);
  if (!json.is_object()) return std::nullopt;
  for (const auto& [name, value] : json.items()) {
    if (value.is_boolean()) numbers[name] = value.get<bool>() ? 1 : 0;
    if (value.is_number() && std::isfinite(value.get<double>())) numbers[name] = value.get<double>();
  }
  return RpcParameters(numbers);
}

RpcAnswer handled(const RpcMessage& request, const RpcHandlers& handlers) {
  const Json header = object_of(request.header);
  if (!header.is_object()) return {Status::bad_request};
  const auto number = header.find("api_id");
  if (number == header.end() || !number->is_number_integer()) return {Status::bad_request};
  const std::optional<RpcParameters> parameters = parameters_of(request.body);
  if (!parameters) return {Status::bad_request};
  const auto handler = handlers.find(number->get<std::int64_t>());
  return handler == handlers.end() ? RpcAnswer{Status::refused} : handler->second(*parameters);
}

}  // namespace

std::optional<double> RpcParameters::find(std::string_view name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

RpcMessage answer_to(const RpcMessage& request, const RpcHandlers& handlers) {
  RpcAnswer answer = handled(request, handlers);
  return {request.uuid, fmt::format("{{\"status\":{}}}", static_cast<int>(answer.status)), std::move(answer.body)};
}

}  // namespace murosimf::dds::booster

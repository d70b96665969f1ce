#include "murosimf/dds/unitree/motion_switcher.h"

#include <fmt/format.h>

namespace murosimf::dds::unitree {
namespace {

enum Call : std::int64_t { check_mode = 1001, select_mode = 1002, release_mode = 1003 };
constexpr std::int32_t no_such_call = 3203;

}  // namespace

std::optional<Request> read_request(std::span<const std::uint8_t> bytes) {
  CdrReader from(bytes);
  Request request{.id = from.number<std::int64_t>(), .call = from.number<std::int64_t>()};
  (void)from.number<std::int64_t>();  // lease
  (void)from.number<std::int32_t>();  // priority
  request.no_reply = from.number<std::uint8_t>() != 0;
  request.parameter = from.text();
  if (!from.good()) return std::nullopt;
  return request;
}

void write_answer(CdrWriter& to, const Answer& answer) {
  to.number(answer.id).number(answer.call).number(answer.code).text(answer.data).blob("");
}

Answer switch_motion(const Request& request, bool& stands) {
  Answer answer{.id = request.id, .call = request.call};
  if (request.call == check_mode) {
    answer.data = fmt::format(R"({{"form":"0","name":"{}"}})", stands ? "ai" : "");
  } else if (request.call == select_mode || request.call == release_mode) {
    stands = request.call == select_mode;
  } else {
    answer.code = no_such_call;
  }
  return answer;
}

}  // namespace murosimf::dds::unitree

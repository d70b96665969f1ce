#include "apps/ros2_arguments.h"

#include <charconv>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "apps/steering.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

void add_ros2(const Command& command, Ros2Arguments& arguments) {
  command
      .add("--ros2", arguments.domain,
           "Take part in ROS 2 on this computer alone, which need not be installed; a value: DOMAIN of DDS "
           "(ROS_DOMAIN_ID)")
      .value_if_alone("0");
}

int read_domain(const std::string& option, const std::string& text) {
  constexpr int highest = dds::Participant::highest_domain;
  int domain = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (error == std::errc() && end == text.data() + text.size() && domain >= 0 && domain <= highest) return domain;
  throw SetupError(fmt::format("{}: a DDS domain is a number from 0 to {}, not '{}'", option, highest, text));
}

void check(const Ros2Arguments& arguments) {
  if (!arguments.domain.empty()) (void)read_domain("--ros2", arguments.domain);
}

std::unique_ptr<Ros2> join_ros2(scene::Scene& scene, const Ros2Arguments& arguments) {
  if (arguments.domain.empty()) return nullptr;
  return with_context("--ros2", [&] {
    auto joined = std::make_unique<Ros2>();
    joined->domain = read_domain("--ros2", arguments.domain);
    joined->participant = std::make_unique<dds::Participant>(joined->domain);
    joined->topics = std::make_unique<ros2::SceneTopics>(scene, *joined->participant,
                                                         [](const std::string& line) { say_warning(line); });
    return joined;
  });
}

std::unique_ptr<ros2::SimulationServices> services_of(session::Session& session, Ros2* joined, Steering& steering) {
  if (!joined) return nullptr;
  return with_context("--ros2", [&] {
    return std::make_unique<ros2::SimulationServices>(
        session, joined->domain,
        ros2::SimulationServicesOptions{
            .exchange = [&steering](const supervise::SceneRequest& request) { steering.exchange(request); },
            .models_from = steering.allowed_files(),
            .say = [](const std::string& line) { say_warning(line); }});
  });
}

}  // namespace murosimf::app

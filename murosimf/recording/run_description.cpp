#include "murosimf/recording/run_description.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/model/error.h"

namespace murosimf::recording {

/// Everything from which the scene is built and begun again.
std::string to_json(const RunDescription& run) {
  return files::json_text({{"schema", files::json_schema("run_description")},
                           {"scene", run.scene},
                           {"seed", run.seed},
                           {"set", run.overrides},
                           {"at", run.events},
                           {"push", run.pushes},
                           {"plugins", run.plugins},
                           {"libraries", run.libraries},
                           {"lenient", run.lenient},
                           {"cameras", run.cameras},
                           {"pushable", run.pushable},
                           {"channels", run.channels},
                           {"outside", run.outside},
                           {"start_ns", run.start.count()},
                           {"names", run.names}});
}

/// Recordings come from others: every missing or wrong key is an error of the file.
RunDescription parse_run_description(const std::string& json) {
  try {
    const auto document = nlohmann::json::parse(json);
    if (document.at("schema") != files::json_schema("run_description")) {
      throw SetupError("another version of the program has written how the run was begun");
    }
    RunDescription run;
    document.at("scene").get_to(run.scene);
    document.at("seed").get_to(run.seed);
    document.at("set").get_to(run.overrides);
    document.at("at").get_to(run.events);
    document.at("push").get_to(run.pushes);
    document.at("plugins").get_to(run.plugins);
    document.at("libraries").get_to(run.libraries);
    document.at("lenient").get_to(run.lenient);
    document.at("cameras").get_to(run.cameras);
    document.at("pushable").get_to(run.pushable);
    if (document.contains("channels")) document.at("channels").get_to(run.channels);  // missing in older recordings
    document.at("outside").get_to(run.outside);
    run.start = Duration(document.at("start_ns").get<Duration::rep>());
    document.at("names").get_to(run.names);
    return run;
  } catch (const nlohmann::json::exception&) {
    throw SetupError("what it says of how the run was begun (run.json) is damaged");
  }
}

}  // namespace murosimf::recording

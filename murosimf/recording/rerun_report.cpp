// Results of a repetition, for people and programs.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/recording/rerun.h"

namespace murosimf::recording {
namespace {

std::string s(Duration time) { return fmt::format("{:.6g} s", seconds(time)); }

/// How exact the instant is depends on how often hashes were recorded.
std::string when(const Divergence& difference) {
  if (!difference.same) return fmt::format("differs at {}, the first instant that was compared", s(difference.differs));
  if (difference.is_one_step()) {
    return fmt::format("differs for the first time at {}, one step after {}", s(difference.differs),
                       s(*difference.same));
  }
  return fmt::format("the same at {}, different at {}", s(*difference.same), s(difference.differs));
}

}  // namespace

std::string to_text(const RerunResult& result) {
  std::string text =
      fmt::format("repeated from {} to {}, {} instants compared: ", s(result.begin), s(result.end), result.compared);
  if (!result.difference) return text + (result.stopped ? "no difference until then\n" : "no difference\n");
  const Divergence& difference = *result.difference;
  text += when(difference) + "\n";
  if (difference.what) {
    text += fmt::format("at {}, recorded and repeated: {}\n", s(difference.looked), to_text(*difference.what));
  } else if (!difference.unlike.empty()) {
    text += fmt::format("at {} the recorded state cannot be compared: {}\n", s(difference.looked), difference.unlike);
  } else {
    text += "no state is recorded from then on, so it cannot be said which number differs\n";
  }
  return text;
}

std::string to_json(const RerunResult& result) {
  nlohmann::json root{
      {"schema", files::json_schema("rerun")}, {"begin_s", seconds(result.begin)}, {"end_s", seconds(result.end)},
      {"compared", result.compared},           {"stopped", result.stopped},        {"difference", nullptr}};
  if (result.difference) {
    const Divergence& one = *result.difference;
    nlohmann::json difference{{"same_s", one.same ? nlohmann::json(seconds(*one.same)) : nlohmann::json()},
                              {"differs_s", seconds(one.differs)},
                              {"is_one_step", one.is_one_step()},
                              {"compared_at_s", seconds(one.looked)},
                              {"unlike", one.unlike},
                              {"number", nullptr}};
    if (one.what) {
      difference["number"] = {{"entity", one.what->entity},     {"object", one.what->object},
                              {"property", one.what->property}, {"recorded", one.what->first},
                              {"repeated", one.what->second},   {"others", one.what->others}};
    }
    root["difference"] = std::move(difference);
  }
  return files::json_text(std::move(root));
}

}  // namespace murosimf::recording

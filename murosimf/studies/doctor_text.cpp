// What the doctor has found, as tables and as JSON.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/studies/doctor.h"
#include "murosimf/studies/text_table.h"

namespace murosimf::studies {
namespace {

std::string cell_of(const EntityEnding& one) {
  const std::string name = name_of(one.ending);
  return fmt::format("{}{}{:.2f} m{}", name, name.empty() ? "" : " ", one.way, one.flips ? " *" : "");
}

std::string table_of(const DoctorDimension& dimension) {
  TextTable table;
  std::vector<std::string> head{dimension.name};
  for (const DoctorRun& run : dimension.runs) head.push_back(run.label);
  table.add(head);
  MUROSIMF_ASSERT(!dimension.runs.empty());
  const std::vector<EntityEnding>& as_it_is = dimension.runs.front().entities;
  for (std::size_t i = 0; i < as_it_is.size(); ++i) {
    std::vector<std::string> row{as_it_is[i].name};
    for (const DoctorRun& run : dimension.runs) {
      // A scene that was refused has no entities.
      row.push_back(i < run.entities.size() ? cell_of(run.entities[i]) : "refused");
    }
    table.add(row);
  }
  std::string text = table.text();
  for (const DoctorRun& run : dimension.runs) {
    if (!run.refused.empty()) text += fmt::format("{}, {}: refused: {}\n", dimension.name, run.label, run.refused);
  }
  return text;
}

std::size_t runs_in(const Checkup& checkup) {
  std::size_t runs = 1;  // as it is, in all tables
  for (const DoctorDimension& one : checkup.dimensions) runs += one.runs.empty() ? 0 : one.runs.size() - 1;
  return runs;
}

nlohmann::json json_of(const DoctorDimension& dimension) {
  nlohmann::json runs = nlohmann::json::array();
  for (const DoctorRun& run : dimension.runs) {
    nlohmann::json entities = nlohmann::json::array();
    for (const EntityEnding& one : run.entities) {
      entities.push_back(
          {{"name", one.name}, {"ending", name_of(one.ending)}, {"distance_m", one.way}, {"flips", one.flips}});
    }
    runs.push_back({{"label", run.label}, {"refused", run.refused}, {"entities", entities}});
  }
  return {{"name", dimension.name}, {"skipped", dimension.skipped}, {"runs", runs}};
}

}  // namespace

std::string to_text(const Checkup& checkup) {
  std::string text = fmt::format("{}: {} runs of {:g} s\n", checkup.scene, runs_in(checkup), checkup.duration);
  for (const DoctorDimension& one : checkup.dimensions) {
    text += "\n" + (one.runs.empty() ? fmt::format("{}: {}\n", one.name, one.skipped) : table_of(one));
  }
  if (checkup.flips.empty()) return text + "\nno flips\n";
  text += fmt::format("\n{} flip{} (*):\n", checkup.flips.size(), checkup.flips.size() == 1 ? "" : "s");
  for (const std::string& flip : checkup.flips) text += flip + "\n";
  return text;
}

std::string to_json(const Checkup& checkup) {
  nlohmann::json dimensions = nlohmann::json::array();
  for (const DoctorDimension& one : checkup.dimensions) dimensions.push_back(json_of(one));
  return files::json_text({{"schema", files::json_schema("doctor")},
                           {"scene", checkup.scene},
                           {"duration_s", checkup.duration},
                           {"dimensions", dimensions},
                           {"flips", checkup.flips}});
}

}  // namespace murosimf::studies

#include "murosimf/studies/cost_search.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

constexpr std::uintmax_t most_state_bytes = 100'000'000;
constexpr const char* state_kind = "MuRoSimF search 1";

nlohmann::json to_state(const CmaEsState& cma) {
  return {{"generation", cma.generation}, {"sigma", cma.sigma}, {"mean", cma.mean},
          {"sigma_path", cma.sigma_path}, {"path", cma.path},   {"covariance", cma.covariance}};
}

CmaEsState cma_of(const nlohmann::json& json) {
  CmaEsState cma;
  json.at("generation").get_to(cma.generation);
  json.at("sigma").get_to(cma.sigma);
  json.at("mean").get_to(cma.mean);
  json.at("sigma_path").get_to(cma.sigma_path);
  json.at("path").get_to(cma.path);
  json.at("covariance").get_to(cma.covariance);
  return cma;
}

/// The file is complete or as it was before, also if this command has read it.
void write_state(const std::filesystem::path& file, const std::string& text) {
  files::PartFile part(file);
  std::ofstream out(part.path(), std::ios::binary);
  if (!(out << text << std::flush)) throw SetupError(fmt::format("cannot write '{}'", file.string()));
  out.close();
  part.commit(files::PartFile::Replaces::input_too);
}

class RunningSearch {
 public:
  RunningSearch(const CostSearchOptions& options, const CostsOf& costs_of) : options_(options), costs_of_(costs_of) {
    found_.start = found_.best = options.space.start;
    found_.start_cost = found_.best_cost = std::numeric_limits<double>::infinity();
  }

  CostSearch run() {
    load();
    if (!cma_) begin();
    // One evaluation is kept for the middle of the last distribution.
    while (!found_.stopped && has_time_for(cma_->population() + 1)) next_generation();
    if (!found_.stopped && found_.generations > 0) try_points({cma_->mean()});
    found_.seconds = elapsed();
    return found_;
  }

 private:
  /// Costs of the points, and keeps the best of them; empty: stopped.
  std::vector<double> try_points(const std::vector<std::vector<double>>& points) {
    std::vector<double> costs = costs_of_(points);
    if (costs.size() < points.size()) {
      found_.stopped = true;
      return {};
    }
    MUROSIMF_ASSERT(costs.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!(costs[i] < found_.best_cost)) continue;
      found_.best_cost = costs[i];
      found_.best = points[i];
    }
    found_.evaluations += points.size();
    return costs;
  }

  /// The distribution begins at the best of the first points.
  void begin() {
    std::vector<std::vector<double>> points{options_.space.start};
    points.insert(points.end(), options_.first.begin(), options_.first.end());
    const std::vector<double> costs = try_points(points);
    CmaEsOptions space = options_.space;
    if (!costs.empty()) {
      found_.start_cost = costs[0];
      space.start = found_.best;
    }
    cma_.emplace(space);
    if (!costs.empty()) note();
  }

  void next_generation() {
    MUROSIMF_ASSERT(cma_.has_value());
    const std::vector<double> costs = try_points(cma_->ask());
    if (costs.empty()) return;
    cma_->tell(costs);
    ++found_.generations;
    note();
  }

  [[nodiscard]] double elapsed() const {
    return before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  bool has_time_for(std::size_t points) {
    if (options_.stop && options_.stop()) found_.stopped = true;
    return !found_.stopped && found_.evaluations + points <= options_.evaluations && elapsed() < 60 * options_.minutes;
  }

  /// Written before progress is told: what was told is in the file.
  void note() {
    MUROSIMF_ASSERT(cma_.has_value() && found_.best.size() == found_.start.size());
    if (!options_.state.empty()) {
      const nlohmann::json json{{"kind", state_kind},
                                {"what", options_.what},
                                {"evaluations", found_.evaluations},
                                {"generations", found_.generations},
                                {"seconds", elapsed()},
                                {"start_cost", found_.start_cost},
                                {"best_cost", found_.best_cost},
                                {"best", found_.best},
                                {"cma_es", to_state(cma_->state())}};
      write_state(options_.state, json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    }
    if (!options_.progress) return;
    const double of_points = static_cast<double>(found_.evaluations) / static_cast<double>(options_.evaluations);
    options_.progress({.evaluations = found_.evaluations,
                       .of = options_.evaluations,
                       .best = found_.best_cost,
                       .share = std::max(of_points, elapsed() / (60 * options_.minutes))});
  }

  /// A file of another search is refused, not overwritten: it may hold hours of work.
  void load() {
    std::error_code error;
    if (options_.state.empty() || !std::filesystem::exists(options_.state, error)) return;
    const std::string text = files::read_input_file(options_.state, most_state_bytes);
    with_context(options_.state.string(), [&] {
      const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
      if (!json.is_object() || json.value("kind", nlohmann::json()) != state_kind)
        throw SetupError("it is no state of a search; remove it, or name another --out");
      if (json.value("what", nlohmann::json()) != options_.what) {
        throw SetupError(
            "it is of another search: of other options, files or another version of the program; remove it to begin "
            "anew, or name another --out");
      }
      try {
        take(json);
      } catch (const nlohmann::json::exception&) {
        throw SetupError("this state of a search is damaged; remove it to begin anew");
      }
    });
  }

  void take(const nlohmann::json& json) {
    json.at("evaluations").get_to(found_.evaluations);
    json.at("generations").get_to(found_.generations);
    json.at("seconds").get_to(before_);
    json.at("start_cost").get_to(found_.start_cost);
    json.at("best_cost").get_to(found_.best_cost);
    json.at("best").get_to(found_.best);
    if (found_.best.size() != found_.start.size()) throw SetupError("this state of a search is damaged; remove it");
    cma_.emplace(options_.space, cma_of(json.at("cma_es")));
    found_.taken_over = found_.evaluations;
  }

  const CostSearchOptions& options_;
  const CostsOf& costs_of_;
  CostSearch found_;
  std::optional<CmaEs> cma_;
  double before_ = 0;  // [s] of earlier parts
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

CostSearch search_cost(const CostSearchOptions& options, const CostsOf& costs_of) {
  return RunningSearch(options, costs_of).run();
}

}  // namespace murosimf::studies

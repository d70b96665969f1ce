#include "murosimf/ros2/entity_filter.h"

#include <regex.h>

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/ros2/bounds_filter.h"

namespace murosimf::ros2 {
namespace {

/// A POSIX extended regular expression. What takes longer than its length is not taken: counted repetitions and references to groups.
class Expression {
 public:
  /// Throws SetupError.
  explicit Expression(const std::string& text) {
    constexpr std::size_t longest = 200;  // [byte]
    if (text.size() > longest || text.find_first_of("{\\") != std::string::npos)
      throw SetupError(fmt::format("a filter has at most {} characters, and neither {{ nor \\", longest));
    if (regcomp(&compiled_, text.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
      throw SetupError("the filter is no POSIX extended regular expression");
  }
  ~Expression() { regfree(&compiled_); }
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;
  [[nodiscard]] bool matches(const std::string& name) const {
    return regexec(&compiled_, name.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

}  // namespace

std::vector<const Entity*> filtered(const scene::Scene& scene, const EntityFilters& filters,
                                    const std::function<EntityInfo(const Entity&)>& info) {
  std::optional<Expression> expression;
  if (!filters.names.empty()) expression.emplace(filters.names);
  std::optional<BoundsFilter> bounds;
  if (!filters.bounds.is_empty()) bounds.emplace(filters.bounds);
  std::vector<const Entity*> found;
  for (const Entity* entity : scene.moving_entities()) {
    const auto& of = filters.categories;
    if (!entity->present() || (expression && !expression->matches(entity->name()))) continue;
    const EntityInfo known = info(*entity);
    if (!of.empty() && std::ranges::find(of, known.category) == of.end()) continue;
    if (has_tags(filters, known.tags) && (!bounds || bounds->meets(*entity))) found.push_back(entity);
  }
  return found;
}

}  // namespace murosimf::ros2

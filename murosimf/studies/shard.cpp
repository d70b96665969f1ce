#include "murosimf/studies/shard.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

constexpr std::size_t most_shards = 1'000'000;

/// 0: it is no number from 1 on.
std::size_t parse_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? number : 0;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view number = std::string_view(text).substr(0, slash);
  const bool any = number == "any";
  const Shard shard{.number = any ? 0 : parse_number(number),
                    .of = slash < text.size() ? parse_number(std::string_view(text).substr(slash + 1)) : 0};
  const bool good =
      shard.of >= 1 && shard.of <= most_shards && (any || (shard.number >= 1 && shard.number <= shard.of));
  if (good) return shard;
  throw SetupError(
      files::one_line(fmt::format("--shard '{}': write K/N, like 3/8, with K from 1 to N, or any/N; N is at most {}",
                                  text, most_shards)));
}

}  // namespace murosimf::studies

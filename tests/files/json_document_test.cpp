// The text of JSON documents.
#include "murosimf/files/json_document.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace murosimf::files {
namespace {

using nlohmann::json;

TEST(JsonDocument, SaysWhatItIsAndInWhichVersion) {
  EXPECT_EQ(json_schema("run"), "murosimf/run/1");
  EXPECT_EQ(json_schema("run", 2), "murosimf/run/2");
}

TEST(JsonDocument, IsLinesInTheOrderOfKeys) {
  EXPECT_EQ(json_text({{"b", {1, 0.1}}, {"a", json::object()}, {"c", 40.0}}),
            "{\n    \"a\": {},\n    \"b\": [\n        1,\n        0.1\n    ],\n    \"c\": 40.0\n}\n");
}

TEST(JsonDocument, NamesNumbersThatAreNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  const json read = json::parse(json_text({{"list", {inf, -inf, 1.5}}, {"inside", {{"none", std::nan("")}}}}));
  EXPECT_EQ(read["list"], json({"Infinity", "-Infinity", 1.5}));
  EXPECT_EQ(read["inside"]["none"], "NaN");
}

TEST(JsonDocument, IsUtf8WhateverAFileHasAsAName) {
  const json read = json::parse(json_text({{"name", "a\xff"}}));
  EXPECT_EQ(read["name"], "a\xef\xbf\xbd");
}

}  // namespace
}  // namespace murosimf::files

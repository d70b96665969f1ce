// Drawings of an HTML file, read back as docs/web.md says: at every frame what was drawn then.
#include "murosimf/web/drawing_tracks.h"

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "murosimf/web/gzip.h"

namespace murosimf {
namespace {

using drawing::Drawn;
using nlohmann::json;

/// "blue1/way 0": kind, words, size and points of all shapes, in millimeters and tenths of them.
using Seen = std::map<std::string, std::vector<std::string>>;

std::string text_of(std::string_view kind, const std::string& words, double size,
                    const std::vector<long long>& points) {
  std::string text = std::string(kind) + "|" + words + "|" + std::to_string(std::llround(1e4 * size));
  for (const long long x : points) text += "|" + std::to_string(x);
  return text;
}

Seen seen_in(const std::vector<Drawn>& all) {
  Seen seen;
  for (const Drawn& drawn : all) {
    for (const DrawnGroup& group : drawn.groups) {
      auto& shapes = seen[drawn.by + "/" + group.name + " " + std::to_string(drawn.entity)];
      for (const DrawnShape& shape : group.shapes) {
        std::vector<long long> points;
        for (const Vec3d& p : shape.points) {
          for (const double x : {p.x, p.y, p.z}) points.push_back(std::llround(1000 * x));
        }
        shapes.push_back(text_of(drawn_kind_names[shape.kind], shape.words, shape.size, points));
      }
    }
  }
  return seen;
}

/// At a frame, from the start on.
Seen read(const json& object, int frame) {
  Seen seen;
  for (const json& track : object["tracks"]) {
    std::vector<long long> points;
    json looks = json::array();
    int at = 0;
    for (std::size_t i = 0; i < track["frames"].size(); ++i) {
      at += track["frames"][i].get<int>();
      if (at > frame) break;
      if (!track["looks"][i].is_null()) looks = track["looks"][i];
      auto next = track["points"][i].get<std::vector<long long>>();
      for (std::size_t k = 0; k < next.size() && next.size() == points.size(); ++k) next[k] += points[k];
      points = next;
    }
    if (looks.empty()) continue;
    auto& shapes = seen[track["by"].get<std::string>() + "/" + track["name"].get<std::string>() + " " +
                        std::to_string(track["entity"].get<int>())];
    auto next = points.begin();
    for (const json& number : looks) {
      const json& look = object["looks"][number.get<std::size_t>()];
      const auto end = next + 3 * look[7].get<std::ptrdiff_t>();
      shapes.push_back(text_of(look[0].get<std::string>(), look[6], look[1], {next, end}));
      next = end;
    }
  }
  return seen;
}

std::vector<Drawn> anything(std::mt19937& random) {
  const auto upto = [&](unsigned most) { return random() % (most + 1); };
  const auto place = [&] { return static_cast<double>(random() % 20001) / 1000 - 10; };
  std::vector<Drawn> all;
  for (int entity = -1; entity < 2; ++entity) {
    Drawn drawn{.entity = entity, .by = entity < 0 ? "roboviz" : "blue1", .groups = {}};
    for (const char* name : {"way", "ball"}) {
      DrawnGroup group{.name = name, .of_robot = entity == 1};
      for (unsigned i = upto(3); i > 0; --i) {
        DrawnShape shape{.kind = static_cast<DrawnShape::Kind>(upto(5))};
        for (unsigned k = upto(2) + 1; k > 0; --k) shape.points.push_back({place(), place(), place()});
        shape.size = 0.25 * upto(1);
        shape.words = upto(1) == 0 ? "" : "Ecke für blau";
        group.shapes.push_back(std::move(shape));
      }
      if (!group.shapes.empty()) drawn.groups.push_back(std::move(group));
    }
    if (!drawn.groups.empty()) all.push_back(std::move(drawn));
  }
  return all;
}

TEST(DrawingTracks, HaveAtEveryFrameWhatWasDrawnThen) {
  std::mt19937 random(7);
  web::DrawingTracks tracks;
  std::map<int, Seen> wanted;
  Seen now;
  for (int frame = 0; frame < 60; ++frame) {
    if (random() % 3 > 0) {
      const std::vector<Drawn> all = frame == 40 ? std::vector<Drawn>{} : anything(random);
      tracks.take(static_cast<std::size_t>(frame), all);
      now = seen_in(all);
    }
    wanted[frame] = now;
  }
  const json object = tracks.object();
  for (const auto& [frame, seen] : wanted) EXPECT_EQ(read(object, frame), seen) << frame;
}

TEST(DrawingTracks, WhatStaysIsNotWrittenAgain) {
  web::DrawingTracks tracks;
  EXPECT_TRUE(tracks.empty());
  std::vector<Drawn> all{{.entity = 0, .by = "blue1", .groups = {{.name = "way"}, {.name = "ball"}}}};
  for (DrawnGroup& group : all[0].groups) group.shapes.push_back({.kind = DrawnShape::dots, .points = {{1, 2, 3}}});
  tracks.take(0, all);
  for (const std::size_t frame : {5U, 6U}) {
    all[0].groups[1].shapes[0].points[0].x += 0.002;
    tracks.take(frame, all);
  }
  tracks.take(7, all);
  const json object = tracks.object();
  ASSERT_EQ(object["tracks"].size(), 2U);
  EXPECT_EQ(object["looks"].size(), 1U) << "all look alike";
  const json &ball = object["tracks"][0], &way = object["tracks"][1];
  EXPECT_EQ(way["frames"], json::parse("[0]"));
  EXPECT_EQ(ball["frames"], json::parse("[0, 5, 1]"));
  EXPECT_EQ(ball["looks"], json::parse("[[0], null, null]"));
  EXPECT_EQ(ball["points"], json::parse("[[1000, 2000, 3000], [2, 0, 0], [2, 0, 0]]"));
}

TEST(DrawingTracks, PolygonsHaveTheirTriangles) {
  const DrawnShape shape{.kind = DrawnShape::polygon,
                         .points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}};
  web::DrawingTracks tracks;
  tracks.take(0, {{.entity = -1, .by = "roboviz", .groups = {{.name = "L", .shapes = {shape}}}}});
  const json object = tracks.object();
  double area = 0;  // [m^2]; of an L, a fan would have more
  for (const json& triangle : object["looks"][0][8]) {
    const auto corner = [&](int i) { return shape.points[triangle[static_cast<std::size_t>(i)].get<std::size_t>()]; };
    area += norm(cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
  }
  EXPECT_NEAR(area, 3, 1e-12) << "sums of halves of whole numbers";
}

// A ball, a path to it and 12 particles of each of six robots, all of them anew in each of 25 frames per second: with the page and poses of
// three on three, 1.8 MB, it has to stay well below 5 MB.
TEST(DrawingTracks, AMinuteOfSixRobotsIsSmall) {
  std::mt19937 random(3);
  const auto noise = [&] { return static_cast<double>(random() % 1000) / 1000 - 0.5; };
  web::DrawingTracks tracks;
  for (std::size_t frame = 0; frame <= 1500; ++frame) {
    const double t = static_cast<double>(frame) / 25;
    std::vector<Drawn> all;
    for (int robot = 0; robot < 6; ++robot) {
      const Vec3d ball{1.5 * std::cos(t / 3) + 0.02 * noise(), std::sin(t / 3) + 0.02 * noise(), 0.07};
      DrawnShape path{.kind = DrawnShape::line}, cloud{.kind = DrawnShape::dots};
      for (int i = 0; i < 20; ++i) path.points.push_back(i / 19.0 * ball);
      for (int i = 0; i < 12; ++i) cloud.points.push_back({0.3 * noise() + robot, 0.3 * noise(), 0});
      DrawnGroup group{.name = "belief"};
      group.shapes = {{.kind = DrawnShape::circle, .points = {ball}, .size = 0.2}, path, cloud};
      all.push_back({.entity = robot, .by = "robot" + std::to_string(robot), .groups = {group}});
    }
    tracks.take(frame, all);
  }
  EXPECT_LT(4 * web::gzip(tracks.object().dump()).size() / 3, 1'500'000U) << "as base64";
}

}  // namespace
}  // namespace murosimf

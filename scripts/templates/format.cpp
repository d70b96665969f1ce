#include "murosimf/robot_formats/new_name/new_name_reader.h"

#include "murosimf/files/text_lines.h"

namespace murosimf::robot_formats::new_name {
namespace {

robot_formats::BodyDescription ball(double radius, double mass) {
  robot_formats::BodyDescription body;
  body.name = "ball";
  body.solid = {mass, {}, mass * robot_formats::unit_inertia(Sphere{radius})};
  body.shapes.emplace_back().placed.shape = Sphere{radius};
  return body;
}

}  // namespace

// Everything is resolved here: SI units, frames, names of the file. Soles, servos and sensors that the file does not name come
// from the TOML file beside it, for all formats alike (robot/robot_reader.h).
robot_formats::RobotDescription read(const std::filesystem::path& file, const robot_formats::ReaderOptions&) {
  files::TextLines lines(file);
  if (!lines.next()) lines.fail("the file is empty; it needs a radius [m] and a mass [kg]");
  const double radius = lines.number("radius");
  const double mass = lines.number("mass");
  if (!(radius > 0 && mass > 0)) lines.fail("radius and mass must be above 0");
  robot_formats::RobotDescription robot;
  robot.name = file.stem().string();
  robot.file = file;
  robot.bodies.push_back(ball(radius, mass));
  return robot;
}

}  // namespace murosimf::robot_formats::new_name

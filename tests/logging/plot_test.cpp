// Plots: pictures of the right size, gnuplot takes any text as text, errors are one line.
#include "murosimf/logging/plot.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "murosimf/files/child_process.h"
#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::logging {
namespace {

namespace fs = std::filesystem;

fs::path picture() { return fixtures::temp_folder() / ("plot_test." + std::to_string(::getpid()) + ".png"); }

std::string content(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A number of four bytes in the header of a PNG file.
unsigned number_at(const std::string& bytes, std::size_t offset) {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes.at(offset + i));
  return value;
}

Curve parabola(const std::string& name) {
  Curve curve{name, {}, {}};
  for (int i = 0; i < 50; ++i) {
    curve.x.push_back(0.1 * i);
    curve.y.push_back(0.01 * i * i);
  }
  return curve;
}

std::string refusal(const fs::path& file, const Plot& plot) {
  try {
    write_plot(file, plot);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

class Plots : public testing::Test {
 protected:
  void SetUp() override {
    if (!files::run_process({"gnuplot", "--version"}, {})) GTEST_SKIP() << "no gnuplot here";
  }
  void TearDown() override { fs::remove(picture()); }
};

TEST_F(Plots, ArePngPicturesOfTheSizeAskedFor) {
  write_plot(picture(), {.title = "Fall",
                         .x_label = "time [s]",
                         .panels = {{"height [m]", {parabola("a"), parabola("b")}}, {"rate [1/s]", {parabola("a")}}},
                         .width = 500,
                         .panel_height = 200});
  const std::string bytes = content(picture());
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(number_at(bytes, 16), 500U + 67U) << "and the legend";
  EXPECT_EQ(number_at(bytes, 20), 440U);
}

TEST_F(Plots, TakeAnyTextAsText) {
  const fs::path victim = picture().string() + ".victim";
  const std::string evil = "'; system \"touch " + victim.string() + "\"\nsystem(\"touch " + victim.string() + "\")\n\\";
  write_plot(picture(), {.title = evil, .x_label = evil, .panels = {{evil, {parabola(evil), parabola("\xff\x01")}}}});
  EXPECT_EQ(content(picture()).substr(1, 3), "PNG");
  EXPECT_FALSE(fs::exists(victim));
}

TEST_F(Plots, LeaveOutWhatHasNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const Curve nothing{"nothing", {0, 1}, {nan, infinite}};
  const Curve gap{"gap", {0, 1, 2, 3}, {0, nan, 1, 2}};
  const Plot plot{.title = "Gaps", .panels = {{"a", {nothing}}, {"b", {nothing, gap}}, {"c", {}}}};
  const std::string script = gnuplot_script(plot);
  EXPECT_EQ(script.find("'nothing'"), std::string::npos);
  EXPECT_NE(script.find("0 0\n\n2 1\n3 2\n"), std::string::npos) << script;
  write_plot(picture(), plot);
  EXPECT_EQ(content(picture()).substr(1, 3), "PNG");
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(PlotScript, ManyCurvesLookDifferent) {
  Panel panel{"angle [rad]", {}};
  for (int i = 0; i < 32; ++i) panel.curves.push_back(parabola("joint" + std::to_string(i)));
  const std::string script = gnuplot_script({.title = "All", .panels = {panel}});
  std::set<std::string> looks;
  for (auto at = script.find("linecolor rgb '#", script.find("plot $")); at != std::string::npos;
       at = script.find("linecolor rgb '#", at + 1)) {
    looks.insert(script.substr(at, script.find(" title", at) - at));
  }
  EXPECT_EQ(looks.size(), 32U);
  EXPECT_NE(script.find(",684 font"), std::string::npos) << "as high as its legend: " << script.substr(0, 100);
}

TEST(PlotScript, EveryPanelHasItsOwnLegend) {
  const Panel one{"a", {parabola("x"), parabola("y")}};
  const std::string script = gnuplot_script({.title = "T", .panels = {one, one}});
  EXPECT_EQ(count_of("title 'x'", script), 2U);
  EXPECT_EQ(script.find("unset key"), std::string::npos);
}

TEST(PlotScript, LongLabelsAreBroken) {
  const std::string label = "blue1.left_upper_leg_of_the_robot.measured_position [rad]";
  const std::string script = gnuplot_script({.title = "T", .panels = {{label, {parabola("")}}}});
  EXPECT_NE(script.find("set ylabel 'blue1.left_upper_leg_of_the_robot.'.\"\\n\".'measured_position [rad]'\n"),
            std::string::npos)
      << script.substr(script.find("set ylabel"), 120);
}

TEST_F(Plots, SayWhatIsWrong) {
  const Plot good{.title = "Fall", .panels = {{"height [m]", {parabola("a")}}}};
  EXPECT_NE(refusal(picture(), {.title = "Empty"}).find("plot 'Empty': there is nothing to draw"), std::string::npos);
  EXPECT_NE(refusal(picture(), {.title = "T", .panels = {{"y", {{"odd", {1, 2}, {1}}}}}}).find("'odd': 2 x and 1 y"),
            std::string::npos);
  EXPECT_NE(refusal("/no/such/folder/a.png", good).find("cannot write '/no/such/folder/a.png'"), std::string::npos);
  EXPECT_FALSE(fs::exists(picture()));
}

TEST_F(Plots, SayThatGnuplotIsMissing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/no/such/folder", 1);
  const std::string why = refusal(picture(), {.title = "Fall", .panels = {{"height [m]", {parabola("a")}}}});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(why.find("gnuplot-nox"), std::string::npos) << why;
  EXPECT_EQ(why.find('\n'), std::string::npos);
}

TEST(ChildProcess, PassesMoreThanAPipeHoldsBothWays) {
  const std::string text(1 << 20, 'x');
  const auto result = files::run_process({"cat"}, text);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->exit_code, 0);
  EXPECT_EQ(result->output, text);
}

TEST(ChildProcess, TellsHowItEnded) {
  EXPECT_EQ(files::run_process({"false"}, {})->exit_code, 1);
  EXPECT_EQ(files::run_process({"sh", "-c", "echo no >&2; exit 7"}, {})->errors, "no\n");
  EXPECT_EQ(files::run_process({"sh", "-c", "kill -9 $$"}, {})->exit_code, -1);
  EXPECT_FALSE(files::run_process({"no_such_program_anywhere"}, {}));
}

}  // namespace
}  // namespace murosimf::logging

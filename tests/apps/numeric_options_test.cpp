// Numbers of options: what is no number, or no sensible one, is refused in one line before anything is computed.
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

/// A command line up to its numeric option.
struct NumericOption {
  const char* command;
  const char* option;
};

constexpr NumericOption numeric_options[]{
    {"run walk", "--threads"},
    {"doctor walk", "--duration"},
    {"doctor walk", "--threads"},
    {"doctor walk", "--seed"},
    {"run walk", "--seed"},
    {"run walk", "--duration"},
    {"run walk", "--speed"},
    {"run walk --pictures FOLDER", "--picture-every"},
    {"run walk --duration 0.1 --log walker.pelvis.position --out FILE", "--log-rate"},
    {"run walk --duration 0.1 --record FILE", "--record-rate"},
    {"run walk --duration 0.1 --record FILE", "--record-states"},
    {"run walk --duration 0.1 --record FILE --record-on fall", "--keep"},
    {"run walk --duration 0.1 --html FILE", "--html-rate"},
    {"replay FILE --html FILE", "--html-rate"},
    {"rerun FILE", "--threads"},
    {"rerun FILE --record FILE", "--record-rate"},
    {"rerun FILE --record FILE", "--record-states"},
    {"rerun FILE --record FILE --record-on fall", "--keep"},
    {"branch FILE --set walker.command=[0,0,0]", "--time"},
    {"branch FILE --set walker.command=[0,0,0]", "--duration"},
    {"branch FILE --set walker.command=[0,0,0]", "--threads"},
    {"sweep walk --seeds 1..2", "--duration"},
    {"sweep walk --seeds 1..2", "--threads"},
    {"tune walk --model kid21", "--speed"},
    {"tune walk --model kid21", "--duration"},
    {"tune walk --model kid21", "--threads"},
    {"tune walk --model kid21", "--evaluations"},
    {"tune walk --model kid21", "--minutes"},
    {"tune walk --model kid21", "--seed"},
    {"tune kick --model kid21 --goal kicks", "--toward"},
    {"tune balance --model kid21", "--impulse"},
    {"tune balance --model kid21", "--fastest"},
    {"view walk --record FILE", "--record-rate"},
    {"view walk --record FILE", "--record-states"},
    {"view walk --record FILE --record-on asked", "--keep"},
    {"view walk", "--threads"},
    {"view walk", "--seed"},
    {"view walk", "--duration"},
    {"view walk", "--after"},
    {"view walk", "--samples"},
    {"render walk --out FILE", "--time"},
    {"render walk --out FILE", "--threads"},
    {"render walk --out FILE", "--seed"},
    {"render walk --video FILE.mp4", "--fps"},
    {"render walk --video FILE.mp4", "--duration"},
    {"render walk --video FILE.mp4", "--slow"},
    {"render walk --dataset FOLDER", "--frames"},
    {"highlights FILE", "--most"},
    {"highlights FILE", "--threads"},
    {"highlights FILE --video FILE.mp4", "--fps"},
    {"highlights FILE --video FILE.mp4", "--slow"},
    {"bench collision duel", "--duration"},
    {"compare walk --entity walker", "--duration"},
    {"compare walk --entity walker", "--seed"},
    {"compare walk --entity walker", "--repeat"},
    {"compare walk --entity walker", "--seeds"},
    {"compare walk --entity walker", "--servo-tolerance"},
    {"compare walk --entity walker", "--threshold path="},
    {"compare walk --entity walker", "--outcome walker.end="},
    {"fit-servo nowhere --out FILE", "--seed"},
    {"fit-servo nowhere --out FILE", "--starts"},
    {"fit-servo nowhere --out FILE", "--windows"},
    {"fit-servo nowhere --out FILE", "--threads"},
    {"fit-steps --model kid21 --out FILE", "--duration"},
    {"fit-steps --model kid21 --out FILE", "--rounds"},
    {"fit-steps --model kid21 --out FILE", "--threads"},
    {"fit-contact --pair ball carpet --out FILE", "--gravity"},
    {"fit-contact --pair ball carpet --out FILE", "--drag"},
    {"fit-contact --pair ball carpet --mass 1 --out FILE", "--radius"},
    {"fit-contact --pair ball carpet --radius 1 --out FILE", "--mass"},
    {"run walk --at", "TIME:walker.level=full_dynamics"},
};

std::string command_line(const NumericOption& numeric, const std::string& value) {
  std::string line = std::string(numeric.command) + " " + numeric.option;
  const auto fill = [&](const std::string& word, const std::string& text) {
    const auto place = line.find(word);
    if (place != std::string::npos) line.replace(place, word.size(), text);
    return place != std::string::npos;
  };
  fill("FOLDER", scratch("folder").string());
  fill("FILE", scratch("file").string());
  const bool inside = fill("TIME", value);
  if (!inside) line += (line.back() == '=' ? "" : " ") + value;
  return line;
}

TEST(NumericOptions, RefuseWhatIsNoSensibleNumber) {
  for (const NumericOption& numeric : numeric_options) {
    for (const char* value : {"nan", "inf", "-inf", "-1", "1e400", "99999999999999999999999", "two", "1x"}) {
      const bool large_is_fine = std::string(numeric.option).ends_with('=');
      if (large_is_fine && value[0] == '9') continue;
      const std::string line = command_line(numeric, value);
      const Result result = murosimf(line);
      EXPECT_EQ(result.exit_code, 2) << line << "\n" << result.errors;
      EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << line << "\n" << result.errors;
    }
  }
}

TEST(NumericOptions, AreAllInThisTest) {
  std::size_t found = 0;
  for (const std::string& command : commands()) {
    std::stringstream help(murosimf(command + " --help").output);
    for (std::string line; std::getline(help, line);) {
      const auto option = line.find("--");
      if (option == std::string::npos || line.find_first_not_of(' ') != option) continue;
      const bool numeric = line.find(" INT") != std::string::npos || line.find(" FLOAT") != std::string::npos ||
                           line.find(" UINT") != std::string::npos;
      if (!numeric) continue;
      ++found;
      const std::string name = line.substr(option, line.find_first_of(" :=", option) - option);
      const bool known = std::any_of(std::begin(numeric_options), std::end(numeric_options), [&](const auto& entry) {
        const std::string text = entry.command;
        return text.substr(0, text.find(' ')) == command && entry.option == name;
      });
      EXPECT_TRUE(known) << command << " " << name << " is not tried in this test";
    }
  }
  EXPECT_GT(found, 10U) << "the help looks different";
}

TEST(NumericOptions, SeedsAreExact) {
  const Result result = murosimf("run walk --duration 0 --seed 9007199254740993");
  EXPECT_NE(result.output.find("seed 9007199254740993,"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace murosimf::test

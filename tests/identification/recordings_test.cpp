// Recordings of a real XL-330 (Rhoban/bam), where they are: the folder servo-xl330 in the folder that the environment
// variable MUROSIMF_TEST_DATA names, or in shared/data beside the project.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "murosimf/identification/bench_logs.h"
#include "murosimf/identification/bench_servo.h"
#include "murosimf/identification/fitted_servo.h"
#include "murosimf/identification/servo_log_reader.h"
#include "tests/law.h"

namespace murosimf::identification {
namespace {

namespace fs = std::filesystem;

const fs::path source = MUROSIMF_SOURCE_DIR;

class Recordings : public testing::Test {
 protected:
  void SetUp() override {
    const char* variable = std::getenv("MUROSIMF_TEST_DATA");
    const fs::path data = variable ? fs::path(variable) : source.parent_path() / "shared" / "data";
    if (!fs::is_directory(data / "servo-xl330")) {
      GTEST_SKIP() << "no recordings in " << data << "; MUROSIMF_TEST_DATA names another folder";
    }
    logs_ = identification::read_servo_logs({(data / "servo-xl330").string()});
    ASSERT_EQ(logs_.size(), 8U);
  }

  /// [rad] mean of the recordings.
  [[nodiscard]] double error_of(const std::string& type, double step = 1e-3) const {
    const identification::FittedServo fitted = identification::read_fitted_servo(type);
    std::vector<Piece> pieces;
    for (const ServoLog& log : logs_) pieces.push_back(whole(log));
    BenchLogs bench(pieces, duty_per_gain(fitted.servo), step);
    std::vector<double> errors(logs_.size());
    bench.errors(bench_servo(fitted.servo, fitted.encoder_offset), errors);
    double sum = 0;
    for (const double error : errors) sum += error;
    return sum / static_cast<double>(errors.size());
  }

  std::vector<ServoLog> logs_;
};

// Law: published servos have the errors that an independent implementation found (78 to 117 mrad per trajectory; 94 and 95
// in the mean). Tolerance: 5 mrad; it took the nominal voltage, this one the measured, which is worth 2 to 4.
TEST_F(Recordings, PublishedServosAreAsFarOffAsElsewhere) {
  const std::string folder = (source / "tests/data/servos/").string();
  EXPECT_NEAR(error_of(folder + "xl330_published_m4.toml"), 0.094, 0.005);
  EXPECT_NEAR(error_of(folder + "xl330_published_m6.toml"), 0.095, 0.005);
}

// Law: a perfect servo is 539 mrad off: the recordings are read as by others. Tolerance: rounding of that figure.
TEST_F(Recordings, APerfectServoIsAsFarOffAsElsewhere) {
  double sum = 0;
  for (const ServoLog& log : logs_) {
    double error = 0;
    for (const ServoSample& sample : log.samples) error += std::fabs(sample.goal - sample.position);
    sum += error / static_cast<double>(log.samples.size());
  }
  EXPECT_NEAR(sum / 8, 0.539, 0.0006);
}

// Law: the servo that comes with the program, fitted to them, explains them. Tolerance: its file has 37.3 mrad.
TEST_F(Recordings, TheShippedServoExplainsThem) { EXPECT_LT(error_of("xl330_m4"), 0.038); }

// Law: the step has little influence: from 1 ms to 0.1 ms the error of a published servo changes by less than 1 mrad.
TEST_F(Recordings, AStepOfAMillisecondIsFineEnough) {
  const std::string type = (source / "tests/data/servos/xl330_published_m4.toml").string();
  EXPECT_NEAR(error_of(type, 1e-3), error_of(type, 1e-4), 1e-3);
}

}  // namespace
}  // namespace murosimf::identification

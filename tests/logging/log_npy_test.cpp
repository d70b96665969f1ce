// Arrays for NumPy: header, order of bytes, rows. What NumPy makes of them: oracle/logs_in_numpy.py.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "murosimf/logging/log_npy.h"

namespace murosimf::logging {
namespace {

using namespace std::chrono_literals;

std::uint64_t number_at(const std::string& bytes, std::size_t place, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = size; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[place + i]);
  return number;
}

/// The text between mark and numbers, without what fills it up.
std::string header(const std::string& bytes) {
  const std::string text = bytes.substr(12, number_at(bytes, 8, 4));
  return text.substr(0, text.find_last_not_of(" \n") + 1);
}

std::vector<double> numbers(const std::string& bytes) {
  std::vector<double> all;
  for (std::size_t at = 12 + number_at(bytes, 8, 4); at < bytes.size(); at += 8) {
    all.push_back(std::bit_cast<double>(number_at(bytes, at, 8)));
  }
  return all;
}

TEST(LogNpy, HasARowForEachInstant) {
  const LogSeries slow{{"a [m]", "b"}, {0ns, 20ms}, {1, 2, 3, 0.1}};
  const LogSeries fast{{"c"}, {0ns, 10ms, 21ms}, {1e-300, -0.0, 7}};
  const std::string bytes = to_npy({&slow, &fast});
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x02\x00", 8));
  EXPECT_EQ(header(bytes),
            "{'descr': [('time [s]', '<f8'), ('a [m]', '<f8'), ('b', '<f8'), ('c', '<f8')], "
            "'fortran_order': False, 'shape': (4,), }");
  EXPECT_EQ((12 + number_at(bytes, 8, 4)) % 64, 0U);
  EXPECT_EQ(bytes[12 + number_at(bytes, 8, 4) - 1], '\n');
  const std::vector<double> all = numbers(bytes);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> expected = {0, 1, 2, 1e-300, 0.01, nan, nan, -0.0, 0.02, 3, 0.1, nan, 0.021, nan, nan, 7};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(std::isnan(all[i]), std::isnan(expected[i])) << i;
    if (std::isnan(all[i])) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(all[i]), std::bit_cast<std::uint64_t>(expected[i])) << i;
  }
}

TEST(LogNpy, QuotesNamesAsPythonDoes) {
  const LogSeries odd{{R"(robot's \n)"}, {}, {}};
  const std::string bytes = to_npy({&odd});
  EXPECT_EQ(header(bytes),
            R"({'descr': [('time [s]', '<f8'), ('robot\'s \\n', '<f8')], 'fortran_order': False, 'shape': (0,), })");
  EXPECT_TRUE(numbers(bytes).empty());
}

TEST(LogNpy, SaysThatItsNamesAreInUtf8) {
  const LogSeries odd{{"knöchel"}, {}, {}};
  const std::string bytes = to_npy({&odd});
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x03\x00", 8));
  EXPECT_NE(header(bytes).find("('knöchel', '<f8')"), std::string::npos);
}

TEST(LogNpy, IsChosenByTheEndOfAName) {
  EXPECT_TRUE(is_named_npy("logs/run.npy"));
  for (const char* other : {"run.csv", "run.npy.csv", "npy", ".npy", "run.npyz", "/dev/stdout"}) {
    EXPECT_FALSE(is_named_npy(other)) << other;
  }
}

}  // namespace
}  // namespace murosimf::logging

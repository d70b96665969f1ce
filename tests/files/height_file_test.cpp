// Tables of heights: the bytes of each format are put together here, by the formats' own rules.
#include "murosimf/files/height_file.h"

#include <cstdint>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

using Rows = std::vector<std::vector<unsigned>>;

std::filesystem::path write(const std::string& name, const std::string& bytes) {
  const auto file = fixtures::temp_folder() / name;
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string message_of(const std::filesystem::path& file) {
  try {
    (void)read_height_file(file);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

template <class Number>
std::string npy(const std::string& type, const std::string& shape, const std::vector<Number>& numbers,
                const std::string& order = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (" + shape + "), }\n";
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() % 256);
  bytes += static_cast<char>(header.size() / 256);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  return bytes;
}

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

/// zlib's format without any compression (RFC 1950, RFC 1951, 3.2.4).
std::string stored(const std::string& bytes) {
  std::size_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto little = [](std::size_t n) { return std::string{static_cast<char>(n % 256), static_cast<char>(n / 256)}; };
  return "\x78\x01\x01" + little(bytes.size()) + little(0xFFFF - bytes.size()) + bytes + big_endian(b << 16 | a);
}

std::string chunk(const std::string& kind, const std::string& data) {
  return big_endian(data.size()) + kind + data + "crc?";
}

/// A gray picture; line i goes through filter i % 5.
std::string png(const Rows& rows, std::size_t sample, char color = 0) {
  const std::size_t width = rows[0].size() * sample;
  std::vector<int> before(width, 0);
  std::string packed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<int> line;
    for (const unsigned gray : rows[i]) {
      if (sample == 2) line.push_back(static_cast<int>(gray / 256));
      line.push_back(static_cast<int>(gray % 256));
    }
    const std::size_t filter = i % 5;
    packed += static_cast<char>(filter);
    for (std::size_t j = 0; j < width; ++j) {
      const int a = j < sample ? 0 : line[j - sample], b = before[j], c = j < sample ? 0 : before[j - sample],
                p = a + b - c;
      const int paeth = std::abs(p - a) <= std::abs(p - b) && std::abs(p - a) <= std::abs(p - c) ? a
                        : std::abs(p - b) <= std::abs(p - c)                                     ? b
                                                                                                 : c;
      const int guess[]{0, a, b, (a + b) / 2, paeth};
      packed += static_cast<char>((line[j] - guess[filter] + 256) % 256);
    }
    before = line;
  }
  std::string header = big_endian(rows[0].size()) + big_endian(rows.size()) + static_cast<char>(8 * sample) + color;
  header += std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored(packed)) + chunk("IEND", "");
}

TEST(HeightFile, ReadsCsv) {
  const HeightTable table = read_height_file(write("a.csv", "1,2.5,3\n4,5,-6e-1\n"));
  EXPECT_EQ(table.rows, 2U);
  EXPECT_EQ(table.columns, 3U);
  EXPECT_EQ(table.heights, (std::vector<double>{1, 2.5, 3, 4, 5, -0.6}));
  EXPECT_FALSE(table.is_picture);
}

TEST(HeightFile, ReadsNpyOfAllTypes) {
  const std::vector<double> expected{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(read_height_file(write("d.npy", npy("<f8", "2, 3", std::vector<double>{1, 2, 3, 4, 5, 6}))).heights,
            expected);
  EXPECT_EQ(read_height_file(write("f.npy", npy("<f4", "2, 3", std::vector<float>{1, 2, 3, 4, 5, 6}))).heights,
            expected);
  EXPECT_EQ(read_height_file(write("u.npy", npy("<u2", "3, 2", std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6}))).columns,
            2U);
  EXPECT_EQ(read_height_file(write("b.npy", npy("|u1", "2, 3", std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}))).heights,
            expected);
  EXPECT_EQ(
      read_height_file(write("i.npy", npy("<i2", "2, 3", std::vector<std::int16_t>{-1, 2, 3, 4, 5, 6}))).heights[0],
      -1);
}

TEST(HeightFile, ReadsGrayPicturesThroughEveryFilter) {
  for (const std::size_t sample : {1U, 2U}) {
    const unsigned white = sample == 1 ? 255 : 65535;
    Rows rows;
    for (unsigned i = 0; i < 11; ++i) {
      rows.emplace_back();
      for (unsigned j = 0; j < 7; ++j) rows.back().push_back((i * i * 977 + j * j * j * 1231 + 40000) % (white + 1));
    }
    rows[3][2] = white;
    rows[4][5] = 0;
    const HeightTable table = read_height_file(write("a.png", png(rows, sample)));
    ASSERT_EQ(table.heights.size(), 77U);
    EXPECT_TRUE(table.is_picture);
    for (std::size_t i = 0; i < 77; ++i)
      EXPECT_DOUBLE_EQ(table.heights[i], rows[i / 7][i % 7] / static_cast<double>(white)) << i;
  }
}

TEST(HeightFile, SaysWhatIsWrong) {
  const auto says = [](const std::string& name, const std::string& bytes, const std::string& what) {
    const std::string message = message_of(write(name, bytes));
    EXPECT_NE(message.find(what), std::string::npos) << message;
    EXPECT_NE(message.find(name), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  };
  says("row.csv", "1,2,3\n", "at least two of two");
  says("short.csv", "1,2\n3\n", "1 numbers, where the lines before have 2");
  says("word.csv", "1,2\n3,x\n", "x");
  says("nan.csv", "1,2\n3,nan\n", "must be finite");
  says("nan.npy", npy("<f8", "2, 2", std::vector<double>{1, 2, std::nan(""), 3}), "row 2, column 1 is not finite");
  says("one.npy", npy("<f8", "4,", std::vector<double>{1, 2, 3, 4}), "two dimensions");
  says("order.npy", npy("<f8", "2, 2", std::vector<double>{1, 2, 3, 4}, "True"), "column by column");
  says("type.npy", npy(">f8", "2, 2", std::vector<double>{1, 2, 3, 4}), "'>f8'");
  says("less.npy", npy("<f8", "2, 3", std::vector<double>{1, 2, 3, 4}), "32 bytes of numbers, where 2 x 3 take 48");
  says("huge.npy", npy("<f8", "9999999, 9999999", std::vector<double>{1}), "more than 100000 heights");
  says("text.npy", "hello, this is no array at all", "is no file of numpy.save");
  const Rows rows{{1, 2}, {3, 4}};
  const std::string good = png(rows, 1);
  says("color.png", png(rows, 1, 2), "is no gray picture");
  says("cut.png", good.substr(0, good.size() - 20), "ends too early");
  std::string broken = good;
  broken[broken.find("IDAT") + 12] ^= 1;
  says("broken.png", broken, "its pixels are broken");
  says("line.png", png({{1, 2, 3}}, 1), "at least two of two");
  says("a.txt", "1 2", ".png, .npy and .csv");
}

}  // namespace
}  // namespace murosimf::files

// Tables of numbers over time, CSV.
#include "murosimf/files/csv_file.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".csv", [](const auto& file) {
    const files::CsvTable table = files::read_csv(file);
    if (table.columns.empty()) std::abort();
    for (const files::CsvColumn& column : table.columns) {
      if (column.times.size() != column.values.size()) std::abort();
    }
  });
  return 0;
}

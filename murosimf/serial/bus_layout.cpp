#include "murosimf/serial/bus_layout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "murosimf/files/csv_cells.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/constants.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::serial {
namespace {

using dynamixel::ControlTable;
using dynamixel::Protocol;
using files::CsvCell;
using files::CsvCells;

void choose_table(ServoPlace& place, const Model& model, Protocol protocol) {
  MUROSIMF_ASSERT(place.joint < model.joints().size());
  // the joint's own type in the protocol of the bus, then in any, then an MX-28 as the most common servo
  const Servo* servo = model.find(properties::servo, model.joints()[place.joint]);
  const std::string type = servo ? servo->type : "";
  const std::string suffix = protocol == Protocol::v2 ? "_2" : "";
  for (const std::string& name : {type + suffix, type}) {
    place.table = dynamixel::find_servo_table(name);
    place.own_type = place.table != nullptr;
    if (place.table) return;
  }
  place.table = dynamixel::find_servo_table("mx28" + suffix);
}

class LayoutReader {
 public:
  LayoutReader(const std::filesystem::path& file, const Model& model, Protocol protocol)
      : cells_(file), folder_(file.parent_path()), model_(&model), protocol_(protocol) {}

  std::vector<ServoPlace> read() {
    if (!cells_.next(row_)) cells_.fail(1, "the file is empty");
    read_header();
    while (cells_.next(row_)) places_.push_back(read_row());
    if (places_.empty()) cells_.fail(1, "there is no servo");
    return std::move(places_);
  }

 private:
  void read_header() {
    // columns in any order, hence an index for each
    columns_ = row_.size();
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const files::CsvHeader header = files::csv_header(row_[i].text);
      std::optional<std::size_t>* column = column_of(header.name);
      if (!column)
        cells_.fail(row_[i].column, unknown_name("column", header.name, {"joint", "id", "servo", "direction", "zero"}));
      if (*column) cells_.fail(row_[i].column, fmt::format("there are two columns '{}'", header.name));
      *column = i;
      if (header.name != "zero") continue;
      if (header.unit != "deg" && header.unit != "rad")
        cells_.fail(row_[i].column, "write 'zero [deg]' or 'zero [rad]'");
      if (header.unit == "deg") zero_unit_ = pi / 180;
    }
    if (!joint_ || !id_) cells_.fail(1, "the columns 'joint' and 'id' are needed");
  }

  std::optional<std::size_t>* column_of(std::string_view name) {
    if (name == "joint") return &joint_;
    if (name == "id") return &id_;
    if (name == "servo") return &servo_;
    if (name == "direction") return &direction_;
    return name == "zero" ? &zero_ : nullptr;
  }

  /// Rows are checked cell by cell: an error names its column.
  ServoPlace read_row() {
    if (row_.size() != columns_) {
      cells_.fail(1, fmt::format("{} cells, where the first line has {}", row_.size(), columns_));
    }
    ServoPlace place;
    place.joint = joint(row_[*joint_]);
    place.id = id(row_[*id_]);
    choose_table(place, *model_, protocol_);
    if (const CsvCell* cell = given(servo_)) take_table(place, *cell);
    if (const CsvCell* cell = given(direction_)) {
      place.direction = cells_.number(*cell);
      if (std::abs(place.direction) != 1) cells_.fail(cell->column, "the direction is 1 or -1");
    }
    if (const CsvCell* cell = given(zero_)) {
      place.zero = zero_unit_ * cells_.number(*cell);
      if (!(std::abs(place.zero) < 100)) cells_.fail(cell->column, "the zero must be an angle");
    }
    return place;
  }

  [[nodiscard]] const CsvCell* given(const std::optional<std::size_t>& column) const {
    return column && !files::is_blank(row_[*column]) ? &row_[*column] : nullptr;
  }

  [[nodiscard]] std::size_t joint(const CsvCell& cell) const {
    const auto& joints = model_->joints();
    const std::optional<int> object = model_->find_object(cell.text);
    const auto found = object ? std::ranges::find(joints, *object) : joints.end();
    if (found == joints.end()) {
      std::vector<std::string_view> names;
      for (const int joint : joints) names.push_back(model_->objects()[joint].name);
      cells_.fail(cell.column, unknown_name("joint", cell.text, names));
    }
    const auto number = static_cast<std::size_t>(found - joints.begin());
    if (std::ranges::find(places_, number, &ServoPlace::joint) != places_.end()) {
      cells_.fail(cell.column, fmt::format("'{}' has a servo already", cell.text));
    }
    return number;
  }

  [[nodiscard]] std::uint8_t id(const CsvCell& cell) const {
    const double number = cells_.number(cell);
    if (!(number >= 0 && number < first_no_id && number == std::floor(number))) {
      cells_.fail(cell.column, fmt::format("an id is a whole number from 0 to {}", first_no_id - 1));
    }
    const auto id = static_cast<std::uint8_t>(number);
    if (std::ranges::find(places_, id, &ServoPlace::id) != places_.end()) {
      cells_.fail(cell.column, fmt::format("two servos have the id {}", id));
    }
    return id;
  }

  void take_table(ServoPlace& place, const CsvCell& cell) const {
    const ControlTable* table = dynamixel::find_servo_table(cell.text, folder_);
    if (!table) {
      const std::vector<std::string> known = dynamixel::servo_table_names();
      cells_.fail(cell.column, unknown_name("servo", cell.text, {known.begin(), known.end()}));
    }
    place.own_type = place.own_type && place.table == table;
    place.table = table;
  }

  CsvCells cells_;
  std::filesystem::path folder_;  // for the user's tables
  const Model* model_;
  Protocol protocol_;
  std::vector<CsvCell> row_;
  std::size_t columns_ = 0;
  std::optional<std::size_t> joint_, id_, servo_, direction_, zero_;
  double zero_unit_ = 1;  // [rad]
  std::vector<ServoPlace> places_;
};

}  // namespace

/// Ids in the order of the joints from 1 on, as most robots have them.
std::vector<ServoPlace> usual_layout(const Model& model, Protocol protocol) {
  const std::size_t joints = model.joints().size();
  if (joints >= first_no_id) {
    throw SetupError(
        fmt::format("a bus has no ids for {} joints; say which ones are on it: bus = \"ids.csv\"", joints));
  }
  std::vector<ServoPlace> places(joints);
  for (std::size_t i = 0; i < joints; ++i) {
    places[i].joint = i;
    places[i].id = static_cast<std::uint8_t>(i + 1);
    choose_table(places[i], model, protocol);
  }
  return places;
}

std::vector<ServoPlace> read_layout(const std::filesystem::path& file, const Model& model, Protocol protocol) {
  return LayoutReader(file, model, protocol).read();
}

}  // namespace murosimf::serial

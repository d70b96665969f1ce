#include "murosimf/dataset/summary.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/input_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

using nlohmann::json;

constexpr std::uintmax_t most_frame_bytes = 64'000'000;  // of one picture's annotations

json categories_of(const std::vector<Category>& categories) {
  json all = json::array();
  for (const Category& category : categories) {
    json one{{"id", category.number}, {"name", category.name}, {"supercategory", category.name.substr(0, 5)}};
    one["supercategory"] = category.name.starts_with("robot") ? "robot" : category.name;
    if (!category.keypoints.empty()) {
      one["keypoints"] = category.keypoints;
      one["skeleton"] = json::array();
    }
    all.push_back(std::move(one));
  }
  return all;
}

/// Pieces of a document that is too large to be built twice.
class CocoText {
 public:
  explicit CocoText(const std::vector<Category>& categories)
      : text_(fmt::format("{{\"info\": {{\"description\": \"MuRoSimF\"}},\n\"categories\": {},\n\"images\": [",
                          categories_of(categories).dump())) {}

  void add(const json& frame) {
    images_ += fmt::format("{}\n{}", images_.empty() ? "" : ",", frame.at("image").dump());
    for (json one : frame.at("annotations")) {
      one["image_id"] = frame.at("image").at("id");
      one["id"] = ++annotations_;
      rows_ += fmt::format("{}\n{}", rows_.empty() ? "" : ",", one.dump());
    }
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{}{}],\n\"annotations\": [{}]}}\n", text_, images_, rows_);
  }

 private:
  std::string text_, images_, rows_;
  std::uint64_t annotations_ = 0;
};

bool is_frame(const json& frame) {
  if (!frame.is_object() || !frame.contains("image") || !frame.contains("annotations")) return false;
  const json &image = frame["image"], &annotations = frame["annotations"];
  if (!image.is_object() || !annotations.is_array()) return false;
  if (!image.contains("id") || !image["id"].is_number_unsigned()) return false;
  if (!image.contains("part") || !image["part"].is_string()) return false;
  return std::ranges::all_of(annotations, [](const json& one) { return one.is_object(); });
}

json frame_of(const Folder& folder, std::uint64_t picture) {
  const auto file = folder.root() / Folder::frame(picture);
  json frame = json::parse(files::read_input_file(file, most_frame_bytes), nullptr, false);
  if (is_frame(frame)) return frame;
  throw SetupError(files::one_line(
      fmt::format("{}: this is no picture's file of a data set; delete it to have it made anew", file.string())));
}

std::string data_yaml(const std::vector<Category>& categories) {
  std::string text = "train: images/train\nval: images/val\nnames:\n";
  const std::vector<int> numbers = yolo_classes(categories);
  for (const Category& category : categories) {
    if (const int number = numbers[category.number]; number >= 0)
      text += fmt::format("  {}: {}\n", number, category.name);
  }
  return text;
}

}  // namespace

std::vector<int> yolo_classes(const std::vector<Category>& categories) {
  std::vector<int> numbers(class_next + categories.size(), -1);
  int next = 0;
  for (const Category& category : categories) {
    if (category.number != class_ground) numbers.at(category.number) = next++;
  }
  return numbers;
}

void write_summary(const Folder& folder, const std::vector<Category>& categories, std::uint64_t pictures) {
  CocoText all(categories), train(categories), validation(categories);
  for (std::uint64_t i = 0; i < pictures; ++i) {
    const json frame = frame_of(folder, i);
    all.add(frame);
    (frame.at("image").at("part") == "val" ? validation : train).add(frame);
  }
  folder.write("annotations.json", all.text());
  folder.write("annotations_train.json", train.text());
  folder.write("annotations_val.json", validation.text());
  folder.write("data.yaml", data_yaml(categories));
}

}  // namespace murosimf::dataset

#include "murosimf/dataset/folder.h"

#include <array>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/dataset/dice.h"
#include "murosimf/files/output_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

std::string numbered(const std::string& folder, std::uint64_t picture, const std::string& extension) {
  return fmt::format("{}/{:06}.{}", folder, picture, extension);
}

constexpr std::array folders{"images/train", "images/val", "labels/train", "labels/val", "depth",
                             "instances",    "classes",    "frames",       "normals"};

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw SetupError(files::one_line(fmt::format("cannot make '{}': {}", folder.string(), error.message())));
}

/// NAME.PID.part (files/output_file.h)
bool is_part(const std::filesystem::path& file) {
  const std::string process = file.stem().extension().string();  // ".PID"
  return file.extension() == ".part" && process.size() > 1 &&
         process.find_first_not_of("0123456789", 1) == std::string::npos;
}

void remove_parts_in(const std::filesystem::path& folder) {
  std::error_code error, ignored;
  auto inside = std::filesystem::directory_iterator(folder, error);
  for (; !error && inside != std::filesystem::directory_iterator(); inside.increment(error)) {
    if (is_part(inside->path()) && inside->is_regular_file(ignored)) std::filesystem::remove(inside->path(), ignored);
  }
}

}  // namespace

void Folder::make_root() const { make_folder(root_); }

void Folder::make(bool normals) const {
  for (const std::string_view name : folders) {
    if (normals || name != "normals") make_folder(root_ / name);
  }
}

void Folder::remove_parts() const {
  remove_parts_in(root_);
  for (const std::string_view name : folders) remove_parts_in(root_ / name);
}

std::vector<std::uint64_t> Folder::missing(std::uint64_t pictures) const {
  std::vector<std::uint64_t> numbers;
  std::error_code ignored;
  for (std::uint64_t i = 0; i < pictures; ++i) {
    if (!std::filesystem::exists(root_ / frame(i), ignored)) numbers.push_back(i);
  }
  return numbers;
}

const char* Folder::part_of(std::uint64_t picture) const {
  return Dice(seed_, "part", picture).chance(validation_) ? "val" : "train";
}

std::string Folder::image(std::uint64_t picture) const {
  return numbered(std::string("images/") + part_of(picture), picture, extension_);
}
std::string Folder::yolo(std::uint64_t picture) const {
  return numbered(std::string("labels/") + part_of(picture), picture, "txt");
}
std::string Folder::layer(const char* kind, std::uint64_t picture) { return numbered(kind, picture, "png"); }
std::string Folder::frame(std::uint64_t picture) { return numbered("frames", picture, "json"); }

void Folder::write(const std::string& name, const std::string& bytes) const { files::write_file(root_ / name, bytes); }

void Folder::replace(const std::string& name, const std::string& bytes) const {
  files::replace_file(root_ / name, bytes);
}

}  // namespace murosimf::dataset

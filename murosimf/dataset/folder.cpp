#include "murosimf/dataset/folder.h"

#include <fstream>
#include <system_error>
#include <vector>

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

}  // namespace

void Folder::make(bool normals) const {
  std::vector<std::string> names{"images/train", "images/val", "labels/train", "labels/val",
                                 "depth",        "instances",  "classes",      "frames"};
  if (normals) names.emplace_back("normals");
  for (const std::string& name : names) {
    std::error_code error;
    std::filesystem::create_directories(root_ / name, error);
    if (!error) continue;
    throw SetupError(files::one_line(fmt::format("cannot make '{}': {}", (root_ / name).string(), error.message())));
  }
}

void Folder::remove_parts() const {
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root_, error)) {
    if (entry.path().extension() == ".part") std::filesystem::remove(entry.path(), error);
  }
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
  files::PartFile part(root_ / name);
  std::ofstream stream(part.path(), std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw SetupError(files::one_line(fmt::format("cannot write '{}'", (root_ / name).string())));
  part.commit(files::PartFile::Replaces::input_too);
}

}  // namespace murosimf::dataset

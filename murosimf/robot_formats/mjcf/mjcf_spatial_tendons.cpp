#include "murosimf/robot_formats/mjcf/mjcf_spatial_tendons.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/tendon_path.h"

namespace murosimf::robot_formats::mjcf {
namespace {

using robot_formats::TendonBranchDescription;
using robot_formats::TendonPartDescription;

class PathReader {
 public:
  PathReader(const files::XmlElement& tendon, const MjcfNames& names) : tendon_(tendon), names_(names) {}

  [[nodiscard]] std::vector<TendonBranchDescription> read() && {
    for (const files::XmlElement& element : tendon_.children()) {
      MjcfAttributes attributes(element);
      attributes.overlay(element);
      if (element.tag() == "pulley") begin_branch(attributes);
      if (element.tag() == "site") path_.back().parts.push_back({site(attributes, "site"), ""});
      if (element.tag() == "geom") add_geom(attributes);
    }
    check_end(tendon_);
    return elsewhere_ ? std::vector<TendonBranchDescription>{} : std::move(path_);
  }

 private:
  void begin_branch(const MjcfAttributes& attributes) {
    const double divisor = attributes.number("divisor", 1);
    if (!(divisor > 0)) attributes.element().fail("divisor of pulley must be more than 0");
    if (path_.size() > 1 || !path_.back().parts.empty()) {
      check_end(attributes.element());
      path_.emplace_back();
    }
    path_.back().divisor = divisor;
  }

  void check_end(const files::XmlElement& element) const {
    const auto& parts = path_.back().parts;
    if (parts.size() < 2) element.fail("a branch of a spatial tendon needs two sites");
    if (!parts.back().shape.empty()) element.fail("a spatial tendon needs a site behind each geom");
  }

  [[nodiscard]] std::string site(const MjcfAttributes& attributes, const char* attribute) {
    const std::string name = attributes.text(attribute);
    const auto& known = names_.sites();
    if (std::ranges::find(known, name) != known.end()) return name;
    if (!names_.is_elsewhere("site", name)) {
      attributes.element().fail(unknown_name("site", name, {known.begin(), known.end()}));
    }
    elsewhere_ = true;
    return name;
  }

  void add_geom(const MjcfAttributes& attributes) {
    auto& parts = path_.back().parts;
    if (parts.empty() || !parts.back().shape.empty()) {
      attributes.element().fail("a spatial tendon needs a site before each geom");
    }
    const std::string geom = attributes.text("geom");
    if (geom.empty()) attributes.element().fail("geom of a spatial tendon without geom=\"...\"; add it");
    elsewhere_ = elsewhere_ || names_.is_elsewhere("geom", geom);
    parts.push_back({attributes.has("sidesite") ? site(attributes, "sidesite") : "", geom});
  }

  const files::XmlElement& tendon_;
  const MjcfNames& names_;
  std::vector<TendonBranchDescription> path_{1};
  bool elsewhere_ = false;
};

}  // namespace

std::vector<TendonBranchDescription> path_of_tendon(const files::XmlElement& tendon, const MjcfNames& names) {
  return PathReader(tendon, names).read();
}

void check_path(const files::XmlElement& tendon, const std::vector<TendonBranchDescription>& path,
                const robot_formats::RobotDescription& description) {
  for (const TendonBranchDescription& branch : path) {
    for (const TendonPartDescription& part : branch.parts) {
      if (robot_formats::find_part(description, part)) continue;
      tendon.fail(fmt::format("geom '{}' of this tendon is no sphere or cylinder of the robot", part.shape));
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf

#include "murosimf/robot_formats/mjcf/mjcf_replicate.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/math/transform.h"
#include "murosimf/robot_formats/mjcf/mjcf_references.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// One replicate element.
struct Replicate {
  Replicate(const files::XmlElement& element, const MjcfCompiler& compiler) : attributes(element) {
    attributes.overlay(element);
    const double number = attributes.number("count", 0);
    if (!(number >= 1) || number != std::floor(number) || number > static_cast<double>(most_elements)) {
      attributes.source("count").fail(
          fmt::format("count '{}' of replicate must be a whole number, at least 1", attributes.text("count")));
    }
    count = static_cast<int>(number);
    step = {attributes.vector("offset", {}), read_orientation(attributes, compiler)};
  }

  /// Ending of copy i: "-07" of twelve.
  [[nodiscard]] std::string suffix(int i) const {
    return fmt::format("{}{:0{}}", attributes.text("sep"), i, fmt::format("{}", count).size());
  }

  MjcfAttributes attributes;
  int count = 0;
  Transformd step;
};

std::string numbers(std::initializer_list<double> values) { return fmt::format("{}", fmt::join(values, " ")); }

files::XmlTree frame_at(const Transformd& place, const files::XmlElement& element) {
  const Quaterniond q = from_matrix(place.orientation);
  return {"frame",
          {{"pos", numbers({place.position.x, place.position.y, place.position.z})},
           {"quat", numbers({q.w, q.x, q.y, q.z})}},
          element,
          {}};
}

class Expansion {
 public:
  Expansion(files::XmlFile& file, const files::XmlElement& root, const MjcfCompiler& compiler)
      : file_(file), root_(root), compiler_(compiler) {}

  /// Expands all replicates below an element, innermost first: outer ones copy the result.
  void expand(const files::XmlElement& parent) {
    for (const files::XmlElement& child : parent.children()) {
      expand(child);
      if (child.tag() == "replicate") expand_one(child);
    }
  }

 private:
  void expand_one(const files::XmlElement& element) {
    const Replicate replicate(element, compiler_);
    const files::XmlTree content = files::copy_of(element);
    made_ += static_cast<std::size_t>(replicate.count) * content.size();
    if (made_ > most_elements) element.fail(fmt::format("replicate makes more than {} elements", most_elements));
    MjcfReferences names;
    names.add_all(content);
    std::vector<files::XmlTree> frames;
    Transformd place;
    for (int i = 0; i < replicate.count; ++i) {
      files::XmlTree& frame = frames.emplace_back(frame_at(place, element));
      frame.children = content.children;
      for (files::XmlTree& child : frame.children) names.rename(child, "", replicate.suffix(i));
      // A product of poses, not i times an offset: steps may turn.
      place = place * replicate.step;
    }
    MUROSIMF_ASSERT(frames.size() == static_cast<std::size_t>(replicate.count));
    file_.replace(element, frames);
    repeat_references(replicate, names);
  }

  /// Repeats elements that refer to a copy; tendons, then actuators first: others may refer to them.
  void repeat_references(const Replicate& replicate, MjcfReferences& names) {
    for (const char* section : {"tendon", "actuator", "contact", "equality", "sensor"}) {
      for (const files::XmlElement& element : root_.children(section)) repeat(element, replicate, names);
    }
  }

  void repeat(const files::XmlElement& section, const Replicate& replicate, MjcfReferences& names) {
    files::XmlTree others{section.tag(), section.attributes(), section, {}};
    std::vector<files::XmlTree> repeated;
    for (const files::XmlElement& element : section.children()) {
      files::XmlTree tree = files::copy_of(element);
      (names.mentioned_in(tree) ? repeated : others.children).push_back(std::move(tree));
    }
    if (repeated.empty()) return;
    if (section.tag() == "actuator" || section.tag() == "tendon") {
      for (const files::XmlTree& one : repeated) names.add(one);
    }
    for (int i = 0; i < replicate.count; ++i) {
      for (files::XmlTree tree : repeated) {
        names.rename(tree, "", replicate.suffix(i));
        others.children.push_back(std::move(tree));
      }
    }
    file_.replace(section, {others});
  }

  files::XmlFile& file_;
  files::XmlElement root_;
  const MjcfCompiler& compiler_;
  std::size_t made_ = 0;
};

}  // namespace

void expand_replicates(files::XmlFile& file, const files::XmlElement& root, const MjcfCompiler& compiler) {
  Expansion expansion(file, root, compiler);
  for (const files::XmlElement& world : root.children("worldbody")) expansion.expand(world);
}

}  // namespace murosimf::robot_formats::mjcf

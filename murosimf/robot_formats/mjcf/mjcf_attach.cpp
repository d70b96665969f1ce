#include "murosimf/robot_formats/mjcf/mjcf_attach.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_references.h"
#include "murosimf/robot_formats/mjcf/mjcf_replicate.h"
#include "murosimf/robot_formats/mjcf/mjcf_schema.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr int deepest = 8;  // models that attach models

/// Another file, prepared for attaching.
struct Model {
  files::XmlElement root;
  MjcfCompiler compiler;
  std::string outermost_class;
};

/// Prefixes of names. Classes always have one, so that those of the other file differ from those of this one.
struct Prefix {
  explicit Prefix(const files::XmlElement& attach)
      : of_names(attach.attribute("prefix").value_or("")),
        of_classes(of_names.empty() ? attach.attribute("model").value_or("") + ":" : of_names) {}

  std::string of_names, of_classes;
};

bool same_masses(const MjcfCompiler& a, const MjcfCompiler& b) {
  return a.inertia_from_geom == b.inertia_from_geom && a.least_mass == b.least_mass &&
         a.least_inertia == b.least_inertia && a.total_mass == b.total_mass && a.balance_inertia == b.balance_inertia;
}

bool has_class(const std::string& tag) { return is_actuator(tag) || tag == "mesh" || tag == "material"; }

class Attachment {
 public:
  Attachment(files::XmlFile& file, const files::XmlElement& root, MjcfCompiler& compiler, bool lenient, int depth,
             robot_formats::RobotDescription& description)
      : file_(file), root_(root), compiler_(compiler), lenient_(lenient), depth_(depth), description_(description) {}

  void attach() {
    for (const files::XmlElement& world : root_.children("worldbody")) attach_in(world);
    if (added_.empty()) return;
    // An attached model is declared there, so there is such a section.
    const files::XmlElement assets = root_.children("asset").front();
    added_.insert(added_.begin(), files::copy_of(assets));
    file_.replace(assets, added_);
  }

 private:
  void attach_in(const files::XmlElement& parent) {
    for (const files::XmlElement& child : parent.children()) {
      if (child.tag() == "attach") {
        attach_one(child);
      } else {
        attach_in(child);
      }
    }
  }

  void attach_one(const files::XmlElement& element) {
    const Model& model = model_of(element);
    const Prefix prefix(element);
    std::vector<files::XmlTree> trees = content(element, model);
    MjcfReferences names;
    for (const files::XmlTree& tree : trees) {
      names.add_all(tree);
      made_ += tree.size();
    }
    if (made_ > most_elements) element.fail(fmt::format("attach makes more than {} elements", most_elements));
    std::vector<files::XmlTree> sections = assets_of(model, names);
    add_relations(model, names, sections);
    // Renamed last: relations are selected by the names of the other file.
    for (files::XmlTree& tree : trees) adopt(tree, prefix, names, model.outermost_class);
    for (files::XmlTree& section : sections) {
      for (files::XmlTree& tree : section.children) {
        adopt(tree, prefix, names, has_class(tree.tag) ? model.outermost_class : "");
      }
    }
    sections.push_back(defaults_of(model, prefix, names));
    for (files::XmlTree& section : sections) {
      learn_units(section, model);
      if (!section.children.empty()) added_.push_back(std::move(section));
    }
    for (const files::XmlTree& tree : trees) learn_units(tree, model);
    file_.replace(element, trees);
  }

  /// Copies of the named body, or of all bodies of the world.
  [[nodiscard]] static std::vector<files::XmlTree> content(const files::XmlElement& element, const Model& model) {
    const auto name = element.attribute("body");
    std::vector<files::XmlTree> all;
    for (const files::XmlElement& world : model.root.children("worldbody")) {
      if (name) {
        if (const auto body = find_body(world, *name)) return {files::copy_of(*body)};
        continue;
      }
      for (const files::XmlElement& child : world.children()) {
        if (child.tag() != "light") all.push_back(files::copy_of(child));
      }
    }
    if (name) element.fail(fmt::format("{} has no body '{}'", model.root.file(), *name));
    return all;
  }

  [[nodiscard]] static std::optional<files::XmlElement> find_body(const files::XmlElement& parent,
                                                                  const std::string& name) {
    for (const files::XmlElement& child : parent.children()) {
      if (child.tag() == "body" && child.attribute("name") == name) return child;
      if (const auto inner = find_body(child, name)) return inner;
    }
    return std::nullopt;
  }

  /// Copies of meshes, materials and textures, with absolute paths of their files.
  [[nodiscard]] std::vector<files::XmlTree> assets_of(const Model& model, MjcfReferences& names) const {
    std::vector<files::XmlTree> sections;
    const auto own = std::filesystem::absolute(model.root.file()).parent_path();
    const auto meshes = own / model.compiler.mesh_folder, pictures = own / model.compiler.picture_folder;
    for (const files::XmlElement& section : model.root.children("asset")) {
      files::XmlTree assets{"asset", {}, section, {}};
      for (const files::XmlElement& element : section.children()) {
        if (element.tag() != "mesh" && element.tag() != "material" && element.tag() != "texture") continue;
        files::XmlTree& tree = assets.children.emplace_back(files::copy_of(element));
        if (const std::string* file = tree.find("file")) {
          const std::filesystem::path path = *file;
          if (compiler_.strip_path && element.tag() == "mesh")
            element.fail("strippath of the file that attaches this one loses its folder; remove it");
          if (!tree.find("name")) tree.set("name", path.stem().string());
          const auto& folder = element.tag() == "texture" ? pictures : meshes;
          tree.set("file", (folder / (model.compiler.strip_path ? path.filename() : path)).string());
        }
        names.add(tree);
      }
      sections.push_back(std::move(assets));
    }
    return sections;
  }

  /// Adds copies of elements that refer to an attached part; tendons first: others may refer to them.
  static void add_relations(const Model& model, MjcfReferences& names, std::vector<files::XmlTree>& sections) {
    for (const char* tag : {"tendon", "actuator", "contact", "equality", "sensor"}) {
      for (const files::XmlElement& section : model.root.children(tag)) {
        files::XmlTree relations{tag, {}, section, {}};
        for (const files::XmlElement& element : section.children()) {
          files::XmlTree tree = files::copy_of(element);
          if (!names.mentioned_in(tree)) continue;
          names.add(tree);
          relations.children.push_back(std::move(tree));
        }
        sections.push_back(std::move(relations));
      }
    }
  }

  /// All classes of the other file, its outermost one under its own name.
  [[nodiscard]] static files::XmlTree defaults_of(const Model& model, const Prefix& prefix,
                                                  const MjcfReferences& names) {
    files::XmlTree main{"default", {{"class", model.outermost_class}}, model.root, {}};
    for (const files::XmlElement& element : model.root.children("default")) {
      const files::XmlTree tree = files::copy_of(element);
      main.children.insert(main.children.end(), tree.children.begin(), tree.children.end());
    }
    adopt(main, prefix, names, "");
    return {attached_defaults, {}, model.root, {main}};
  }

  [[nodiscard]] static std::string outermost_class(const files::XmlElement& root) {
    std::string name = "main";
    for (const files::XmlElement& element : root.children("default")) {
      name = element.attribute("class").value_or(name);
    }
    return name;
  }

  /// Adds the prefix to names; an element without a class gets `otherwise`, unless that is empty; bodies for all of their contents.
  static void adopt(files::XmlTree& tree, const Prefix& prefix, const MjcfReferences& names,
                    const std::string& otherwise) {
    const std::string word = tree.tag == "body" || tree.tag == "frame" ? "childclass" : "class";
    if (!otherwise.empty() && !tree.find(word)) tree.set(word, otherwise);
    names.rename(tree, prefix.of_names, "");
    rename_classes(tree, prefix.of_classes);
  }

  static void rename_classes(files::XmlTree& tree, const std::string& prefix) {
    for (const char* word : {"class", "childclass"}) {
      if (std::string* name = tree.find(word)) *name = prefix + *name;
    }
    for (files::XmlTree& child : tree.children) rename_classes(child, prefix);
  }

  void learn_units(const files::XmlTree& tree, const Model& model) {
    const MjcfUnits& units = model.compiler.units_of(tree.original);
    const auto [known, fresh] = compiler_.attached.emplace(tree.original.file(), units);
    if (!fresh && known->second != units) {
      // Units are stored by file: one file cannot have two.
      tree.original.fail("this file is part of two models with different angles; make a copy of it");
    }
    for (const files::XmlTree& child : tree.children) learn_units(child, model);
  }

  [[nodiscard]] const Model& model_of(const files::XmlElement& attach) {
    const std::string name = attach.attribute("model").value_or("");
    std::vector<std::string> known;
    for (const files::XmlElement& asset : root_.children("asset")) {
      for (const files::XmlElement& element : asset.children("model")) {
        const std::filesystem::path file = element.attribute("file").value_or("");
        const std::string own = element.attribute("name").value_or(file.stem().string());
        if (own == name) return opened(name, element, file);
        known.push_back(own);
      }
    }
    attach.fail(unknown_name("model", name, {known.begin(), known.end()}));
  }

  [[nodiscard]] const Model& opened(const std::string& name, const files::XmlElement& element,
                                    const std::filesystem::path& file) {
    if (const auto found = models_.find(name); found != models_.end()) return found->second;
    if (file.empty()) element.fail("model without a file; add file=\"...\"");
    if (depth_ == deepest) element.fail(fmt::format("models attach models more than {} times", deepest));
    const files::XmlElement other = file_.open(std::filesystem::path(root_.file()).parent_path() / file);
    if (other.tag() != "mujoco") other.fail("this is no MJCF file");
    for (auto& [word, line] : files::validate(other, mjcf_schema(), lenient_, description_.warnings)) {
      description_.unused.push_back({std::move(word), std::move(line)});
    }
    name_keys(other);
    Model model{other, read_compiler(other), outermost_class(other)};
    if (!same_masses(model.compiler, compiler_)) {
      other.fail("a model that is attached needs the settings of masses that the compiler of the file has");
    }
    MUROSIMF_ASSERT(depth_ < deepest);
    // Inside first: what the other file attaches and replicates is part of what is copied.
    Attachment(file_, other, model.compiler, lenient_, depth_ + 1, description_).attach();
    compiler_.attached.insert(model.compiler.attached.begin(), model.compiler.attached.end());
    expand_replicates(file_, other, model.compiler);
    return models_.emplace(name, std::move(model)).first->second;
  }

  void name_keys(const files::XmlElement& other) {
    for (const files::XmlElement& section : other.children("keyframe")) {
      const std::string word = "keyframe of an attached model";
      description_.unused.push_back({word, files::one_line(fmt::format("{}: {} is not used", section.where(), word))});
    }
  }

  files::XmlFile& file_;
  files::XmlElement root_;
  MjcfCompiler& compiler_;
  bool lenient_;
  int depth_;
  robot_formats::RobotDescription& description_;
  std::map<std::string, Model> models_;
  std::vector<files::XmlTree> added_;  // sections of the root
  std::size_t made_ = 0;               // elements
};

}  // namespace

void attach_models(files::XmlFile& file, const files::XmlElement& root, MjcfCompiler& compiler, bool lenient,
                   robot_formats::RobotDescription& description) {
  Attachment(file, root, compiler, lenient, 0, description).attach();
}

}  // namespace murosimf::robot_formats::mjcf

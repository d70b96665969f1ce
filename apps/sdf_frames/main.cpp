// murosimf-sdf-frames FILE MODEL - where the parts of a model in an SDF file stand, as libsdformat resolves it.
//
// A program of its own, since libsdformat costs every start of a program that is linked to it 18 ms, looks for files in the folder in
// which the program runs, writes a log into the home folder, and may give up on a file that is not as it should be. MODEL is the
// name of a model of the first world; empty: the model at the top of the file. Standard input: JSON, for each URI of an include the file
// that it means. Standard output: JSON, which murosimf/robot_formats/sdf/sdf_poses.cpp reads; poses are x, y, z [m] and w, x, y, z of a
// quaternion. Exit code 0 also if libsdformat finds errors: they are in the output.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>
#include <sdf/sdf.hh>
#include <unistd.h>

namespace {

using Json = nlohmann::json;
using Pose = std::decay_t<decltype(std::declval<const sdf::Link&>().RawPose())>;
using Vector = std::decay_t<decltype(std::declval<const Pose&>().Pos())>;

class Writer {
 public:
  explicit Writer(const std::map<std::string, std::string>& includes) : includes_(includes) {
    const auto find = [this](const std::string& uri) {
      const auto found = includes_.find(uri);
      return found == includes_.end() ? std::string{} : found->second;
    };
    config_.SetFindCallback(find);
    sdf::setFindCallback(find);  // libsdformat 12 asks this one for includes in files that are included
    config_.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
    config_.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);
    config_.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
  }

  Json write(const std::string& file, const std::string& model) {
    for (const auto& [uri, path] : includes_) {
      if (const std::string found = sdf::findFile(uri, true, true, config_); found != path)
        add_error("other", file, 0,
                  "libsdformat takes '" + found + "' for the include of '" + uri + "'; call it otherwise");
    }
    sdf::Root root;
    add(root.Load(file, config_));
    const sdf::Model* chosen = root.Model();
    if (!model.empty()) chosen = root.WorldCount() > 0 ? root.WorldByIndex(0)->ModelByName(model) : nullptr;
    if (chosen) add_model(*chosen, "", Pose::Zero);
    return std::move(all_);
  }

 private:
  void add_error(const char* kind, const std::string& file, int line, const std::string& message) {
    all_["errors"].push_back({{"kind", kind}, {"file", file}, {"line", line}, {"message", message}});
  }

  void add(const sdf::Errors& errors) {
    for (const sdf::Error& error : errors) {
      const auto code = error.Code();
      const bool is_uri = code == sdf::ErrorCode::URI_LOOKUP || code == sdf::ErrorCode::URI_INVALID;
      add_error(code == sdf::ErrorCode::LINK_INERTIA_INVALID ? "inertia"
                : is_uri                                     ? "uri"
                                                             : "other",
                error.FilePath().value_or(""), error.LineNumber().value_or(0), error.Message());
    }
  }

  static Json to_json(const Pose& pose) {
    const auto& p = pose.Pos();
    const auto& q = pose.Rot();
    return {p.X(), p.Y(), p.Z(), q.W(), q.X(), q.Y(), q.Z()};
  }

  /// In the frame of that name, or that of the parent.
  template <class Part>
  Pose pose_of(const Part& part, const std::string& frame = "") {
    Pose pose;
    add(part.SemanticPose().Resolve(pose, frame));
    return pose;
  }

  /// Poses of visuals, collisions or sensors in the frame of what they are in.
  template <class Owner, class Part>
  Json poses(const Owner& owner, std::uint64_t count, const Part* (Owner::*by_index)(std::uint64_t) const) {
    Json all = Json::object();
    for (std::uint64_t i = 0; i < count; ++i) {
      const Part& part = *(owner.*by_index)(i);
      // of sensors of joints libsdformat 12 knows no frames
      all[part.Name()] = to_json(part.PoseRelativeTo().empty() ? part.RawPose() : pose_of(part));
    }
    return all;
  }

  void add_link(const sdf::Link& link, const std::string& scope, const Pose& base) {
    Json& entry = all_["links"][scope + link.Name()];
    entry["pose"] = to_json(base * pose_of(link, "__model__"));
    entry["inertial"] = to_json(Pose::Zero);
    if (const sdf::ElementPtr element = link.Element(); element && element->HasElement("inertial")) {
      entry["inertial"] = to_json(element->GetElement("inertial")->Get<Pose>("pose"));
    }
    entry["visuals"] = poses(link, link.VisualCount(), &sdf::Link::VisualByIndex);
    entry["collisions"] = poses(link, link.CollisionCount(), &sdf::Link::CollisionByIndex);
    entry["sensors"] = poses<sdf::Link, sdf::Sensor>(link, link.SensorCount(), &sdf::Link::SensorByIndex);
  }

  static std::string scoped(const std::string& scope, const std::string& name) {
    return name == "world" ? name : scope + name;
  }

  void add_joint(const sdf::Joint& joint, const std::string& scope, const Pose& base) {
    Json& entry = all_["joints"][scope + joint.Name()];
    std::string parent, child;
    add(joint.ResolveParentLink(parent));
    add(joint.ResolveChildLink(child));
    entry["parent"] = scoped(scope, parent);
    entry["child"] = scoped(scope, child);
    const Pose pose = pose_of(joint, "__model__");
    entry["pose"] = to_json(base * pose);
    entry["axes"] = Json::array();
    for (unsigned int i = 0; i < 2; ++i) {
      const auto* axis = joint.Axis(i);
      if (!axis) continue;
      Vector direction;
      add(axis->ResolveXyz(direction, "__model__"));
      direction = base.Rot().RotateVector(direction);
      entry["axes"].push_back({direction.X(), direction.Y(), direction.Z()});
    }
    entry["sensors"] = poses<sdf::Joint, sdf::Sensor>(joint, joint.SensorCount(), &sdf::Joint::SensorByIndex);
  }

  void add_frame(const sdf::Frame& frame, const std::string& scope, const Pose& base) {
    std::string body;
    add(frame.ResolveAttachedToBody(body));
    all_["frames"].push_back({{"name", scope + frame.Name()},
                              {"body", scoped(scope, body)},
                              {"pose", to_json(base * pose_of(frame, "__model__"))}});
  }

  /// `base`: of the model in the one that is asked for.
  void add_model(const sdf::Model& model, const std::string& scope, const Pose& base) {
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) add_link(*model.LinkByIndex(i), scope, base);
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) add_joint(*model.JointByIndex(i), scope, base);
    for (std::uint64_t i = 0; i < model.FrameCount(); ++i) add_frame(*model.FrameByIndex(i), scope, base);
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& inner = *model.ModelByIndex(i);
      add_model(inner, scope + inner.Name() + "::", base * pose_of(inner, "__model__"));
    }
  }

  const std::map<std::string, std::string>& includes_;
  sdf::ParserConfig config_;
  Json all_{{"errors", Json::array()},
            {"links", Json::object()},
            {"joints", Json::object()},
            {"frames", Json::array()}};
};

}  // namespace

int main(int count, char** arguments) try {
  if (count != 3) {
    std::cerr << "murosimf-sdf-frames FILE MODEL; murosimf starts it\n";
    return 2;
  }
  unsetenv("HOME");  // no log
  unsetenv("SDF_PATH");
  if (chdir("/") != 0) return 3;  // where no includes are looked for by chance
  const std::string input{std::istreambuf_iterator<char>(std::cin), {}};
  const auto includes = Json::parse(input).get<std::map<std::string, std::string>>();
  std::cout << Writer(includes).write(arguments[1], arguments[2]).dump(-1, ' ', false, Json::error_handler_t::replace);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 4;
}

#include "murosimf/io/mjcf_body.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/io/mjcf_inertia.h"
#include "murosimf/io/mjcf_joint.h"
#include "murosimf/model/properties.h"

namespace murosimf::io {
namespace {

/// One object to come, with the joint it stands for.
struct Step {
  Object object;
  const MjcfJoint* joint = nullptr;
};

class BodyBuilder {
 public:
  explicit BodyBuilder(const MjcfContext& context) : context_(context) {}

  /// The base or the last object of a body: mass and shapes, then everything that hangs on it.
  void finish(Chain& chain, const XmlElement& body, const std::string& child_class) const {
    add_mass_and_shapes(chain, body, child_class);
    std::vector<Chain> branches;
    for (const XmlElement& child : body.children()) {
      if (child.tag() == "body") branches.push_back(build_body(child, child_class));
      if (child.tag() == "site") branches.push_back(build_site(child, child_class));
    }
    chain.fork(branches);
  }

 private:
  [[nodiscard]] Chain build_body(const XmlElement& body, const std::string& outer_class) const {
    const std::string child_class = context_.defaults.child_class(body, outer_class);
    if (!body.children("freejoint").empty()) {
      body.children("freejoint")[0].fail("freejoint inside the robot; only its base may be free");
    }
    std::vector<MjcfJoint> joints;
    for (const XmlElement& joint : body.children("joint")) joints.push_back(read_joint(joint, child_class, context_));
    Chain chain;
    for (const Step& step : name_last(steps(body, joints), body)) add(chain, step);
    if (chain.objects().back().is_joint()) add_alias(chain, body);
    finish(chain, body, child_class);
    return chain;
  }

  [[nodiscard]] std::vector<Step> steps(const XmlElement& body, const std::vector<MjcfJoint>& joints) const {
    MjcfAttributes attributes(body);
    attributes.overlay(body);
    const std::string& name = context_.names.of(body);
    const Vec3d offset = attributes.vector("pos", {});
    const Mat3d turn = read_orientation(attributes, context_.compiler);
    std::vector<Step> result;
    if (!is_zero(offset)) result.push_back({{Kind::translation, -1, offset, {}, name + ".offset", true}});
    if (!is_identity(turn)) result.push_back({{Kind::rotation, -1, {}, turn, name + ".turn", true}});
    for (const MjcfJoint& joint : joints) {
      const bool away = !is_zero(joint.anchor);
      if (away) result.push_back({{Kind::translation, -1, joint.anchor, {}, joint.name + ".anchor", true}});
      result.push_back({{joint.kind, -1, joint.axis, {}, joint.name}, &joint});
      if (away) result.push_back({{Kind::translation, -1, -joint.anchor, {}, joint.name + ".back", true}});
    }
    if (result.empty()) result.push_back({{Kind::translation, -1, {}, {}, {}}});
    return result;
  }

  /// The body's name for the last object, if it is no joint.
  [[nodiscard]] std::vector<Step> name_last(std::vector<Step> steps, const XmlElement& body) const {
    Object& last = steps.back().object;
    if (!steps.back().joint) last.name = free_name(body, ".body");
    last.structural = false;  // it is the body, and somebody may look at it
    return steps;
  }

  void add(Chain& chain, const Step& step) const {
    const Object& object = step.object;
    if (object.kind == Kind::translation) chain.translation(object.vector, object.name);
    if (object.kind == Kind::rotation) chain.rotation(object.turn, object.name);
    if (object.kind == Kind::revolute) chain.revolute(object.name, object.vector);
    if (object.kind == Kind::prismatic) chain.prismatic(object.name, object.vector);
    if (object.structural) chain.structural();
    if (step.joint) add_joint_constants(chain, *step.joint, context_);
  }

  void add_alias(Chain& chain, const XmlElement& body) const {
    if (chain.objects().back().name != context_.names.of(body)) chain.alias(free_name(body, ".body"));
  }

  /// Name of a body or site; with the suffix if a joint (or for a site, a body) has the same.
  [[nodiscard]] std::string free_name(const XmlElement& element, const char* suffix) const {
    const std::string& name = context_.names.of(element);
    const bool site = element.tag() == "site";
    if (!context_.names.is_joint(name) && !(site && context_.names.is_body(name))) return name;
    context_.warnings.push_back(
        one_line(fmt::format("{}: {} '{}' is called '{}{}' here, since a {} has the same name", element.where(),
                             element.tag(), name, name, suffix, context_.names.is_joint(name) ? "joint" : "body")));
    return name + suffix;
  }

  void add_mass_and_shapes(Chain& chain, const XmlElement& body, const std::string& child_class) const {
    std::vector<MassProperties> solids;
    Shapes shapes;
    const MjcfGeomContext geom_context{context_.compiler, context_.meshes, mass_from_geoms(body, context_.compiler),
                                       context_.lenient, context_.warnings};
    for (const XmlElement& element : body.children("geom")) {
      for (MjcfGeom& geom : read_geom(context_.defaults.resolve(element, child_class), geom_context)) {
        if (std::holds_alternative<Plane>(geom.placed.shape))
          element.fail("a plane cannot be part of a robot; use a box");
        geom.placed.surface.material = context_.table.surface(context_.names.of(body));
        shapes.push_back(geom.placed);
        solids.push_back(geom.solid);
      }
    }
    if (!shapes.empty()) chain.with(properties::shapes, shapes);
    const MassProperties total = read_mass(body, solids, context_.compiler, context_.warnings);
    if (total.mass > 0) {
      chain.with(properties::mass, total.mass);
      chain.with(properties::center_of_mass, total.center);
      chain.with(properties::inertia, total.inertia);
    } else if (chain.objects().back().is_joint() || chain.objects().back().kind == Kind::base) {
      context_.warnings.push_back(one_line(
          fmt::format("{}: body '{}' moves but has no mass; add an inertial", body.where(), context_.names.of(body))));
    }
  }

  [[nodiscard]] Chain build_site(const XmlElement& element, const std::string& child_class) const {
    const MjcfAttributes attributes = context_.defaults.resolve(element, child_class);
    const std::string name = free_name(element, ".site");
    const Vec3d offset = attributes.vector("pos", {});
    const Mat3d turn = read_orientation(attributes, context_.compiler);
    Chain chain;
    if (!is_zero(offset)) chain.translation(offset, name + ".offset").structural();
    if (!is_identity(turn)) chain.rotation(turn, name + ".turn").structural();
    chain.endpoint(name);
    if (is_sole(attributes)) chain.with(properties::sole, read_sole(attributes));
    return chain;
  }

  [[nodiscard]] bool is_sole(const MjcfAttributes& site) const {
    const std::string& name = context_.names.of(site.element());
    if (context_.table.names_soles()) return context_.table.is_sole(name);
    return name.ends_with("sole") && site.text("type") == "box";
  }

  [[nodiscard]] static Sole read_sole(const MjcfAttributes& site) {
    const bool box = site.text("type") == "box" && site.has("size");
    const auto size = box ? site.numbers("size", 2, 3) : std::vector<double>(2);
    if (!(size[0] > 0 && size[1] > 0)) {
      site.element().fail("a sole needs type=\"box\" and size=\"half_length half_width half_height\"");
    }
    return {size[0], size[1]};
  }

  const MjcfContext& context_;
};

}  // namespace

bool is_free_joint(const XmlElement& joint, const std::string& child_class, const MjcfDefaults& defaults) {
  if (joint.tag() == "freejoint") return true;
  return joint.tag() == "joint" && defaults.resolve(joint, child_class).text("type") == "free";
}

Chain build_robot(const XmlElement& base, const std::string& outer_class, const MjcfContext& context) {
  const std::string child_class = context.defaults.child_class(base, outer_class);
  Chain chain;
  chain.base(context.names.of(base));
  int joints = 0;
  for (const XmlElement& joint : base.children()) {
    if (joint.tag() != "joint" && joint.tag() != "freejoint") continue;
    if (++joints > 1) joint.fail("the base has a second joint; besides its free joint it can have none");
    if (const auto name = joint.attribute("name")) chain.alias(*name);
  }
  BodyBuilder(context).finish(chain, base, child_class);
  return chain;
}

}  // namespace murosimf::io

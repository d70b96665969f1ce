#include "murosimf/robot_formats/proto/proto_schema.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>

namespace murosimf::robot_formats::proto {
namespace {

using Words = std::vector<std::string_view>;

template <class List>
bool contains(const List& list, std::string_view word) {
  return std::ranges::find(list, word) != std::ranges::end(list);
}

constexpr std::array groups{"Group", "Pose", "Transform"};
constexpr std::array joints{"HingeJoint",  "HingeJointWithBacklash",
                            "Hinge2Joint", "Hinge2JointWithBacklash",
                            "SliderJoint", "BallJoint"};
constexpr std::array solids{"Solid",    "Robot",       "Accelerometer", "Altimeter",     "Camera",
                            "Charger",  "Compass",     "Connector",     "Display",       "DistanceSensor",
                            "Emitter",  "GPS",         "Gyro",          "InertialUnit",  "LED",
                            "Lidar",    "LightSensor", "Pen",           "Radar",         "RangeFinder",
                            "Receiver", "Speaker",     "TouchSensor",   "VacuumGripper", "VacuumCup"};
constexpr std::array scenery{"PointLight", "SpotLight", "DirectionalLight",   "Fog",
                             "Background", "Viewpoint", "WorldInfo",          "CadShape",
                             "Microphone", "Skin",      "TexturedBackground", "TexturedBackgroundLight"};
constexpr std::array parts{"Shape",
                           "Appearance",
                           "PBRAppearance",
                           "Material",
                           "ImageTexture",
                           "TextureTransform",
                           "Box",
                           "Capsule",
                           "Cone",
                           "Cylinder",
                           "ElevationGrid",
                           "IndexedFaceSet",
                           "IndexedLineSet",
                           "Mesh",
                           "Plane",
                           "PointSet",
                           "Sphere",
                           "Coordinate",
                           "Normal",
                           "TextureCoordinate",
                           "Color",
                           "Physics",
                           "Damping",
                           "HingeJointParameters",
                           "JointParameters",
                           "BallJointParameters",
                           "RotationalMotor",
                           "LinearMotor",
                           "PositionSensor",
                           "Brake",
                           "SolidReference",
                           "Slot",
                           "Track",
                           "Propeller",
                           "Muscle",
                           "Lens",
                           "LensFlare",
                           "Zoom",
                           "Focus",
                           "Recognition",
                           "ImmersionProperties",
                           "ContactProperties",
                           "Billboard"};

// Fields of Pose, Transform and all nodes derived from them.
const Words pose{"translation", "rotation", "scale", "children", "translationStep", "rotationStep"};
const Words solid{"name",           "model",          "description", "contactMaterial",   "immersionProperties",
                  "boundingObject", "physics",        "locked",      "radarCrossSection", "recognitionColors",
                  "linearVelocity", "angularVelocity"};
const Words robot{"controller",     "controllerArgs", "customData", "supervisor", "synchronization", "battery",
                  "cpuConsumption", "selfCollision",  "showWindow", "window",     "remoteControl",   "data"};
const Words joint_parameters{"position",        "axis",          "minStop", "maxStop", "springConstant",
                             "dampingConstant", "staticFriction"};
const Words hinge_parameters{
    "anchor", "suspensionSpringConstant", "suspensionDampingConstant", "suspensionAxis", "stopERP", "stopCFM"};
const Words motor{"name",        "acceleration", "consumptionFactor", "controlPID", "minPosition",
                  "maxPosition", "maxVelocity",  "multiplier",        "muscles",    "sound"};
const Words joint{"jointParameters", "device", "endPoint", "position"};
const Words joint2{"jointParameters2", "device2", "position2"};
const Words backlash{"startPoint", "backlash", "gearMass", "outputMass"};

Words joined(std::initializer_list<Words> lists) {
  Words all;
  for (const Words& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

const std::map<std::string_view, Words>& vocabulary() {
  static const std::map<std::string_view, Words> all{
      {"Group", {"children"}},
      {"Pose", pose},
      {"Transform", pose},
      {"Solid", joined({pose, solid})},
      {"Robot", joined({pose, solid, robot})},
      {"Physics",
       {"density", "mass", "centerOfMass", "inertiaMatrix", "damping", "bounce", "bounceVelocity", "coulombFriction",
        "forceDependentSlip", "orientation"}},
      {"HingeJoint", joint},
      {"SliderJoint", joint},
      {"Hinge2Joint", joined({joint, joint2})},
      {"HingeJointWithBacklash", joined({joint, backlash})},
      {"Hinge2JointWithBacklash", joined({joint, joint2, backlash})},
      {"JointParameters", joint_parameters},
      {"HingeJointParameters", joined({joint_parameters, hinge_parameters})},
      {"RotationalMotor", joined({motor, {"maxTorque"}})},
      {"LinearMotor", joined({motor, {"maxForce"}})},
      {"Box", {"size"}},
      {"Sphere", {"radius", "subdivision", "ico"}},
      {"Capsule", {"radius", "height", "subdivision", "bottom", "top", "side"}},
      {"Cylinder", {"radius", "height", "subdivision", "bottom", "top", "side"}},
  };
  return all;
}

}  // namespace

bool is_group(std::string_view type) { return contains(groups, type); }
bool is_joint(std::string_view type) { return contains(joints, type); }
bool is_solid(std::string_view type) { return contains(solids, type); }
bool is_scenery(std::string_view type) { return contains(scenery, type); }

bool is_base_node(std::string_view type) {
  return is_group(type) || is_joint(type) || is_solid(type) || is_scenery(type) || contains(parts, type);
}

const std::vector<std::string_view>* fields_of(std::string_view type) {
  const auto found = vocabulary().find(type);
  return found == vocabulary().end() ? nullptr : &found->second;
}

}  // namespace murosimf::robot_formats::proto

#include "murosimf/recording/rosbag2/ros_types.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::recording {
namespace {

struct RosType {
  std::string_view name, fields;
};

// Names of fields, their types and order: interface packages of ROS 2 (common_interfaces, rcl_interfaces, geometry2).
constexpr std::array ros_types{
    RosType{"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    RosType{"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
    RosType{"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    RosType{"std_msgs/String", "string data\n"},
    RosType{"std_msgs/ColorRGBA", "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"},
    RosType{"std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride\n"},
    RosType{"std_msgs/MultiArrayLayout", "std_msgs/MultiArrayDimension[] dim\nuint32 data_offset\n"},
    RosType{"std_msgs/Float64MultiArray", "std_msgs/MultiArrayLayout layout\nfloat64[] data\n"},
    RosType{"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    RosType{"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    RosType{"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
    RosType{"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    RosType{"geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
    RosType{"geometry_msgs/TransformStamped",
            "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
    RosType{"geometry_msgs/Wrench", "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n"},
    RosType{"geometry_msgs/WrenchStamped", "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n"},
    RosType{"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
    RosType{"sensor_msgs/JointState",
            "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"},
    RosType{"sensor_msgs/Imu",
            "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
            "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
            "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n"},
    RosType{"sensor_msgs/Image",
            "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\n"
            "uint8[] data\n"},
    RosType{"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
    RosType{"sensor_msgs/RegionOfInterest",
            "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n"},
    RosType{"sensor_msgs/CameraInfo",
            "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\nfloat64[] d\nfloat64[9] k\n"
            "float64[9] r\nfloat64[12] p\nuint32 binning_x\nuint32 binning_y\nsensor_msgs/RegionOfInterest roi\n"},
    RosType{"sensor_msgs/LaserScan",
            "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 "
            "time_increment\n"
            "float32 scan_time\nfloat32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities\n"},
    RosType{"rosgraph_msgs/Clock", "builtin_interfaces/Time clock\n"},
    RosType{"rcl_interfaces/Log",
            "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\nstring function\n"
            "uint32 line\n"},
    RosType{"visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"},
    RosType{"visualization_msgs/MeshFile", "string filename\nuint8[] data\n"},
    RosType{"visualization_msgs/Marker",
            "std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\ngeometry_msgs/Pose pose\n"
            "geometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\nbuiltin_interfaces/Duration lifetime\n"
            "bool frame_locked\ngeometry_msgs/Point[] points\nstd_msgs/ColorRGBA[] colors\nstring texture_resource\n"
            "sensor_msgs/CompressedImage texture\nvisualization_msgs/UVCoordinate[] uv_coordinates\nstring text\n"
            "string mesh_resource\nvisualization_msgs/MeshFile mesh_file\nbool mesh_use_embedded_materials\n"},
    RosType{"visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers\n"},
};

const RosType& find_type(std::string_view name) {
  const auto* const found = std::ranges::find(ros_types, name, &RosType::name);
  MUROSIMF_ASSERT(found != ros_types.end());
  return *found;
}

/// Adds the types of the fields that are no numbers and texts, depth first.
void add_contained(const RosType& type, std::vector<const RosType*>& all) {
  std::string_view left = type.fields;
  while (!left.empty()) {
    const std::string_view name = left.substr(0, left.find_first_of(" ["));
    left.remove_prefix(left.find('\n') + 1);
    if (name.find('/') == std::string_view::npos) continue;
    const RosType& field = find_type(name);
    if (std::ranges::find(all, &field) != all.end()) continue;
    all.push_back(&field);
    add_contained(field, all);
  }
}

}  // namespace

std::string ros_definition(std::string_view type) {
  const RosType& outer = find_type(type);
  std::string text(outer.fields);
  std::vector<const RosType*> contained;
  add_contained(outer, contained);
  for (const RosType* one : contained) text += fmt::format("{:=<80}\nMSG: {}\n{}", "", one->name, one->fields);
  return text;
}

}  // namespace murosimf::recording

#include "murosimf/recording/recording_schemas.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::recording {
namespace {

std::vector<MessageSchema> all_schemas() {
  return {
      message_schema("google.protobuf.Timestamp", "int64 seconds = 1; int32 nanos = 2;"),
      message_schema("google.protobuf.Duration", "int64 seconds = 1; int32 nanos = 2;"),

      // names and numbers as at docs.foxglove.dev/docs/sdk/schemas; tests/oracle compares them with Foxglove's package
      message_schema("foxglove.Vector3", "double x = 1; double y = 2; double z = 3;"),
      message_schema("foxglove.Point3", "double x = 1; double y = 2; double z = 3;"),
      message_schema("foxglove.Quaternion", "double x = 1; double y = 2; double z = 3; double w = 4;"),
      message_schema("foxglove.Pose", "foxglove.Vector3 position = 1; foxglove.Quaternion orientation = 2;"),
      message_schema("foxglove.Color", "double r = 1; double g = 2; double b = 3; double a = 4;"),
      message_schema("foxglove.KeyValuePair", "string key = 1; string value = 2;"),
      message_schema("foxglove.FrameTransform", R"(
        google.protobuf.Timestamp timestamp = 1;
        string parent_frame_id = 2;
        string child_frame_id = 3;
        foxglove.Vector3 translation = 4;
        foxglove.Quaternion rotation = 5;)"),
      message_schema("foxglove.FrameTransforms", "repeated foxglove.FrameTransform transforms = 1;"),
      message_schema("foxglove.ArrowPrimitive", R"(
        foxglove.Pose pose = 1;
        double shaft_length = 2;
        double shaft_diameter = 3;
        double head_length = 4;
        double head_diameter = 5;
        foxglove.Color color = 6;)"),
      message_schema("foxglove.CubePrimitive",
                     "foxglove.Pose pose = 1; foxglove.Vector3 size = 2; foxglove.Color color = 3;"),
      message_schema("foxglove.SpherePrimitive",
                     "foxglove.Pose pose = 1; foxglove.Vector3 size = 2; foxglove.Color color = 3;"),
      message_schema("foxglove.CylinderPrimitive", R"(
        foxglove.Pose pose = 1;
        foxglove.Vector3 size = 2;
        double bottom_scale = 3;
        double top_scale = 4;
        foxglove.Color color = 5;)"),
      message_schema("foxglove.LinePrimitive", R"(
        enum Type { LINE_STRIP = 0; LINE_LOOP = 1; LINE_LIST = 2; }
        Type type = 1;
        foxglove.Pose pose = 2;
        double thickness = 3;
        bool scale_invariant = 4;
        repeated foxglove.Point3 points = 5;
        foxglove.Color color = 6;
        repeated foxglove.Color colors = 7;
        repeated fixed32 indices = 8;)"),
      message_schema("foxglove.TriangleListPrimitive", R"(
        foxglove.Pose pose = 1;
        repeated foxglove.Point3 points = 2;
        foxglove.Color color = 3;
        repeated foxglove.Color colors = 4;
        repeated fixed32 indices = 5;)"),
      message_schema("foxglove.TextPrimitive", R"(
        foxglove.Pose pose = 1;
        bool billboard = 2;
        double font_size = 3;
        bool scale_invariant = 4;
        foxglove.Color color = 5;
        string text = 6;)"),
      message_schema("foxglove.ModelPrimitive", R"(
        foxglove.Pose pose = 1;
        foxglove.Vector3 scale = 2;
        foxglove.Color color = 3;
        bool override_color = 4;
        string url = 5;
        string media_type = 6;
        bytes data = 7;)"),
      message_schema("foxglove.SceneEntity", R"(
        google.protobuf.Timestamp timestamp = 1;
        string frame_id = 2;
        string id = 3;
        google.protobuf.Duration lifetime = 4;
        bool frame_locked = 5;
        repeated foxglove.KeyValuePair metadata = 6;
        repeated foxglove.ArrowPrimitive arrows = 7;
        repeated foxglove.CubePrimitive cubes = 8;
        repeated foxglove.SpherePrimitive spheres = 9;
        repeated foxglove.CylinderPrimitive cylinders = 10;
        repeated foxglove.LinePrimitive lines = 11;
        repeated foxglove.TriangleListPrimitive triangles = 12;
        repeated foxglove.TextPrimitive texts = 13;
        repeated foxglove.ModelPrimitive models = 14;)"),
      message_schema("foxglove.SceneEntityDeletion", R"(
        enum Type { MATCHING_ID = 0; ALL = 1; }
        google.protobuf.Timestamp timestamp = 1;
        Type type = 2;
        string id = 3;)"),
      message_schema("foxglove.SceneUpdate", R"(
        repeated foxglove.SceneEntityDeletion deletions = 1;
        repeated foxglove.SceneEntity entities = 2;)"),
      message_schema("foxglove.JointState", R"(
        string name = 1;
        optional double position = 2;
        optional double velocity = 3;
        optional double acceleration = 4;
        optional double effort = 5;)"),
      message_schema("foxglove.JointStates", R"(
        google.protobuf.Timestamp timestamp = 1;
        repeated foxglove.JointState joints = 2;)"),
      message_schema("foxglove.CompressedImage", R"(
        google.protobuf.Timestamp timestamp = 1;
        string frame_id = 4;
        bytes data = 2;
        string format = 3;)"),
      message_schema("foxglove.RawImage", R"(
        google.protobuf.Timestamp timestamp = 1;
        string frame_id = 7;
        fixed32 width = 2;
        fixed32 height = 3;
        string encoding = 4;
        fixed32 step = 5;
        bytes data = 6;)"),
      message_schema("foxglove.CameraCalibration", R"(
        google.protobuf.Timestamp timestamp = 1;
        string frame_id = 9;
        fixed32 width = 2;
        fixed32 height = 3;
        string distortion_model = 4;
        repeated double D = 5;
        repeated double K = 6;
        repeated double R = 7;
        repeated double P = 8;)"),
      message_schema("foxglove.Log", R"(
        enum Level { UNKNOWN = 0; DEBUG = 1; INFO = 2; WARNING = 3; ERROR = 4; FATAL = 5; }
        google.protobuf.Timestamp timestamp = 1;
        Level level = 2;
        string message = 3;
        string name = 4;
        string file = 5;
        fixed32 line = 6;)"),

      message_schema("murosimf.Contact", R"(
        foxglove.Vector3 point = 1;
        foxglove.Vector3 force = 2;
        uint32 ground_contact_of = 3;)"),
      message_schema("murosimf.Contacts", R"(
        google.protobuf.Timestamp timestamp = 1;
        repeated murosimf.Contact contacts = 2;)"),
      message_schema("murosimf.StateHash", R"(
        google.protobuf.Timestamp timestamp = 1;
        fixed64 hash = 2;)"),
      message_schema("murosimf.Outside", R"(
        google.protobuf.Timestamp timestamp = 1;
        string channel = 2;
        int64 time_ns = 3;
        uint32 kind = 4;
        bytes content = 5;)"),
      message_schema("murosimf.State", R"(
        google.protobuf.Timestamp timestamp = 1;
        fixed64 hash = 2;
        bytes state = 3;)"),
  };
}

}  // namespace

const MessageSchema& find_schema(const std::string& name) {
  // built once: parsing all types takes longer than writing a short recording
  static const std::vector<MessageSchema> schemas = all_schemas();
  const auto found = std::ranges::find(schemas, name, &MessageSchema::name);
  if (found == schemas.end()) throw SetupError(fmt::format("there is no type of messages '{}'", name));
  return *found;
}

std::string descriptors_of(const MessageSchema& schema) { return descriptor_set(schema, find_schema); }

}  // namespace murosimf::recording

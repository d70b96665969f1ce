/// mjcf_frame.h - settings of MJCF's `compiler` element, and orientations and angles that depend on them.
///
/// Orientations of MJCF map the axes of the element to those of its parent; five ways to write one:
/// quat (w x y z), axisangle (x y z angle), euler (order of `eulerseq`; lower case: about the moving axes, upper case:
/// about the fixed ones), xyaxes (x axis, then y axis made perpendicular to it), zaxis (shortest turn of z).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"

namespace murosimf::robot_formats::mjcf {

enum class InertiaFromGeom { never, always, if_missing };

/// Units of a file, and the meaning of its ranges.
struct MjcfUnits {
  double angle_unit = pi / 180.0;  ///< [rad] of one unit of the file
  std::string euler_sequence = "xyz";
  bool auto_limits = true;  ///< a range without `limited` counts
  bool operator==(const MjcfUnits&) const = default;
};

struct MjcfCompiler {
  MjcfUnits units;                            ///< of the file
  std::map<std::string, MjcfUnits> attached;  ///< of files that it attaches, by name (mjcf_attach.h)
  /// The units of the file that contains the element.
  [[nodiscard]] const MjcfUnits& units_of(const files::XmlElement& element) const {
    const auto other = attached.find(element.file());
    return other == attached.end() ? units : other->second;
  }

  InertiaFromGeom inertia_from_geom = InertiaFromGeom::if_missing;
  std::string mesh_folder;                 ///< folder of mesh files, relative to the MJCF file's folder
  std::string picture_folder;              ///< the same of files of textures
  bool strip_path = false;                 ///< only the last part of the path of a mesh or texture counts
  double first_group = 0, last_group = 5;  ///< inertiagrouprange: geoms of these groups make masses
  double least_mass = 0;                   ///< [kg] boundmass: no body is lighter
  double least_inertia = 0;                ///< [kg m^2] boundinertia: no principal moment is smaller
  double total_mass = 0;                   ///< [kg] settotalmass: masses and inertias are scaled to it; 0: as they are
  bool balance_inertia = false;            ///< an impossible inertia becomes a ball's of the same mean moment
};

/// Throws SetupError where a setting has an impossible value.
[[nodiscard]] MjcfCompiler read_compiler(const files::XmlElement& root);

/// The turn of an attribute "w x y z" of any length but zero; the identity if it is missing.
[[nodiscard]] Mat3d read_quaternion(const MjcfAttributes& attributes, std::string_view name);
/// Element axes to parent axes; the identity if the element has no orientation.
[[nodiscard]] Mat3d read_orientation(const MjcfAttributes& attributes, const MjcfCompiler& compiler);

/// The shortest turn that takes z to the direction of `axis` (any length but zero).
[[nodiscard]] Mat3d turn_of_z(const Vec3d& axis);

/// Whether a range or force range applies: `flag` is "true", "false" or "auto". Equal ends revoke the range of a class, if it is "auto".
[[nodiscard]] bool is_limited(const MjcfAttributes& attributes, std::string_view flag, std::string_view range,
                              const MjcfCompiler& compiler);

}  // namespace murosimf::robot_formats::mjcf

#include "murosimf/api/named_rows.h"

#include "murosimf/api/told.h"

namespace murosimf::api {

NamedRows named_rows(const Entity& robot, const JointRows& joints, const std::string& name, std::string_view kind,
                     std::vector<std::string> others) {
  const std::size_t dot = name.find('.');
  const bool of_object = dot != std::string::npos;
  NamedRows named;
  named.property = of_object ? name.substr(dot + 1) : name;
  const ColumnBase* column = robot.find(named.property);
  if (!column || column->numbers() == 0) {
    for (const auto& [property, known] : robot.columns()) {
      if (known->numbers() > 0) others.push_back(property);
    }
    throw_unknown(kind, name, {others.begin(), others.end()});
  }
  named.numbers = column->numbers();
  if (of_object) {
    const std::string object = name.substr(0, dot);
    const auto found = robot.model().find_object(object);
    if (!found) throw_unknown("object", object, robot.model().object_names());
    named.rows = {column->rows() == 1 ? 0 : static_cast<std::size_t>(*found)};
  } else if (column->rows() == 1) {
    named.rows = {0};
  } else {
    named.rows.assign(joints.objects.begin(), joints.objects.end());
  }
  return named;
}

}  // namespace murosimf::api

#include "murosimf/model/structural_objects.h"

#include "murosimf/model/properties.h"

namespace murosimf {

void update_structural(const Model& model, const ColumnStore& columns, int object) {
  if (!model.objects()[object].structural) return;
  const auto rows = [&]<class T>(const Property<T>& property) -> std::vector<T>* {
    ColumnBase* column = columns.find(property.name);
    return column ? &static_cast<Column<T>*>(column)->values : nullptr;
  };
  auto* r = rows(properties::position);
  auto* R = rows(properties::orientation);
  if (!r || !R) return;
  const FixedObject place = model.placement(object);
  const int link = model.tree().links[place.link].object;
  (*r)[object] = (*r)[link] + (*R)[link] * place.offset;
  (*R)[object] = place.turned ? (*R)[link] * place.turn : (*R)[link];
  auto* v = rows(properties::linear_velocity);
  auto* w = rows(properties::angular_velocity);
  if (!v || !w) return;
  (*w)[object] = (*w)[link];
  (*v)[object] = (*v)[link] + cross((*w)[link], (*r)[object] - (*r)[link]);
}

}  // namespace murosimf

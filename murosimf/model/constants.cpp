#include "murosimf/model/constants.h"

namespace murosimf {

template class ConstantColumn<double>;
template class ConstantColumn<Vec3d>;
template class ConstantColumn<SymMat3d>;

void ConstantTable::append(const ConstantTable& other, int offset) {
  for (const auto& [name, column] : other.columns_) {
    // branches of a fork may have the same properties
    auto& mine = columns_[name];
    if (mine) {
      mine->append(*column, offset);
    } else {
      mine = column->clone_shifted(offset);
    }
  }
}

void ConstantTable::refuse_type(const PropertyInfo& property) {
  throw SetupError("constant property '" + std::string(property.name) + "' is used with two types");
}

}  // namespace murosimf

#include "murosimf/world/access_guard.h"

#include <algorithm>
#include <utility>

#include "murosimf/world/access.h"

namespace murosimf {
namespace {

thread_local const AccessSet* stepping = nullptr;  // what the algorithm on this thread has declared

bool is_claimed(const ColumnBase& column) {
  return std::ranges::any_of(stepping->claimed(), [&](const Entity* entity) { return entity->columns().has(&column); });
}

}  // namespace

AccessGuard::AccessGuard(const AccessSet& access) noexcept : before_(std::exchange(stepping, &access)) {}

AccessGuard::~AccessGuard() { stepping = before_; }

bool may_read(const ColumnBase& column) noexcept {
  return !stepping || stepping->touches(&column) || is_claimed(column);
}

bool may_write(const ColumnBase& column) noexcept {
  return !stepping || stepping->writes(&column) || is_claimed(column);
}

}  // namespace murosimf

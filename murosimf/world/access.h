/// access.h - declared reads and writes of an algorithm, and whether two of them conflict.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "murosimf/world/entity.h"

namespace murosimf {

enum class AccessMode {
  read,   ///< another algorithm must write it
  input,  ///< read; has a start value, so that no algorithm needs to write it
  write,  ///< written; may be read too
};

struct Access {
  const Entity* entity = nullptr;
  const ColumnBase* column = nullptr;
  AccessMode mode = AccessMode::read;
};

class AccessSet {
 public:
  void add(const Access& access);
  /// Adds all columns of an entity, also those that no algorithm has requested yet: the algorithm executes others on it.
  void claim(const Entity& entity);
  /// Removes an entity that is destroyed.
  void forget(const Entity& entity);
  [[nodiscard]] bool claims(const Entity* entity) const;
  [[nodiscard]] const std::vector<const Entity*>& claimed() const { return claimed_; }
  [[nodiscard]] const std::vector<Access>& all() const { return all_; }
  [[nodiscard]] bool writes(const ColumnBase* column) const;
  [[nodiscard]] bool touches(const ColumnBase* column) const;

 private:
  std::vector<Access> all_;
  std::unordered_map<const ColumnBase*, std::uint8_t>
      modes_;  // one bit for each: robots that see all others have thousands
  std::vector<const Entity*> claimed_;
};

/// True if one writes what the other reads or writes, or claims an entity of which the other touches anything.
/// Reading the same column is no conflict.
[[nodiscard]] bool conflict(const AccessSet& a, const AccessSet& b);

/// An algorithm's name, for messages, and what it declared.
struct NamedAccess {
  std::string algorithm;
  const AccessSet* access = nullptr;
};

/// Throws SetupError if a column is read but written by no algorithm; it names the reader, the property and the entity,
/// and the algorithms that could have written it.
void check_every_read_is_written(const std::vector<NamedAccess>& algorithms);

}  // namespace murosimf

/// state_sections.h - bytes of a saved state: a line that says so, the hash of all that follows, then sections, each with its name, whether
/// it may be missing, and the number of its bytes.
///
/// Sections have names so that messages can say what does not fit. Of one name there may be several, always in the same order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf {

/// A section without its content.
struct SectionName {
  std::string name;
  bool optional = false;  ///< of an algorithm that only observes: a run may go on with others
};

class StateWriter {
 public:
  StateWriter();
  /// `content` is copied.
  void add(SectionName section, std::span<const std::byte> content);
  /// All of it; the writer is empty then.
  [[nodiscard]] std::vector<std::byte> finish();

 private:
  std::vector<std::byte> bytes_;
};

class StateReader {
 public:
  /// The bytes must outlive it. Throws SetupError if they are no state of this version, damaged, or not all there.
  explicit StateReader(std::span<const std::byte> bytes);

  /// Throws SetupError if the state lacks one of these sections, or has others, apart from optional ones.
  void check_names(const std::vector<SectionName>& own) const;
  /// The content of the next section of this name; none: there is none behind the one that was found last.
  [[nodiscard]] std::optional<std::span<const std::byte>> next(std::string_view name);

 private:
  struct Section : SectionName {
    std::span<const std::byte> bytes;
  };
  std::vector<Section> sections_;
  std::size_t next_ = 0;
};

}  // namespace murosimf

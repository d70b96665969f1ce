/// state_archive.h - the state of a simulation as bytes: one description of the state, for saving and for loading.
///
///     void Odometer::state(StateArchive& archive) { archive(distance_, falls_); }
///
/// The state of a class is described by its member `state(StateArchive&)`, or by a function `state(StateArchive&, T&)`
/// in its namespace; plain data without pointers are copied as bytes. So a state is valid for one version of the library
/// and for machines of one byte order. Padding bytes are unspecified, and would make equal states differ: data
/// with padding do not compile, and list their members one by one:
///
///     void state(StateArchive& archive, Step& step) {
///       auto& [number, length] = step;  // another member does not compile here
///       archive(number, length);
///     }
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace murosimf {

class StateArchive {
 public:
  /// Saves to the end of `bytes`, which stay the caller's.
  explicit StateArchive(std::vector<std::byte>& bytes) : saved_(&bytes) {}
  /// Loads from `bytes`, which must outlive it.
  explicit StateArchive(std::span<const std::byte> bytes) : left_(bytes) {}

  [[nodiscard]] bool loads() const { return !saved_; }
  /// Number of bytes that are not loaded yet.
  [[nodiscard]] std::size_t left() const { return left_.size(); }

  /// Saves the values or loads them, one after the other. Throws SetupError if the bytes end before that.
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }
  /// Saves or loads as many values as there are: throws SetupError if another number was saved. Their addresses do not change.
  template <class T>
  void elements(std::span<T> values) {
    check_count(values.size());
    all(values);
  }

 private:
  template <class T>
  void one(T& value);
  template <class T>
  void one(std::vector<T>& values);
  template <class T>
  void one(std::optional<T>& value);
  template <class A, class B>
  void one(std::pair<A, B>& values) {
    (*this)(values.first, values.second);
  }
  void one(std::string& text);
  template <class T>
  void all(std::span<T> values);
  /// The number of elements, each of at least `size` bytes, that are saved or come next.
  [[nodiscard]] std::size_t count(std::size_t number, std::size_t size);
  void check_count(std::size_t number);
  void raw(std::span<std::byte> bytes);

  std::vector<std::byte>* saved_ = nullptr;  // null: it loads
  std::span<const std::byte> left_;
};

// ---- definitions ----

template <class T>
inline constexpr bool is_plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// Reads every byte of a T; no constant expression if one belongs to no member.
template <class T>
consteval bool reads_every_byte() {
  int sum = 0;
  for (const unsigned char byte : std::bit_cast<std::array<unsigned char, sizeof(T)>>(T{})) sum += byte;
  return sum >= 0;
}

/// Of data that are plain (is_plain) and can be made in a constant expression.
template <class T>
concept WithoutPadding = std::is_trivially_copyable_v<T> &&
    (std::has_unique_object_representations_v<T> || requires { typename std::bool_constant<reads_every_byte<T>()>; });

template <class T>
void StateArchive::one(T& value) {
  if constexpr (requires { value.state(*this); }) {
    value.state(*this);
  } else if constexpr (requires { state(*this, value); }) {
    state(*this, value);
  } else {
    static_assert(is_plain<T>, "say what belongs to its state");
    static_assert(WithoutPadding<T>, "it has bytes between its members: say these one by one");
    raw(std::as_writable_bytes(std::span(&value, 1)));
  }
}

template <class T>
void StateArchive::one(std::vector<T>& values) {
  constexpr bool says_itself = requires(T & value, StateArchive & archive) { value.state(archive); };
  values.resize(count(values.size(), is_plain<T> && !says_itself ? sizeof(T) : 1));
  all(std::span(values));
}

template <class T>
void StateArchive::one(std::optional<T>& value) {
  bool there = value.has_value();
  one(there);
  if (!there) return value.reset();
  if (!value) value.emplace();
  one(*value);
}

template <class T>
void StateArchive::all(std::span<T> values) {
  constexpr bool described = requires(T & value, StateArchive & archive) { value.state(archive); }
  || requires(T & value, StateArchive & archive) { state(archive, value); };
  if constexpr (is_plain<T> && !described) {
    static_assert(WithoutPadding<T>, "it has bytes between its members: say these one by one");
    raw(std::as_writable_bytes(values));
  } else {
    for (T& value : values) one(value);
  }
}

}  // namespace murosimf

// SPDX-License-Identifier: GPL-3.0-or-later
// Result<T>: a value, or an Error that says where bad input stands and what to do about it.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace isograsp {

/// Why something could not be done, in words a user can act on. Parts that do not apply stay empty.
struct Error {
  enum class Code {
    bad_input,  ///< wrong usage, file or value: exit status 2
    failed      ///< the operation failed (device, disk, permission): exit status 1
  };
  Code code = Code::bad_input;
  std::string what;    ///< what is wrong
  std::string remedy;  ///< what to do
  std::string file;    ///< path as the user gave it
  int line = 0;        ///< 1-based; 0: no line
  std::string field;   ///< column or key

  /// "<file>:<line>: <field>: <what>; <remedy>", absent parts left out; printable().
  [[nodiscard]] std::string message() const;
};

/// A value of T or an Error; never both. T may be void.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}      // NOLINT: a value is a result
  Result(Error error) : content_(std::move(error)) {}  // NOLINT: an error is a result

  [[nodiscard]] bool ok() const noexcept { return content_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }

  /// @pre ok()
  [[nodiscard]] T& value() & {
    assert(ok());
    return std::get<0>(content_);
  }
  [[nodiscard]] const T& value() const& {
    assert(ok());
    return std::get<0>(content_);
  }
  /// By value: a reference would dangle in `for (auto& x : read().value())`.
  [[nodiscard]] T value() && {
    assert(ok());
    return std::get<0>(std::move(content_));
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// @pre !ok()
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return std::get<1>(content_);
  }

 private:
  std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: an error is a result

  [[nodiscard]] bool ok() const noexcept { return !error_.has_value(); }
  explicit operator bool() const noexcept { return ok(); }
  /// @pre !ok()
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace isograsp

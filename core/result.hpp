// SPDX-License-Identifier: GPL-3.0-or-later
// Result<T>: a value, or an Error that says where bad input stands and what to do about it.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/text.hpp"

namespace isograsp {

/// Why something could not be done, in words a user can act on. Made by refused() or failed()
/// alone:
///   return refused("is not a number"_text, "write one"_text).at(path, line, "mass_kg");
struct Error {
  enum class Code {
    bad_input,  ///< wrong usage, file or value: exit status 2
    failed      ///< the operation failed (device, disk, permission): exit status 1
  };
  Code code;
  Text what;                ///< what is wrong
  Text remedy;              ///< what to do; may be empty
  std::string file;         ///< path as the user gave it; empty: not about a file
  std::optional<int> line;  ///< 1-based
  std::string field;        ///< column, key or option; empty: not about a single one

  /// Where it stands.
  [[nodiscard]] Error at(std::string in_file, std::optional<int> in_line = std::nullopt,
                         std::string in_field = {}) &&;
  /// The column, key or option that is meant.
  [[nodiscard]] Error about(std::string in_field) &&;

  /// "<file>:<line>: <field>: <what>; <remedy>", absent parts left out; printable(). In English.
  [[nodiscard]] std::string message() const;

 private:
  Error(Code the_code, Text the_what, Text the_remedy)
      : code(the_code), what(std::move(the_what)), remedy(std::move(the_remedy)) {}
  friend Error refused(Text what, Text remedy);
  friend Error failed(Text what, Text remedy);
};

/// Wrong usage, file or value: what is wrong, and what to do about it.
[[nodiscard]] Error refused(Text what, Text remedy);
/// The operation failed (device, disk, permission): what went wrong, and what to do about it.
[[nodiscard]] Error failed(Text what, Text remedy);

/// message() as a text of its own.
[[nodiscard]] Text words_of(const Error& error);
/// message() in another language.
[[nodiscard]] std::string translated(const Error& error, const Language& language);

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

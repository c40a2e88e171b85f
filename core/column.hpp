// SPDX-License-Identifier: GPL-3.0-or-later
// A column of signals: each stands once, as a constant, with its name in files, what it means and
// in which axes. Code that writes or reads it uses that constant, so that a column cannot have two
// names. Here: the type, and the columns of every trial; other columns are defined beside their
// subject.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"

namespace isograsp {

/// A text of at most kRoom characters, put together while the program is compiled.
template <std::size_t kRoom>
class FixedText {
 public:
  constexpr FixedText() = default;
  /// The parts one after the other; too many characters do not compile.
  template <class... Parts>
  explicit constexpr FixedText(const Parts&... parts) {
    (append(std::string_view(parts)), ...);
  }
  constexpr operator std::string_view() const noexcept {
    return {letters_.data(), size_};
  }  // NOLINT

 private:
  constexpr void append(std::string_view part) {
    for (const char letter : part) letters_.at(size_++) = letter;
  }
  std::array<char, kRoom> letters_{};
  std::size_t size_ = 0;
};

/// What a column is: words in which a finger or an axis is put at its place. Put together while the
/// program is compiled.
class ColumnWords {
 public:
  constexpr ColumnWords() = default;
  constexpr ColumnWords(Words words) : english_(words.english()) {}  // NOLINT: words without places
  constexpr ColumnWords(Phrase<1> words, std::string_view value)
      : english_(words.english()), values_{value} {}
  constexpr ColumnWords(Phrase<2> words, std::string_view first, std::string_view second)
      : english_(words.english()), values_{first, second} {}
  [[nodiscard]] Text text() const;

 private:
  const char* english_ = "";
  std::array<std::string_view, 2> values_;
};

struct Column {
  FixedText<28> name;          ///< in files, with its unit: "thumb_fx_N"
  ColumnWords description;     ///< a sentence without a full stop
  std::string_view axes;       ///< one of kColumnAxes; empty: it has no direction in space
  std::string_view component;  ///< x, y, z, quat_w, quat_x, quat_y, quat_z; empty: none
  std::string_view body;       ///< what moves or is pressed: "thumb", "object"; empty: nothing

  constexpr operator std::string_view() const noexcept { return name; }         // NOLINT
  operator std::string() const { return std::string(std::string_view(name)); }  // NOLINT
  friend constexpr bool operator==(const Column& column, std::string_view text) noexcept {
    return std::string_view(column) == text;
  }
};

/// Their names, in order.
[[nodiscard]] std::vector<std::string> names_of(std::span<const Column> columns);

/// Axes by their short name, in words.
inline constexpr std::array<std::pair<std::string_view, Words>, 7> kColumnAxes{
    {{"contact",
      "of each finger's contact: z into the object (pressing is +z), x its tangent, y = "
      "z cross x; right-handed"_text},
     {"world", "the patient's screen: x right, y up, z out of the screen; right-handed"_text},
     {"platform", "of the device; the wrench is about its origin; right-handed"_text},
     {"hand", "of the hand, left hands mirrored: flexion (closing), radial, distal"_text},
     {"sensor", "of each finger's sensor as its maker defines them"_text},
     {"cameras", "of the cameras; with a left arm the world is reflected, x to -x"_text},
     {"link", "of the further segment as it lay in the first row of the link"_text}}};

/// The unit that a name ends with: "N" of "thumb_fx_N"; empty: a number without one.
[[nodiscard]] std::string_view unit_of(std::string_view column) noexcept;

/// Columns of every trial. A constant is called like its column: a search finds both.
namespace columns {

/// A column without a direction in space.
[[nodiscard]] constexpr Column plain(std::string_view name, ColumnWords description,
                                     std::string_view body = {}) {
  return {FixedText<28>(name), description, {}, {}, body};
}

inline constexpr Column t_s = plain("t_s", "Time since the trial began"_text);
inline constexpr Column task_time_s =
    plain("task_time_s", "The task's own clock, which stands still while paused"_text);
inline constexpr Column phase =
    plain("phase", "0 lead-in, 1 active, 2 transport, 3 hold, 4 paused, 5 done"_text);
inline constexpr Column lateness_s =
    plain("lateness_s", "From the instant of the grid to its record"_text);
inline constexpr Column compute_s = plain("compute_s", "Work on the frame before"_text);

}  // namespace columns

}  // namespace isograsp

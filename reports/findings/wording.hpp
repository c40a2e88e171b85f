// SPDX-License-Identifier: GPL-3.0-or-later
// What reports call days, hands, digits and measures, and how they write values: texts, so that the
// page is written in the language of the clinic (core/text.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/english.hpp"
#include "core/text.hpp"
#include "hand/arm_links.hpp"
#include "hand/finger.hpp"

namespace isograsp::reports {

[[nodiscard]] std::string language_code(const Language& language);  ///< ISO 639-1

/// "12 Mar 2026" of "2026-03-12", "12 Mar" without the year; what is no day stays as it is.
[[nodiscard]] Text day_words(const std::string& iso);
[[nodiscard]] Text day_of_year_words(const std::string& iso);

[[nodiscard]] Text side_words(std::optional<Hand> hand);  ///< "right", "both"
[[nodiscard]] Text hand_words(std::optional<Hand> hand);  ///< "right hand", "both hands"
[[nodiscard]] Text digit_words(Finger finger);
[[nodiscard]] Words link_words(ArmLink link);  ///< what turns: "forearm"

/// "Maximum grip above rest", with the channel where it has words.
[[nodiscard]] Text measure_title(std::string_view name, std::string_view channel);

/// In the printed unit, without it: "12.3".
[[nodiscard]] Number value_number(double value, const std::string& unit);
/// With the unit: "12.3 N", "45°"; a change has its sign.
[[nodiscard]] Text value_words(double value, const std::string& unit);
[[nodiscard]] Text change_words(double change, const std::string& unit);
[[nodiscard]] Text percent_words(double share);  ///< "87 %" of 0.87

inline constexpr const char* kNoValue = "\u2013";  ///< where a value would stand

[[nodiscard]] Text listed(const std::vector<Text>& parts);  ///< "a, b"
[[nodiscard]] Text apart(const std::vector<Text>& parts);   ///< "a; b"

/// Says texts and numbers in one language. The language must outlive it.
class Speaker {
 public:
  explicit Speaker(const Language& language) : language_(language) {}
  [[nodiscard]] std::string operator()(const Text& text) const {
    return translated(text, language_);
  }
  [[nodiscard]] std::string operator()(const Number& number) const {
    return language_.number(number.digits);
  }
  [[nodiscard]] const Language& language() const noexcept { return language_; }

 private:
  const Language& language_;
};

}  // namespace isograsp::reports

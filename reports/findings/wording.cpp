// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/wording.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

struct Day {
  unsigned month = 0;  ///< 1 to 12; 0: this is no day
  unsigned day = 0;
  std::string year;
};
Day day_of(const std::string& iso) {
  Day day;
  if (iso.size() < 10) return {};
  std::from_chars(iso.data() + 5, iso.data() + 7, day.month);
  std::from_chars(iso.data() + 8, iso.data() + 10, day.day);
  if (day.month > 12) return {};
  day.year = iso.substr(0, 4);
  return day;
}

Text with_unit(Number number, const std::string& unit) {
  const std::string printed = tasks::printed_unit(unit).text;
  if (printed.empty()) return "%1"_text(std::move(number));
  if (printed == "°") return "%1%2"_text(std::move(number), printed);
  return "%1\u00a0%2"_text(std::move(number), tasks::unit_words(printed));
}

}  // namespace

std::string language_code(const Language& language) {
  return translated("en"_text, language);  // each says its own
}

Text day_words(const std::string& iso) {
  static constexpr std::array kDays{
      "%1\u00a0Jan\u00a0%2"_text, "%1\u00a0Feb\u00a0%2"_text, "%1\u00a0Mar\u00a0%2"_text,
      "%1\u00a0Apr\u00a0%2"_text, "%1\u00a0May\u00a0%2"_text, "%1\u00a0Jun\u00a0%2"_text,
      "%1\u00a0Jul\u00a0%2"_text, "%1\u00a0Aug\u00a0%2"_text, "%1\u00a0Sep\u00a0%2"_text,
      "%1\u00a0Oct\u00a0%2"_text, "%1\u00a0Nov\u00a0%2"_text, "%1\u00a0Dec\u00a0%2"_text};
  const Day day = day_of(iso);
  if (day.month == 0) return "%1"_text(iso);
  return kDays[day.month - 1](day.day, day.year);
}

Text day_of_year_words(const std::string& iso) {
  static constexpr std::array kDays{"%1\u00a0Jan"_text, "%1\u00a0Feb"_text, "%1\u00a0Mar"_text,
                                    "%1\u00a0Apr"_text, "%1\u00a0May"_text, "%1\u00a0Jun"_text,
                                    "%1\u00a0Jul"_text, "%1\u00a0Aug"_text, "%1\u00a0Sep"_text,
                                    "%1\u00a0Oct"_text, "%1\u00a0Nov"_text, "%1\u00a0Dec"_text};
  const Day day = day_of(iso);
  if (day.month == 0) return "%1"_text(iso);
  return kDays[day.month - 1](day.day);
}

Text side_words(std::optional<Hand> hand) {
  if (!hand) return "both"_text;
  return hand == Hand::right ? "right"_text : "left"_text;
}
Text hand_words(std::optional<Hand> hand) {
  if (!hand) return "both hands"_text;
  return hand == Hand::right ? "right hand"_text : "left hand"_text;
}
Words link_words(ArmLink link) {
  static constexpr std::array<Words, kArmLinkCount> kWords{"forearm"_text, "wrist"_text,
                                                           "fingers"_text};
  return kWords[index_of(link)];
}

Text digit_words(Finger finger) {
  static constexpr std::array kDigits{"thumb"_text, "index"_text, "middle"_text};
  return kDigits[index_of(finger)];
}

Text measure_title(std::string_view name, std::string_view channel) {
  return tasks::words_of(name, channel).title;
}

Number value_number(double value, const std::string& unit) {
  return {tasks::format_value(value, unit)};
}
Text value_words(double value, const std::string& unit) {
  return with_unit(value_number(value, unit), unit);
}
Text change_words(double change, const std::string& unit) {
  return with_unit({tasks::format_change(change, unit)}, unit.starts_with("of ") ? "" : unit);
}
Text percent_words(double share) {
  return "%1\u00a0%"_text(std::lround(100.0 * share));
}

Text listed(const std::vector<Text>& parts) {
  return joined(parts, ", "_text);
}
Text apart(const std::vector<Text>& parts) {
  return joined(parts, "; "_text);
}

}  // namespace isograsp::reports

// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/records/patient_code.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace isograsp::storage {

namespace {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

int number_of(std::string_view digits) {
  int value = 0;
  for (const char c : digits) value = 10 * value + (c - '0');
  return value;
}

bool is_year(std::string_view digits) {
  return digits.size() == 2 ||
         (digits.size() == 4 && number_of(digits) >= 1900 && number_of(digits) <= 2099);
}

/// Day and month in either order.
bool is_day_and_month(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty() || a.size() > 2 || b.size() > 2) return false;
  const int x = number_of(a);
  const int y = number_of(b);
  return x >= 1 && y >= 1 && std::max(x, y) <= 31 && std::min(x, y) <= 12;
}

bool is_date(std::string_view a, std::string_view b, std::string_view c) {
  return (is_year(a) && is_day_and_month(b, c)) || (is_year(c) && is_day_and_month(a, b));
}

/// Dates such as 1980-05-12, 12-5-80, 19800512, 120580 anywhere between other characters.
bool holds_date(std::string_view code) {
  struct Run {
    std::size_t begin;
    std::string_view digits;
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i;
    while (end < code.size() && is_digit(code[end])) ++end;
    if (end > i) runs.push_back({i, code.substr(i, end - i)});
    i = end + 1;
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto d = runs[i].digits;
    if (d.size() == 8 && (is_date(d.substr(0, 4), d.substr(4, 2), d.substr(6, 2)) ||
                          is_date(d.substr(0, 2), d.substr(2, 2), d.substr(4, 4))))
      return true;
    if (d.size() == 6 && is_date(d.substr(0, 2), d.substr(2, 2), d.substr(4, 2))) return true;
    // Three runs with exactly one '-' between each.
    if (i + 2 < runs.size() && runs[i].begin + d.size() + 1 == runs[i + 1].begin &&
        code[runs[i + 1].begin - 1] == '-' &&
        runs[i + 1].begin + runs[i + 1].digits.size() + 1 == runs[i + 2].begin &&
        code[runs[i + 2].begin - 1] == '-' && is_date(d, runs[i + 1].digits, runs[i + 2].digits))
      return true;
  }
  return false;
}

}  // namespace

Result<void> check_patient_code(const std::string& code) {
  const auto refuse = [](Text what) {
    return refused(std::move(what),
                   "use a generated code of letters, digits and '-', such as P-0427"_text)
        .about("patient code");
  };
  if (code.size() < 2 || code.size() > 32)
    return refuse("has %1 characters instead of 2 to 32"_text(code.size()));
  if (!std::all_of(code.begin(), code.end(),
                   [](char c) { return is_digit(c) || is_letter(c) || c == '-'; }))
    return refuse("holds a character other than letters, digits and '-'"_text);
  if (std::none_of(code.begin(), code.end(), is_digit))
    return refuse("'%1' has no digit, so it could be a name or initials"_text(code));
  if (holds_date(code)) return refuse("'%1' holds what reads as a date"_text(code));
  return {};
}

}  // namespace isograsp::storage

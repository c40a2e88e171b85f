// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/date.hpp"

#include <algorithm>
#include <cstdio>

namespace isograsp {

std::optional<Date> date_from_iso(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00";
  if (text.size() != kForm.size()) return std::nullopt;
  int numbers[3] = {0, 0, 0};
  int* number = numbers;
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    if (kForm[i] == '-') {
      if (text[i] != '-') return std::nullopt;
      ++number;
    } else {
      if (text[i] < '0' || text[i] > '9') return std::nullopt;
      *number = 10 * *number + (text[i] - '0');
    }
  }
  const Date date{std::chrono::year{numbers[0]},
                  std::chrono::month{static_cast<unsigned>(numbers[1])},
                  std::chrono::day{static_cast<unsigned>(numbers[2])}};
  return date.ok() ? std::optional(date) : std::nullopt;
}

std::string iso_text(Date date) {
  char text[16];
  std::snprintf(text, sizeof text, "%04d-%02u-%02u", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  return text;
}

int days_between(Date first, Date second) {
  return static_cast<int>((std::chrono::sys_days(second) - std::chrono::sys_days(first)).count());
}

}  // namespace isograsp

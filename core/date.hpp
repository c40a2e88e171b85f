// SPDX-License-Identifier: GPL-3.0-or-later
// Calendar dates as people write them down: a day without a time of day or a place.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace isograsp {

using Date = std::chrono::year_month_day;

/// A day of the calendar in the ISO 8601 form 2026-03-05 and no other; nothing: no such day.
[[nodiscard]] std::optional<Date> date_from_iso(std::string_view text);
[[nodiscard]] std::string iso_text(Date date);
/// From `first` to `second`; negative if `second` lies before it. @pre both are days of the
/// calendar
[[nodiscard]] int days_between(Date first, Date second);

}  // namespace isograsp

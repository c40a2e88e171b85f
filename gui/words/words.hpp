// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and names in words that a therapist uses.
#pragma once

#include <QString>

#include "core/measure.hpp"
#include "session/platform/snapshot.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

/// "Tracking error (RMSE), force"; a measure that is not known here keeps its own name.
[[nodiscard]] QString measure_title(const Measure& measure);
/// "1.25 N"; without a value a dash.
[[nodiscard]] QString measure_value(const Measure& measure);
/// What there is to know beside the value: excluded samples, or why there is no value.
[[nodiscard]] QString measure_remark(const Measure& measure);
/// Three significant digits, no exponent.
[[nodiscard]] QString short_number(double value);
/// "2026-11-21 14:05" of an ISO 8601 time in UTC, in local time and the form of the language.
[[nodiscard]] QString local_time(const std::string& utc);
/// The time of the day of it, with its seconds: "14:05:32".
[[nodiscard]] QString local_clock(const std::string& utc);
/// The day of it.
[[nodiscard]] QString local_date(const std::string& utc);
/// One line: rate is kept, gaps, losses, lateness.
[[nodiscard]] QString health_line(const session::Snapshot& snapshot, double worst_lateness_s);
/// Several lines: period, lateness and work of the frames so far, and what real time was given.
[[nodiscard]] QString timing_details(const session::TimingSummary& timing, const Text& realtime);
/// "Push 12 %" of the grip; empty where it cannot be told.
[[nodiscard]] QString push_words(const session::NetPush& push);
/// How a trial ended.
[[nodiscard]] QString status_words(storage::TrialStatus status);

}  // namespace isograsp::gui

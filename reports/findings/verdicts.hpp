// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of a patient's primary measures: the clinic's stable people make the pool, the patient's
// own days are judged with it. Rules: docs/change.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/findings/measure_series.hpp"
#include "reports/findings/renewed.hpp"

namespace isograsp::reports {

/// Hands are pooled with hands that stand to their person in the same way; both together are
/// neither the affected one nor the other.
enum class HandStatus : std::uint8_t { affected, other, healthy };
/// Nothing: the affected side is not told.
[[nodiscard]] std::optional<HandStatus> hand_status(std::optional<storage::Side> affected,
                                                    std::optional<Hand> hand);

/// The days of the hands of that status. Days of different hands, stable times, frame rates, delays
/// of the device or visual gains make no pair. `censored`: a trial without value fails its day.
[[nodiscard]] std::vector<StableDays> stable_days(std::span<const storage::PooledValue> values,
                                                  HandStatus status, bool censored);

/// What verdicts of one patient are made from.
struct VerdictContext {
  storage::SessionStore& store;
  std::vector<storage::PrimaryMeasure> primaries;
  storage::PatientProfile profile;
  Renewal& renewal;   ///< of older values in pools
  bool part = false;  ///< only some of the patient's sessions are there: nothing is judged
};

/// Values of other people in the version of `query`; what cannot be brought to it is left out.
[[nodiscard]] Result<std::vector<storage::PooledValue>> renewed_values(
    Renewal& renewal, const storage::PoolQuery& query,
    Result<std::vector<storage::PooledValue>> values);

/// Null: the measure is no primary one of this task and hand.
[[nodiscard]] const storage::PrimaryMeasure* primary_of(const VerdictContext& context,
                                                        const TaskSection& section,
                                                        const std::string& name,
                                                        const std::string& channel);

/// Judges the primary measures among the series of `section`. `like`: a trial of them.
[[nodiscard]] Result<void> judge_section(const VerdictContext& context, const StoredTrial& like,
                                         const std::vector<ReportSession>& sessions,
                                         TaskSection& section);

}  // namespace isograsp::reports

// SPDX-License-Identifier: GPL-3.0-or-later
// The size of a hand as the database keeps it: a row of lengths of a right hand, so that the size
// of the other hand is the same row for this side (the mirror stands in
// virtual_hand/hand_model.hpp). Not real-time.
#pragma once

#include <optional>
#include <string>

#include "core/result.hpp"
#include "storage/records/records.hpp"
#include "storage/records/session_store.hpp"
#include "virtual_hand/hand_model.hpp"

namespace isograsp::session {

/// Axes and limits of every hand, and the size of one that was not measured: `hands/default` of the
/// library. Errors name `asked_by`, what it is for.
[[nodiscard]] Result<virtual_hand::HandModel> usual_hand(const std::string& library,
                                                         const std::string& asked_by);
/// Adds length and breadth of the hand, bases and links of its digits to `record`.
void add_hand_size(const virtual_hand::HandModel& hand, storage::PreparationRecord& record);
/// The hand of this size; axes and limits are those of `model`. Errors: a column is missing.
[[nodiscard]] Result<virtual_hand::HandModel> hand_of_size(const storage::PreparationRecord& record,
                                                           const virtual_hand::HandModel& model,
                                                           Hand side);

/// Where the size of a hand that cannot open comes from.
struct MeasuredHand {
  storage::PreparationRecord entry;  ///< its entry test, with its size
  std::string on_date;               ///< of that session, ISO 8601
};
/// The newest entry test of the patient's other hand than `side` in which its own size was
/// measured; nothing: there is none. A simulated hand tells nothing of a person, a recording
/// nothing of this one. Errors: whatever the database reports.
[[nodiscard]] Result<std::optional<MeasuredHand>> other_hand_measured(storage::SessionStore& store,
                                                                      storage::RowId patient,
                                                                      Hand side, bool simulated);

}  // namespace isograsp::session

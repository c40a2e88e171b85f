// SPDX-License-Identifier: GPL-3.0-or-later
// Free text in its column, bound to the column and to the person. Inside storage/ only.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "storage/access/login.hpp"

namespace isograsp::storage {

/// What stands in place of free text for a role that may not read it.
inline constexpr std::string_view kWithheld = "[withheld]";

/// The columns of free text: "table.column". Part of what a sealed text is bound to.
namespace sealed_column {
inline constexpr const char* kNotes = "patient_profiles.notes";
inline constexpr const char* kGoals = "patient_profiles.goals";
inline constexpr const char* kMarkText = "treatment_marks.text";
inline constexpr const char* kScoreText = "clinical_scores.text";
inline constexpr const char* kChosenBy = "primary_measures.chosen_by";
inline constexpr const char* kJudgedBy = "stable_periods.judged_by";
inline constexpr const char* kPeriodText = "stable_periods.text";
inline constexpr const char* kConsentText = "consents.text";
inline constexpr const char* kEventText = "events.text";  ///< of events of kind kSealedEvent
inline constexpr std::array kAll{kNotes,    kGoals,      kMarkText,    kScoreText, kChosenBy,
                                 kJudgedBy, kPeriodText, kConsentText, kEventText};
}  // namespace sealed_column
/// Other kinds hold the program's own words.
inline constexpr std::string_view kSealedEvent = "note";

// In place; nothing is done where the database is not protected, or to an empty text.
[[nodiscard]] Result<void> seal_text(const LoginState& state, std::string& text, const char* column,
                                     const std::string& code);
/// For a role that may not read it the text becomes kWithheld. Errors: locked; changed or damaged.
[[nodiscard]] Result<void> open_text(const LoginState& state, std::string& text, const char* column,
                                     const std::string& code, const std::string& path);
/// What a sealed text of a person is bound to. Capitals of codes do not matter.
[[nodiscard]] std::string place_of(const LoginState& state, const char* column,
                                   const std::string& code);

}  // namespace isograsp::storage

// SPDX-License-Identifier: GPL-3.0-or-later
// Free text and identities in their columns, each bound to the column, to the person and to what
// else its row says: carried into another row it cannot be opened. Inside storage/ only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "storage/access/login.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::storage {

/// What stands in place of free text for a role that may not read it.
inline constexpr std::string_view kWithheld = "[withheld]";

/// What a row says beside its sealed texts, value by value. No numbers of rows: they change when
/// files are merged.
using RowWords = std::vector<std::string>;
[[nodiscard]] std::string row_word(double value);  ///< its bits
[[nodiscard]] std::string row_word(std::optional<int> value);
[[nodiscard]] RowWords row_words(const PatientProfile& profile);
[[nodiscard]] RowWords row_words(const TreatmentMark& mark);
[[nodiscard]] RowWords row_words(const ClinicalScore& score);
[[nodiscard]] RowWords row_words(const PrimaryMeasure& primary);
[[nodiscard]] RowWords row_words(const StablePeriod& period);
[[nodiscard]] RowWords row_words(const EventPlace& place, const EventRecord& event);

struct SealedColumn {
  const char* name;   ///< "table.column"
  const char* words;  ///< SQL: the row_words() of row `x`
};
namespace sealed_column {
inline constexpr const char* kOfProfile =
    "x.affected, x.dominant, x.onset_date, x.sex, x.birth_year";
inline constexpr const char* kOfPeriod = "x.from_date, x.until_date, x.judged_utc";
inline constexpr SealedColumn kNotes{"patient_profiles.notes", kOfProfile};
inline constexpr SealedColumn kGoals{"patient_profiles.goals", kOfProfile};
inline constexpr SealedColumn kMarkText{"treatment_marks.text", "x.on_date, x.kind"};
inline constexpr SealedColumn kScoreText{"clinical_scores.text", "x.on_date, x.scale, x.value"};
inline constexpr SealedColumn kChosenBy{"primary_measures.chosen_by",
                                        "x.task_name, x.hand, x.measure, x.channel, x.chosen_utc"};
inline constexpr SealedColumn kJudgedBy{"stable_periods.judged_by", kOfPeriod};
inline constexpr SealedColumn kPeriodText{"stable_periods.text", kOfPeriod};
inline constexpr SealedColumn kConsentText{
    "consents.text", "x.on_date, x.purpose, x.basis, x.state, x.recorded_utc, x.recorded_by"};
inline constexpr SealedColumn kEventText{
    ///< of events of kind kSealedEvent
    "events.text",
    "s.uuid, (SELECT t.uuid FROM trials t WHERE t.id = x.trial_id), x.session_time_s"};
inline constexpr std::array kAll{kNotes,    kGoals,      kMarkText,    kScoreText, kChosenBy,
                                 kJudgedBy, kPeriodText, kConsentText, kEventText};
/// Not free text: it has a key of its own.
inline constexpr SealedColumn kIdentity{"identities.sealed", "x.changed_utc"};
}  // namespace sealed_column
/// Other kinds hold the program's own words.
inline constexpr std::string_view kSealedEvent = "note";

/// Where a text stands.
struct TextPlace {
  SealedColumn column;
  std::string code;  ///< of the person; capitals do not matter
  RowWords row;
};

/// First format whose texts are bound to their row; before they were to column and person alone.
inline constexpr int kBoundToRowFormat = 10;
/// What a sealed text of a file of format `format` is bound to.
[[nodiscard]] std::string bound_to(const LoginState& state, const TextPlace& place,
                                   int format = kBoundToRowFormat);

// In place; nothing is done where the database is not protected, or to an empty text.
[[nodiscard]] Result<void> seal_text(const LoginState& state, std::string& text,
                                     const TextPlace& place);
/// For a role that may not read it the text becomes kWithheld. Errors: locked; changed, damaged or
/// of another row. `database`: the file that it is of.
[[nodiscard]] Result<void> open_text(const LoginState& state, std::string& text,
                                     const TextPlace& place, const Database& database);
[[nodiscard]] Error changed_text(const TextPlace& place, const std::string& path);

/// A text that is not empty, as it stands in the file.
struct StoredText {
  RowId row = 0;
  std::string text;
  TextPlace place;
};
// In a transaction or guard of the caller; throw as SOCI does.
[[nodiscard]] std::vector<StoredText> stored_texts(soci::session& sql, const SealedColumn& column);
void replace_text(soci::session& sql, const StoredText& stored, const std::string& text);

/// Every sealed text of a file that has just got format 10 is opened as the formats before sealed
/// it and bound to its row. Throws a Refusal where one cannot be opened. @pre a transaction is
/// open, somebody is logged in who may read texts
void bind_texts_to_rows(Database& database, const LoginState& state);

/// The same of events `added` that an emergency file of a format before has brought: what does not
/// open so stays as it is, and what `database` had already is not added. @pre as above
void bind_notes_to_rows(Database& database, const LoginState& state, std::span<const RowId> added);

}  // namespace isograsp::storage

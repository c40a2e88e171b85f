// SPDX-License-Identifier: GPL-3.0-or-later
// Dates, scores and kinds of treatment: from what a therapist types to what is stored, and back.
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/date.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::gui {

/// What was typed: a value, or in words why it is none. Never both.
template <class T>
struct Typed {
  std::optional<T> value;
  QString problem;
};

[[nodiscard]] Date local_today();

enum class Ahead : bool { refused, allowed };  ///< days that have not come yet
/// 2026-03-05, 2026-3-5 and 5.3.2026; in a language that writes so, 5/3/2026. Other orders of day
/// and month are refused: nobody could tell them apart.
[[nodiscard]] Typed<Date> typed_date(const QString& text, Date today, Ahead ahead);
/// With comma or point; 1+ is 1.5 on the Modified Ashworth Scale.
[[nodiscard]] Typed<double> typed_score(const QString& text, const storage::ClinicalScale& scale);

/// "12 days since the onset."
[[nodiscard]] QString onset_words(Date onset, Date today);
/// "Botulinum toxin" of "botulinum_toxin"; an unknown one as it is.
[[nodiscard]] QString treatment_words(const std::string& kind);
/// "Action Research Arm Test" of "ARAT"; an unknown one as it is.
[[nodiscard]] QString scale_words(std::string_view scale);
/// "Action Research Arm Test: 0 to 57"
[[nodiscard]] QString range_words(const storage::ClinicalScale& scale);
/// "42", "31.5 s", "1+"
[[nodiscard]] QString score_words(const storage::ClinicalScore& score);

}  // namespace isograsp::gui

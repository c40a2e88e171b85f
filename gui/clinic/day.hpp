// SPDX-License-Identifier: GPL-3.0-or-later
// The day of the clinic: who is here or probably comes, and what a card says of each. Reading is
// for the worker.
#pragma once

#include <QDate>
#include <QString>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/findings/patient_verdicts.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

/// What speaks for a visit today. No appointments are stored.
enum class Visit : std::uint8_t {
  here,   ///< a session today, or added today
  usual,  ///< a session on this day of the week, one or two weeks ago
  none
};

struct PersonOfDay {
  storage::PatientRecord patient;
  std::optional<storage::SessionRecord> last;  ///< the newest session; nothing: none is known
  Visit visit = Visit::none;
};

/// Who is here first, then who probably comes, then all others; in each group who was seen, or
/// added, last stands first. `newest_first`: sessions of all.
[[nodiscard]] std::vector<PersonOfDay> in_order_of_day(
    const std::vector<storage::PatientRecord>& patients,
    const std::vector<storage::SessionRecord>& newest_first, const QDate& today);

/// What has to be read of one person.
struct DayCard {
  int sessions = 0;
  bool blank = false;  ///< nothing at all is stored of the person
  std::optional<storage::SessionRecord> last;
  /// A protocol that can be gone on with: when its first session began, ISO 8601; empty: there is
  /// none.
  std::string unfinished_since_utc;
  /// The first primary measure, its values and its verdict; nothing: none is chosen.
  std::optional<reports::PatientVerdict> primary;
  std::vector<std::string> protocols;  ///< that the person has followed, each once
  std::vector<std::string> marks;      ///< kinds of treatment, and what was written beside them
};
[[nodiscard]] Result<DayCard> read_day_card(storage::SessionStore& store,
                                            const storage::PatientRecord& patient,
                                            const std::string& now_utc);
/// The same without what takes long: for the search.
[[nodiscard]] Result<DayCard> read_what_finds(storage::SessionStore& store,
                                              const storage::PatientRecord& patient);

}  // namespace isograsp::gui

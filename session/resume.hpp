// SPDX-License-Identifier: GPL-3.0-or-later
// Continues an interrupted protocol: what was done of it is repeated to a new agenda.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "hand/arm_links.hpp"
#include "session/two_platforms/carries_begun.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/agenda.hpp"

namespace isograsp::session {

/// What was measured before still holds for this long [s]: the same half-day.
inline constexpr double kLongestBreak_s = 4.0 * 3600.0;

/// A completed trial of the protocol.
struct EarlierTrial {
  storage::TrialRecord record;
  std::vector<Measure> measures;
  double ended_s = 0.0;   ///< in the time of the session that resumes: not positive
  double lasted_s = 0.0;  ///< with its pauses
};

/// What an interrupted session, and those that it had resumed itself, did of their protocol.
struct EarlierWork {
  std::optional<storage::RowId> first_id;  ///< the session that began the protocol
  std::optional<storage::RowId> last_id;   ///< the newest one
  std::string allowed;              ///< outcome of its screening, as stored; empty: not asked
  std::optional<double> ceiling_N;  ///< of its screening
  OfHands<std::optional<double>> ceilings_N;  ///< the same of each of both hands
  std::optional<Hand> affected;               ///< side, of both hands; nothing: it was not known
  std::vector<PassiveLimit> passive;          ///< of its screening, of an arm
  std::vector<EarlierTrial> trials;           ///< in the order in which they were made
  CarriesBegun carries;                       ///< of both hands, trials that broke off included
  int placements = 0;                         ///< that a tracked hand began, likewise
  std::size_t trials_made = 0;                ///< broken ones included: no seed is used twice
};

/// The work that `session`, which has no row yet, can take up: that of the newest session of the
/// same patient, hand and kind of device. Refused where that followed another protocol, finished it
/// or began more than kLongestBreak_s ago.
[[nodiscard]] Result<EarlierWork> read_earlier_work(storage::SessionStore& store,
                                                    const storage::SessionRecord& session);

/// Tells a new agenda of the protocol what was done, up to the first act that was not. Tasks that
/// had been refused for this hand are told as such.
void tell(tasks::Agenda& agenda, const tasks::ProtocolSpec& protocol, const EarlierWork& earlier);

/// Orders the tasks of the protocol of `session`: the seed of its device or, without one, the
/// number of the session that began the protocol.
[[nodiscard]] std::uint64_t order_seed(const storage::SessionRecord& session,
                                       const EarlierWork& earlier);

/// Pain, also of the shoulder, of 4 or more, or of 2 more than at first, in words; nothing: work
/// may go on.
[[nodiscard]] std::optional<Text> reason_to_stop(const std::vector<storage::RatingRecord>& ratings);

}  // namespace isograsp::session

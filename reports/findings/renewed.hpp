// SPDX-License-Identifier: GPL-3.0-or-later
// A corrected measure does not interrupt a series: where a stored result is of an older version
// than this program's, reports and verdicts use the one that follows from the stored signals, and
// put it into the database beside the old one, so that it is computed once. What is stored stays as
// it is.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

/// Renews measures of the trials of one store. Trials whose newest results are all of this
/// program's versions cost nothing; of the others the signals are read and scored, and the results
/// kept: in the database, or, while that cannot be written, for the life of the program. The thread
/// of `store`.
class Renewal {
 public:
  explicit Renewal(storage::SessionStore& store) : store_(store) {}
  Renewal(const Renewal&) = delete;
  Renewal& operator=(const Renewal&) = delete;
  ~Renewal() { keep(); }

  /// The measures of `trial` of `patient` in the versions of this program, as far as its signals
  /// can be read. False: something is of an older version still.
  bool renew(storage::RowId patient, const storage::TrialRecord& trial,
             std::vector<Measure>& measures);
  /// The same for a row of a pool; reads its trial. Errors: whatever the database reports.
  [[nodiscard]] Result<void> renew(storage::PooledValue& value, const storage::PoolQuery& query);
  /// Puts what was computed into the database, if that can be written now.
  void keep();

  [[nodiscard]] int scored() const noexcept { return scored_; }    ///< trials that were read for it
  [[nodiscard]] int refused() const noexcept { return refused_; }  ///< trials that cannot be read

 private:
  [[nodiscard]] std::optional<std::vector<Measure>> scored(const storage::TrialRecord& trial);
  storage::SessionStore& store_;
  std::map<storage::RowId, std::vector<storage::TrialRecord>> trials_of_;  ///< by session, of pools
  std::vector<storage::ScoredTrial> to_keep_;                              ///< of `patient_`
  std::set<storage::RowId> seen_;  ///< trials that are or were in there
  storage::RowId patient_ = 0;
  bool can_keep_ = true;
  int scored_ = 0;
  int refused_ = 0;
};

/// "40 results of 12 trials are of a newer version …": what a report says of it in one line; empty:
/// nothing was renewed.
[[nodiscard]] Text renewal_words(int results, int trials);

/// Every measure of the patient's completed trials, renewed, oldest first.
[[nodiscard]] Result<std::vector<storage::MeasurePoint>> renewed_progress(
    storage::SessionStore& store, storage::RowId patient);

}  // namespace isograsp::reports

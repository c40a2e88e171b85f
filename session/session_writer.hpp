// SPDX-License-Identifier: GPL-3.0-or-later
// What one session writes, kept until its end: an ended trial is read back as another program would
// read it; and if the database is taken away, everything of the session is written anew into an
// emergency file (storage/care/emergency.hpp), where the session goes on to its end.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "storage/records/session_store.hpp"

namespace isograsp::session {

/// Rows of one second, per group of columns.
using SecondOfSignals = std::vector<std::vector<double>>;

/// A trial as another program reads it: by its path, through a new connection. An error names what
/// is not as it was given.
[[nodiscard]] Result<void> read_back(const std::string& database, const storage::TrialRecord& ended,
                                     std::span<const Measure> measures,
                                     std::span<const SecondOfSignals> seconds);

class SessionWriter {
 public:
  /// `session` has its row in `store`, with `answers`. `safe`: false for what is made for a moment:
  /// nothing is kept or read back.
  SessionWriter(std::unique_ptr<storage::SessionStore> store, storage::PatientRecord patient,
                storage::SessionRecord session, std::vector<storage::SessionAnswer> answers,
                bool safe);
  ~SessionWriter();

  // As SessionStore's, of this session. The first error says where the session is now, and what
  // failed and what follows goes there; a second one is the last. Row numbers stay those given
  // first; `id` is given with an error, too, where the row was written elsewhere; else it is 0.
  [[nodiscard]] Result<void> begin_trial(storage::TrialRecord trial, storage::RowId& id);
  [[nodiscard]] Result<void> append_blocks(storage::RowId trial, int second,
                                           const SecondOfSignals& rows);
  [[nodiscard]] Result<void> end_trial(const storage::TrialRecord& end,
                                       const std::vector<Measure>& measures);
  [[nodiscard]] Result<void> add_event(const storage::EventRecord& event);
  [[nodiscard]] Result<void> add_rating(const storage::RatingRecord& rating, storage::RowId& id);
  [[nodiscard]] Result<void> correct_rating(const storage::RatingRecord& rating);
  [[nodiscard]] Result<void> add_answers(const std::vector<storage::SessionAnswer>& answers);
  [[nodiscard]] Result<void> mark_helped(storage::RowId trial, bool helped);
  [[nodiscard]] Result<void> add_preparation(const storage::PreparationRecord& preparation,
                                             storage::RowId& id);
  /// Reads back every trial of the session once more. After a failure: keeps what a deleted file
  /// still holds.
  [[nodiscard]] Result<void> end_session(const std::string& ended_utc);
  /// Is the database still what was opened? Cheap; to be asked when nothing is written.
  [[nodiscard]] Result<void> look();
  /// Whether a lawful basis for a camera that sees the person stands, as the file says now; true
  /// where the file cannot be asked: that is look()'s affair. Cheap.
  [[nodiscard]] bool camera_is_allowed();

 private:
  /// Numbers of rows as they were given first, and in the store of now.
  struct Numbers {
    storage::RowId session = 0;
    std::map<storage::RowId, storage::RowId> trials;
    std::map<storage::RowId, storage::RowId> preparations;
    std::map<storage::RowId, storage::RowId> ratings;

    [[nodiscard]] storage::RowId of_trial(storage::RowId given) const {
      return here(trials, given);
    }
    [[nodiscard]] std::optional<storage::RowId> of_trial(
        std::optional<storage::RowId> given) const {
      return given ? std::optional(of_trial(*given)) : std::nullopt;
    }
    [[nodiscard]] storage::RowId of_rating(storage::RowId given) const {
      return here(ratings, given);
    }
    [[nodiscard]] storage::RowId of_preparation(storage::RowId given) const {
      return here(preparations, given);
    }
    /// One of another session is itself.
    [[nodiscard]] static storage::RowId here(const std::map<storage::RowId, storage::RowId>& rows,
                                             storage::RowId given) {
      const auto row = rows.find(given);
      return row == rows.end() ? given : row->second;
    }
  };
  using Operation = std::function<Result<void>(storage::SessionStore&, Numbers&)>;
  struct KeptTrial {
    std::string uuid;
    storage::TrialRecord end;
    std::vector<Measure> measures;
    std::vector<SecondOfSignals> seconds;
    bool ended = false;
  };

  [[nodiscard]] Result<void> perform(Operation operation);
  /// Writes everything anew. The error says what became of it.
  [[nodiscard]] Error go_to_emergency(const Error& why);
  [[nodiscard]] Result<void> write_anew(const std::string& path);
  [[nodiscard]] Result<void> read_back_all();
  void keep_whole();

  std::unique_ptr<storage::SessionStore> store_;
  std::unique_ptr<storage::SessionStore> left_;  ///< the database that was taken away
  storage::PatientRecord patient_;
  storage::SessionRecord session_;
  std::vector<storage::SessionAnswer> answers_;
  bool safe_;
  std::string database_id_;
  std::string emergency_path_;
  bool lost_ = false;  ///< nothing can be written any more, and it was said
  Numbers numbers_;
  std::vector<Operation> done_;
  std::map<storage::RowId, std::shared_ptr<KeptTrial>> trials_;
};

}  // namespace isograsp::session

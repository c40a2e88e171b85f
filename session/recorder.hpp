// SPDX-License-Identifier: GPL-3.0-or-later
// The recorder thread's work: frames from the ring become blocks of one second in the database; a
// finished trial is scored from what was recorded. Not real-time.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/ring.hpp"
#include "core/signals.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/session.hpp"
#include "session/session_writer.hpp"

namespace isograsp::session {

class Recorder {
 public:
  /// `session` has its row in the store. `live_score`: renew live_score() after every second of a
  /// trial.
  Recorder(std::unique_ptr<SessionWriter> writer, const storage::SessionRecord& session,
           Ring<RecordItem>& records, bool live_score);

  /// Takes all that waits in the ring; recorder thread. False once the device has finished.
  bool pump();
  /// Checks whether the database is still there; news if it is not. Recorder thread, from time to
  /// time.
  void look();
  /// From now on look() also asks whether a camera may still see the person; where not, the session
  /// fails and says so. Before the threads begin.
  void watch_basis(std::string database) { basis_in_ = std::move(database); }

  /// Owner thread.
  [[nodiscard]] std::vector<SessionNews> take_news();
  /// Waits until there is news or `seconds` have passed. Owner thread.
  void wait_for_news(double seconds);
  [[nodiscard]] std::vector<Measure> live_score() const;
  // These go to the database with the next pump().
  void add_event(const storage::EventRecord& event);     ///< of its trial, else of what runs
  void add_rating(const storage::RatingRecord& rating);  ///< after the newest trial
  /// Of the rating that was added last; its time is that of the correction.
  void correct_rating(const storage::RatingRecord& rating);
  void add_answers(const std::vector<storage::SessionAnswer>& answers);
  void mark_helped(storage::RowId trial, bool helped);
  /// Stored with the trial that ends next.
  void set_screen(const ScreenShown& screen);

  /// Closes the session's record. Owner thread, after the last pump().
  /// `session_time_s`: when it ended, in virtual time; nothing: now.
  void end_session(std::optional<double> session_time_s);
  /// Why not all of the session is in its database; nothing: it is.
  [[nodiscard]] std::optional<Error> failure() const;
  /// All of the session up to this moment is durable; ISO 8601. Owner thread.
  [[nodiscard]] std::string stored_until_utc() const;

 private:
  void take(const RecordItem& item);
  void take_remarks();
  void take_rating(storage::RatingRecord rating, bool corrects);
  void add_event(const RecordItem& item);
  void begin(TrialSetup& setup);
  void add_row(std::span<const double> values);
  void write_block();
  void end(const RecordItem& item);
  void add_preparation(const RecordItem& item);
  /// Of a rest trial that was completed.
  [[nodiscard]] std::optional<RestOutcome> add_rest(const RecordItem& item);
  /// Wall time of this moment of the session.
  [[nodiscard]] std::string utc_at(double session_time_s) const;
  void publish(SessionNews news);
  /// Reports a failed write once; what follows goes to the emergency file.
  bool stored(const Result<void>& result);
  /// All up to that time of the session, if it was.
  void stored_up_to(double session_time_s, const Result<void>& result);

  std::unique_ptr<SessionWriter> store_;
  storage::SessionRecord session_;
  std::size_t rows_per_block_;
  Ring<RecordItem>& records_;
  bool live_score_wanted_;
  std::optional<std::string> basis_in_;  ///< the file that says so; nothing: nobody is seen
  bool finished_ = false;
  RecordItem item_;

  TrialSetup* trial_ = nullptr;
  std::optional<storage::RowId> trial_id_;       ///< of the running trial
  std::optional<storage::RowId> last_trial_id_;  ///< that ended
  storage::RowId last_rating_id_ = 0;
  std::map<std::string, storage::RowId> in_force_;  ///< the newest preparation of each kind
  int second_ = 0;
  std::int64_t samples_ = 0;
  std::vector<std::vector<double>> block_;  ///< rows of each group, row-major
  Signals signals_;                         ///< the whole trial, for its score

  mutable std::mutex mutex_;  ///< guards what follows
  std::optional<Error> failure_;
  double stored_until_s_ = 0.0;  ///< in the time of the session
  std::condition_variable changed_;
  std::vector<SessionNews> news_;
  std::vector<Measure> live_;
  std::vector<storage::EventRecord> events_;
  struct Rating {
    storage::RatingRecord record;
    bool corrects = false;  ///< the one before
  };
  std::vector<Rating> ratings_;
  std::vector<storage::SessionAnswer> answers_;
  ScreenShown screen_;
  std::vector<std::pair<storage::RowId, bool>> helped_;
};

}  // namespace isograsp::session

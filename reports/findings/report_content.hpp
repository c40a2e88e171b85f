// SPDX-License-Identifier: GPL-3.0-or-later
// What a progress report says, independent of how it looks: PDF and HTML are written from
// the same content. SI units, radians; times of day in UTC.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "core/signals.hpp"
#include "core/text.hpp"
#include "hand/arm_links.hpp"
#include "hand/hands.hpp"
#include "reports/findings/change.hpp"
#include "reports/findings/compass.hpp"
#include "reports/findings/limits.hpp"
#include "reports/findings/norm_band.hpp"
#include "reports/findings/practice_dose.hpp"
#include "tasks/carry_forces.hpp"
#include "tasks/kinds/arm/pose_trial.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::reports {

/// Where forces came from. Results of different sources are never compared.
enum class Source : std::uint8_t { device, simulated, recorded };
[[nodiscard]] std::string_view name_of(Source source) noexcept;  ///< in files
[[nodiscard]] Words words_of(Source source) noexcept;

struct ReportSession {
  int number = 0;    ///< 1 is the first session of this patient
  std::string date;  ///< YYYY-MM-DD
  std::string started_utc;
  double day = 0.0;  ///< [d] from the first session to the first of the same day (comparable.hpp)
  std::optional<Hand> hand = Hand::right;  ///< nothing: both
  Source source = Source::device;
  std::string device;      ///< in words
  std::string provenance;  ///< of a recording; one line each
};

/// All completed trials of one session, practice and helped ones left out.
struct SessionValue {
  std::size_t session = 0;     ///< index into ReportContent::sessions
  std::vector<double> trials;  ///< in the order of the trials
  int without_value = 0;       ///< trials whose measure could not be computed
  std::optional<double> mean;  ///< none if a trial has no value: failures must not drop out of it
  bool first_day = false;      ///< the first assessment day of the task: drawn hollow
};

/// What may be said about the change of a primary measure (docs/change.md).
struct ChangeVerdict {
  ChangeJudgement change;
  int people = 0;         ///< whose stable pairs say how large the measurement error is
  int left_out = 0;       ///< of these pairs, as they lie far outside of the others
  Text reason;            ///< why it cannot be judged yet; empty: it can
  std::string chosen_by;  ///< who made it a primary measure
  std::string chosen_on;  ///< YYYY-MM-DD
  /// Even a fall to nothing would not be larger than measurement error.
  bool fall_cannot_be_told = false;
};

/// A practice trial: drawn hollow, part of no value.
struct PracticeValue {
  std::size_t session = 0;
  double value = 0.0;
};

/// One measure over the sessions; all values have the same task parameters and measure version.
struct MeasureSeries {
  std::string name;  ///< as stored
  std::string channel;
  std::string unit;
  int version = 1;
  bool key = false;  ///< stands in the table at a glance
  std::vector<SessionValue> values;
  std::optional<double> baseline;
  Text baseline_basis;         ///< what the baseline is the mean of
  std::optional<double> last;  ///< mean of the last day; none: it has no mean
  std::optional<double> change;
  Text trend;  ///< over all days, in words (series_trend.hpp); empty: too few
  std::vector<PracticeValue> practice;
  std::optional<ChangeVerdict> verdict;  ///< of primary measures; all others are shown without
  std::optional<NormBand> norm =
      std::nullopt;  ///< of key measures; nothing: nobody is like this person
};

/// A completed trial with what is needed to draw it.
struct DrawnTrial {
  std::size_t session = 0;
  int number = 0;
  Signals
      curves;  ///< t_s, phase, target_*, actual_*, of objects finger forces, of an arm its poses
  std::vector<Measure> measures;  ///< as stored
  Text problem;                   ///< why the signals cannot be shown
};

/// How targets with one posture went in the last session, in the trials that are compared.
struct PostureResult {
  std::string name;
  int asked = 0;
  int reached = 0;
  std::optional<double> median_s;  ///< nothing: longer than the limit
  // Nothing: not reached.
  std::optional<double> position_error_m;  ///< mean from reached to the next cue
  std::optional<double> angle_error_rad;
  std::optional<double> rotation_rad;  ///< of the object, median
  std::optional<double> unseen;        ///< share of the time, mean
};

/// From this session on a task was done under other conditions.
struct SeriesBreak {
  std::size_t session = 0;
  Text reason;  ///< "other visual gain"
};

/// The apparatus of tasks of an arm, … (KindFacts::apparatus).
inline constexpr std::string_view kArm = "arm";
inline constexpr std::string_view kTrackedHand = "tracked_hand";
inline constexpr std::string_view kTwoPlatforms = "two_platforms";

/// One task with one hand, or with both: sessions that may be compared with each other.
struct TaskSection {
  std::string task;
  int version = 1;
  std::optional<Hand> hand = Hand::right;  ///< nothing: both
  Source source = Source::device;
  std::optional<tasks::TaskSpec> spec;  ///< none: the stored task file cannot be read
  std::vector<MeasureSeries> series;
  std::optional<DrawnTrial> last;  ///< the newest
  std::optional<DrawnTrial> best;  ///< of a force task, by its first key measure
  std::optional<DrawnTrial> worst;
  std::vector<SeriesBreak> breaks;      ///< oldest first
  std::vector<PostureResult> postures;  ///< of a task with postures, in the order of the first cues
  /// Of a task with postures: the trials of the last session that are compared, one after the
  /// other.
  std::optional<tasks::PoseTrial> poses;
  /// Of healthy people, for `relative_rotation` of each link; nothing: nobody is like this person.
  std::array<std::optional<NormBand>, kArmLinkCount> link_shares;
  /// Of an arm what the body did; what was left out and why.
  std::vector<Text> notes;
};

/// A session in which a force was asked of the sum of both hands, however they shared it: means
/// over the trials that are compared. Nothing: not known.
struct HandsShared {
  std::size_t session = 0;
  std::string task;
  OfHands<std::optional<double>> above_rest_N;
  std::optional<Hand> affected;            ///< the values below are of it
  std::optional<double> share_percent;     ///< of the force
  std::optional<double> capacity_percent;  ///< of what both can do, by the maxima of that session
  std::optional<double> effort_percent;
  std::optional<double> lag_s;    ///< above 0: it follows the other hand
  std::optional<double> synergy;  ///< hand_synergy
};
/// A session in which both hands lifted something, or carried it: all its trials that are compared.
struct HandsMoved {
  std::size_t session = 0;
  std::string task;
  std::optional<tasks::HandsCarry> carry;  ///< how; nothing: it was lifted
  int done = 0;                            ///< lifted, or placed
  int asked = 0;
  int drops = 0;
  std::optional<double> time_s;         ///< of one, what was not done at the limit
  std::optional<double> tilt_rad;       ///< of what is lifted, RMS
  std::optional<double> raise_percent;  ///< share of the affected hand in raising
};
/// What both hands did together; both are empty where they never did.
struct BothHands {
  std::vector<HandsShared> shared;       ///< of one task, oldest first
  std::vector<HandsMoved> moved;         ///< of all tasks, oldest first
  std::vector<std::string> other_tasks;  ///< that ask for a sum, too
};

struct QualityLine {
  Text label;
  Text text;
  bool attention = false;  ///< limits what the results mean
};

struct ReportContent {
  std::string code;
  std::string software_version;
  std::vector<ReportSession> sessions;  ///< oldest first
  int sessions_stored = 0;              ///< of this patient: more, if only some were asked for
  std::vector<TaskSection> sections;
  std::vector<QualityLine> quality;  ///< of the last session
  bool simulated = false;            ///< any session is
  bool recorded = false;
  int primary_measures = 0;   ///< that have been chosen
  std::vector<Text> waiting;  ///< primary measures without any assessment, and why, in words
  std::string goals;          ///< in the patient's or therapist's words
  std::vector<storage::ClinicalScore> scores;      ///< by date
  std::vector<storage::TreatmentMark> treatments;  ///< by date
  LimitsOfHand limits;
  std::vector<Compass> compasses;
  PracticeDose dose;
  BothHands both_hands;
  bool early = false;       ///< the last session is less than six months after the onset
  std::string signing_key;  ///< public key of the clinic; empty: it has not signed anything yet
};

}  // namespace isograsp::reports

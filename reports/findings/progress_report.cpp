// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/progress_report.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "core/date.hpp"
#include "hand/arm_columns.hpp"
#include "hand/two_hands_columns.hpp"
#include "reports/findings/arm_findings.hpp"
#include "reports/findings/both_hands.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/data_quality.hpp"
#include "reports/findings/patient_records.hpp"
#include "reports/findings/renewed.hpp"
#include "reports/findings/task_section.hpp"
#include "reports/findings/wording.hpp"
#include "storage/access/signing.hpp"

namespace isograsp::reports {

namespace {

/// Change soon after the onset may be recovery that would have come anyway.
bool is_early(const std::string& onset_date, const std::string& session_date) {
  constexpr std::chrono::months kEarly{6};
  const auto onset = date_from_iso(onset_date);
  const auto session = date_from_iso(session_date);
  if (!onset || !session) return false;
  Date end = *onset + kEarly;
  if (!end.ok()) end = end.year() / end.month() / std::chrono::last;  // 31 August + 6 months
  return *session < end;
}

/// What both hands do to an object that they move together.
bool is_of_both_hands(std::string_view name) {
  if (name == columns::both_hold) return true;
  for (const Hand hand : kBothHands)
    if (name == columns::hand_end[hand][1] || name == columns::hand_push[hand][1] ||
        name == columns::hand_squeeze_N[hand])
      return true;
  return false;
}

/// A trial with the signals that are drawn; of tasks with targets for an object the finger forces,
/// too.
DrawnTrial drawn(storage::SessionStore& store, const StoredTrial& trial,
                 const TaskSection& section) {
  DrawnTrial drawn{trial.session, trial.trial.number, {}, trial.measures, {}};
  const bool fingers = section.spec && section.spec->kind->path_drawn;
  const bool arm = section.spec && section.spec->apparatus() == kArm;
  const bool both = section.spec && section.spec->apparatus() == kTwoPlatforms;
  const auto is_finger_force = [](const std::string& name) {
    for (const auto& axes : columns::finger_force)
      if (std::find(axes.begin(), axes.end(), name) != axes.end()) return true;
    return false;
  };
  auto signals = store.signals(trial.trial);
  if (!signals) {
    drawn.problem = "The signals of this trial cannot be read: %1"_text(words_of(signals.error()));
    return drawn;
  }
  for (const auto& name : signals->names()) {
    const bool shown = name == columns::t_s || name == columns::phase ||
                       name == columns::sample_flags || name.starts_with(columns::kTarget) ||
                       name.starts_with(columns::kActual) || (fingers && is_finger_force(name)) ||
                       (arm && !name.starts_with(columns::kMarker)) ||
                       name == columns::hand_grip.left || name == columns::hand_grip.right ||
                       name == columns::sum_force_N || (both && is_of_both_hands(name));
    if (!shown || drawn.curves.has(name)) continue;
    const auto column = signals->column(name);
    drawn.curves.add_column(name, {column.begin(), column.end()});
  }
  if (!drawn.curves.has(columns::t_s) || drawn.curves.rows() < 2)
    drawn.problem = "This trial holds no signals to draw."_text;
  return drawn;
}

/// The trials of the newest session that are compared with each other; the last of them is drawn.
void add_session_poses(storage::SessionStore& store, const std::vector<const StoredTrial*>& all,
                       TaskSection& section) {
  if (section.postures.empty() || !section.last) return;
  for (const StoredTrial* trial : all) {
    if (trial->session != section.last->session || !counts(trial->trial) ||
        !difference(*trial, *all.back()).empty())
      continue;
    // What cannot be read is said where the last trial is drawn.
    if (const auto signals = store.signals(trial->trial)) add_poses(section, *signals);
  }
  finish_postures(section);
}

void add_drawn_trials(storage::SessionStore& store, const std::vector<const StoredTrial*>& all,
                      TaskSection& section) {
  if (section.spec && section.spec->kind->research) return;  // nothing of it is drawn
  if (counts(all.back()->trial)) section.last = drawn(store, *all.back(), section);
  add_session_poses(store, all, section);
  for (Text& line : compensation_lines(section)) section.notes.push_back(std::move(line));
  const auto [best, worst] = extremes_of(section, all);
  if (best == nullptr) return;
  section.best = drawn(store, *best, section);
  section.worst = drawn(store, *worst, section);
}

/// What is known of the person and the course beside the tasks.
Result<void> add_course(storage::SessionStore& store, const PatientRecords& records,
                        ReportContent& content) {
  const storage::RowId id = records.patient.id;
  content.goals = records.profile.goals;
  auto scores = store.clinical_scores(id);
  if (!scores) return scores.error();
  content.scores = *std::move(scores);
  auto treatments = store.treatment_marks(id);
  if (!treatments) return treatments.error();
  content.treatments = *std::move(treatments);
  content.limits = limits_of(records, content.treatments);
  content.compasses = compasses_of(records);
  auto dose = dose_of(store, records);
  if (!dose) return dose.error();
  content.dose = *std::move(dose);
  return {};
}

/// Primary measures that no section shows, with the reason. In a part of the sessions nothing is
/// known of the others.
std::vector<Text> waiting_for(const std::vector<storage::PrimaryMeasure>& primaries,
                              const std::vector<TaskSection>& sections, bool part) {
  std::vector<Text> waiting;
  for (const auto& primary : primaries) {
    const auto shows = [&](const TaskSection& section) {
      return section.task == primary.task_name && section.hand == primary.hand &&
             std::any_of(section.series.begin(), section.series.end(), [&](const auto& series) {
               return series.name == primary.measure && series.channel == primary.channel;
             });
    };
    if (std::none_of(sections.begin(), sections.end(), shows))
      waiting.push_back((part ? "%1 (%2, %3), no assessment in these sessions"_text
                              : "%1 (%2, %3), no assessment yet"_text)(
          measure_title(primary.measure, primary.channel), Known{primary.task_name},
          hand_words(primary.hand)));
  }
  return waiting;
}

/// What a report of a part must say of itself; nothing: it is of all.
std::optional<QualityLine> period_of(const PatientRecords& records) {
  const int shown = static_cast<int>(records.sessions.size());
  if (shown == records.sessions_stored) return std::nullopt;
  if (shown == 0)
    return QualityLine{"Period"_text,
                       "none of the %1 sessions lies in it"_text(records.sessions_stored), true};
  const int first = records.first_number;
  return QualityLine{
      "Period"_text,
      "sessions %1 to %2 of %3 only: baselines and changes are those of this period"_text(
          first, first + shown - 1, records.sessions_stored),
      true};
}

/// Which results are not the stored ones, in one line.
void add_renewal(const PatientRecords& records, std::vector<QualityLine>& lines) {
  if (const auto words = renewal_words(records.renewed_results, records.renewed_trials);
      !words.empty())
    lines.push_back({"Newer measures"_text, words, false});
  const int trials = records.not_renewed_trials;
  if (trials == 1)
    lines.push_back(
        {"Older measures"_text,
         "1 trial measured by an older version cannot be read again and not be compared"_text,
         true});
  if (trials > 1)
    lines.push_back(
        {"Older measures"_text,
         "%1 trials measured by an older version cannot be read again and not be compared"_text(
             trials),
         true});
}

}  // namespace

std::string_view name_of(Source source) noexcept {
  switch (source) {
    case Source::simulated: return "simulated device";
    case Source::recorded: return "replayed recording";
    case Source::device: break;
  }
  return "device";
}

Words words_of(Source source) noexcept {
  switch (source) {
    case Source::simulated: return "simulated device"_text;
    case Source::recorded: return "replayed recording"_text;
    case Source::device: break;
  }
  return "device"_text;
}

Result<ReportContent> gather_progress(storage::SessionStore& store, const std::string& code,
                                      const Progress& progress, const ReportScope& scope) {
  // Shares of the time of sessions, last trials and quality, roughly.
  constexpr double kSessionsEnd = 0.3;
  constexpr double kTrialsEnd = 0.6;
  const auto between = [&](double from, double to) {
    return [&progress, from, to](double done, const Text& words) {
      return tell(progress, from + (to - from) * done, words);
    };
  };
  auto records = read_patient(store, code, between(0.0, kSessionsEnd), scope);
  if (!records) return records.error();
  ReportContent content;
  content.code = code;
  content.software_version = ISOGRASP_VERSION;
  if (const auto key = storage::public_key_of(store.path())) content.signing_key = *key;
  content.sessions = records->shown;
  if (const auto added = add_course(store, *records, content); !added) return added.error();
  content.sessions_stored = records->sessions_stored;
  const auto period = period_of(*records);
  if (period) content.quality.push_back(*period);
  add_renewal(*records, content.quality);
  for (const auto& session : records->sessions) {
    content.simulated = content.simulated || session.simulated;
    content.recorded = content.recorded || session.recorded;
  }
  content.primary_measures = static_cast<int>(records->primaries.size());
  content.early = !content.sessions.empty() &&
                  is_early(records->profile.onset_date, content.sessions.back().date);

  const auto tasks = sort_by_task(*records);
  Renewal renewal(store);
  const VerdictContext context{store, std::move(records->primaries), records->profile, renewal,
                               period.has_value()};
  const auto watch = between(kSessionsEnd, kTrialsEnd);
  for (const auto& [task, all] : tasks) {
    const std::size_t index = content.sections.size();
    if (!watch(static_cast<double>(index) / static_cast<double>(tasks.size()),
               "task %1 of %2"_text(index + 1, tasks.size())))
      return cancelled();
    auto section = make_section(context, all, content.sessions);
    if (!section) return section.error();
    add_drawn_trials(store, all, *section);
    add_both_hands(*section, all, content.both_hands);
    content.sections.push_back(*std::move(section));
  }
  put_in_order(content.sections, content.sessions);
  finish_both_hands(content.both_hands);
  content.waiting = waiting_for(context.primaries, content.sections, context.part);
  if (records->sessions.empty()) return content;
  const storage::SessionRecord& last = records->sessions.back();
  std::vector<storage::TrialRecord> last_trials;
  for (const auto& one : records->trials)
    if (one.session_record == &last) last_trials.push_back(one.trial);
  auto quality = assess_quality(store, last, last_trials, between(kTrialsEnd, 1.0));
  if (!quality) return quality.error();
  content.quality.insert(content.quality.end(), quality->begin(), quality->end());
  return content;
}

}  // namespace isograsp::reports

// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/data_quality.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "hand/columns.hpp"
#include "hand/platform_records.hpp"
#include "reports/findings/report_content.hpp"
#include "reports/findings/wording.hpp"
#include "tasks/score.hpp"

namespace isograsp::reports {

namespace {

Number two_digits(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2g", value);
  return {text};
}
Text share(std::int64_t part, std::int64_t whole) {
  if (part == 0) return "none"_text;
  return "%1 %"_text(two_digits(100.0 * static_cast<double>(part) / static_cast<double>(whole)));
}

/// What is seen only in the signals of a session.
struct SignalFacts {
  std::int64_t rows = 0;
  std::int64_t held = 0;
  std::int64_t missing = 0;
  std::int64_t beyond_range = 0;
  std::int64_t compared = 0;  ///< measures computed again
  std::vector<Text> differing;
  std::vector<Text> damaged;
};

/// Stored values were computed by the same functions; libm may differ by CPU in the last digits.
bool agree(const Measure& stored, const Measure& again) {
  constexpr double kLibmSlack = 1e-12;
  if (stored.value.has_value() != again.value.has_value()) return false;
  if (!stored.value) return true;
  return std::abs(*stored.value - *again.value) <=
         kLibmSlack * std::max(std::abs(*stored.value), std::abs(*again.value));
}

Result<void> compare_measures(storage::SessionStore& store, const storage::TrialRecord& trial,
                              const Signals& signals, SignalFacts& facts) {
  const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
  if (!spec) return {};
  const auto stored = store.measures(trial.id);
  if (!stored) return stored.error();
  if (stored->empty()) return {};
  const auto again = tasks::score(*spec, signals);
  for (const auto& measure : *stored) {
    const auto same = std::find_if(again.begin(), again.end(), [&](const Measure& candidate) {
      return candidate.name == measure.name && candidate.channel == measure.channel &&
             candidate.version == measure.version;
    });
    if (same == again.end()) continue;  // scored by another version of the measure
    ++facts.compared;
    if (!agree(measure, *same))
      facts.differing.push_back("%1 of trial %2"_text(measure.name, trial.number));
  }
  return {};
}

Result<SignalFacts> read_signals(storage::SessionStore& store,
                                 const std::vector<storage::TrialRecord>& trials,
                                 const Progress& progress) {
  SignalFacts facts;
  double passed = 0.0;
  for (const auto& trial : trials) {
    if (!tell(progress, passed++ / static_cast<double>(trials.size()),
              "checking trial %1"_text(trial.number)))
      return cancelled();
    const auto signals = store.signals(trial);
    if (!signals) {
      facts.damaged.push_back("trial %1: %2"_text(trial.number, signals.error().what));
      continue;
    }
    for (const double flags : signals->column(columns::sample_flags)) {
      const auto bits = static_cast<std::uint8_t>(flags);
      ++facts.rows;
      if (bits & bit(SampleFlag::held)) ++facts.held;
      if (bits & bit(SampleFlag::missing)) ++facts.missing;
      if (bits & (bit(SampleFlag::saturated) | bit(SampleFlag::overload))) ++facts.beyond_range;
    }
    if (auto done = compare_measures(store, trial, *signals, facts); !done) return done.error();
  }
  return facts;
}

/// A count in what a file says; 0 if it says no such thing.
std::int64_t count_at(const nlohmann::json& json, std::string_view key) {
  constexpr std::int64_t kMost = std::int64_t{1} << 50;
  const auto at = json.find(key);
  if (at == json.end() || !at->is_number_integer()) return 0;
  return std::clamp(at->get<std::int64_t>(), std::int64_t{0}, kMost);
}

std::int64_t lost_in(const nlohmann::json& health) {
  std::int64_t lost = count_at(health, "kernel_drops");
  for (const std::string_view part : {kFingerNames[0], kFingerNames[1], kFingerNames[2],
                                      std::string_view("cameras"), std::string_view("tracker")})
    if (const auto sensor = health.find(part); sensor != health.end() && sensor->is_object())
      lost += count_at(*sensor, "lost");
  return lost;
}

/// Frames lost between sensor and computer: counters at the end of the session's last trial; of two
/// platforms those of both.
std::int64_t lost_on_the_wire(const std::vector<storage::TrialRecord>& trials) {
  if (trials.empty()) return 0;
  const auto health = nlohmann::json::parse(trials.back().health_json, nullptr, false);
  if (!health.is_object()) return 0;
  std::int64_t lost = lost_in(health);
  for (const Hand hand : kBothHands)
    if (const auto side = health.find(name_of(hand)); side != health.end() && side->is_object())
      lost += lost_in(*side);
  return lost;
}

/// The noisiest axis of force of a zero, or of both.
double noise_of_zero_N(const storage::PreparationRecord& zero) {
  double noise_N = 0.0;
  for (std::size_t k = 0; k < std::min(zero.columns.size(), zero.sd.size()); ++k)
    if (unit_of(zero.columns[k]) == "N") noise_N = std::max(noise_N, zero.sd[k]);
  return noise_N;
}

QualityLine zero_line(const storage::SessionRecord& session,
                      const std::vector<storage::PreparationRecord>& preparations) {
  std::vector<double> noises_N;  // of each zero
  for (const auto& one : preparations)
    if (one.kind == platform::kInstrumentZero || one.kind == platform::kTwoInstrumentZeros)
      noises_N.push_back(noise_of_zero_N(one));
  if (session.recorded && noises_N.empty())
    return {"Instrument zero"_text, "as in the recording; it cannot be repeated"_text, true};
  if (noises_N.empty())
    return {"Instrument zero"_text, "not done: forces contain the sensor's offset"_text, true};
  const double noise_N = noises_N.back();
  if (noises_N.size() == 1)
    return {
        "Instrument zero"_text,
        "done with the device empty; empty noise %1 N (SD, largest axis)"_text(two_digits(noise_N)),
        false};
  return {"Instrument zero"_text,
          "done with the device empty, %1 times; empty noise %2 N (SD, largest axis)"_text(
              noises_N.size(), two_digits(noise_N)),
          false};
}

/// An arm is held still instead; an instrument zero it has none.
std::optional<QualityLine> start_posture_line(
    const std::vector<storage::PreparationRecord>& preparations) {
  const storage::PreparationRecord* newest = nullptr;
  for (const auto& one : preparations)
    if (one.kind == "start_posture") newest = &one;
  if (newest == nullptr) return std::nullopt;
  const auto sd_m = storage::value_of(newest->references, "largest_sd_m");
  if (!sd_m) return QualityLine{"Start posture"_text, "held still"_text, false};
  constexpr double kMillimetres = 1000.0;
  return QualityLine{
      "Start posture"_text,
      "held still; largest wander of a link %1 mm (SD)"_text(two_digits(kMillimetres * *sd_m)),
      false};
}

/// A tracked hand shows at rest that it is seen, and that it opens.
QualityLine entry_line(const std::vector<storage::PreparationRecord>& preparations) {
  const storage::PreparationRecord* newest = nullptr;
  for (const auto& one : preparations)
    if (one.kind == "hand_entry") newest = &one;
  if (newest == nullptr)
    return {"Entry test of the hand"_text, "not passed, or not done"_text, true};
  constexpr double kMillimetres = 1000.0;
  constexpr double kPercent = 100.0;
  const double opening_m = storage::value_of(newest->references, "opening_m").value_or(0.0);
  const double seen = storage::value_of(newest->references, "tracked_share").value_or(0.0);
  return {"Entry test of the hand"_text,
          "opening %1 mm; seen %2 % of the time at rest"_text(fixed(kMillimetres * opening_m, 0),
                                                              fixed(kPercent * seen, 0)),
          false};
}

/// The apparatus of a session: that of the first task which needs one.
std::string apparatus_of(const std::vector<storage::TrialRecord>& trials) {
  for (const auto& trial : trials) {
    const auto spec = tasks::parse_task(trial.task_text, trial.task_name);
    if (spec && !spec->apparatus().empty()) return std::string(spec->apparatus());
  }
  return "";
}

/// What stands before the work of a session.
QualityLine preparation_line(const std::string& apparatus, const storage::SessionRecord& session,
                             const std::vector<storage::PreparationRecord>& preparations) {
  if (apparatus == kTrackedHand) return entry_line(preparations);
  if (apparatus != kArm) return zero_line(session, preparations);
  return start_posture_line(preparations)
      .value_or(QualityLine{"Start posture"_text, "not taken"_text, true});
}

QualityLine picture_line(const SignalFacts& facts, std::int64_t recorder_drops, std::int64_t lost) {
  const auto words =
      facts.rows == 1
          ? "object out of sight %1, its last pose stood in %2 of %3 picture; lost on the way %4, not recorded %5"_text
          : "object out of sight %1, its last pose stood in %2 of %3 pictures; lost on the way %4, not recorded %5"_text;
  constexpr double kNoticeable = 0.1;  // of the pictures: an arm turns away as it moves
  return {"Samples"_text,
          words(share(facts.missing, facts.rows), share(facts.held, facts.rows), facts.rows, lost,
                recorder_drops),
          static_cast<double>(facts.missing + facts.held) >
                  kNoticeable * static_cast<double>(facts.rows) ||
              recorder_drops > 0};
}

QualityLine sample_line(const SignalFacts& facts, std::int64_t recorder_drops, std::int64_t lost) {
  const auto words =
      facts.rows == 1
          ? "missing %1, held %2, beyond range %3 of %4 sample; lost on the way %5, not recorded %6"_text
          : "missing %1, held %2, beyond range %3 of %4 samples; lost on the way %5, not recorded %6"_text;
  const Text text = words(share(facts.missing, facts.rows), share(facts.held, facts.rows),
                          share(facts.beyond_range, facts.rows), facts.rows, lost, recorder_drops);
  constexpr double kNoticeable = 0.01;  // of the samples
  const auto gaps = static_cast<double>(facts.missing + facts.held + facts.beyond_range);
  return {"Samples"_text, text,
          gaps > kNoticeable * static_cast<double>(facts.rows) || recorder_drops > 0};
}

Words status_words(storage::TrialStatus status) {
  switch (status) {
    case storage::TrialStatus::running: return "running"_text;
    case storage::TrialStatus::completed: return "completed"_text;
    case storage::TrialStatus::aborted: return "aborted"_text;
    case storage::TrialStatus::interrupted: return "interrupted"_text;
  }
  return "interrupted"_text;
}

QualityLine trial_line(const std::vector<storage::TrialRecord>& trials) {
  int completed = 0;
  int practice = 0;
  int helped = 0;
  std::vector<Text> unfinished;
  for (const auto& trial : trials) {
    practice += trial.practice ? 1 : 0;
    helped += trial.helped ? 1 : 0;
    if (trial.status == storage::TrialStatus::completed)
      ++completed;
    else
      unfinished.push_back("trial %1 (%2) %3"_text(trial.number, Known{trial.task_name},
                                                   status_words(trial.status)));
  }
  std::vector<Text> counts{"%1 of %2 completed"_text(completed, trials.size())};
  if (practice > 0) counts.push_back("%1 of them practice"_text(practice));
  if (helped > 0) counts.push_back("%1 with the therapist's help"_text(helped));
  return {"Trials"_text, apart({listed(counts), apart(unfinished)}), !unfinished.empty()};
}

QualityLine fault_line(const std::vector<storage::EventRecord>& events) {
  const auto of_kind = [&](const char* kind) {
    return std::count_if(events.begin(), events.end(),
                         [&](const storage::EventRecord& event) { return event.kind == kind; });
  };
  const auto faults = of_kind("fault");
  const auto pauses = of_kind("pause");
  const Text of_device = faults == 0   ? Text("no device fault"_text)
                         : faults == 1 ? Text("1 device fault"_text)
                                       : "%1 device faults"_text(faults);
  const Text of_pauses = pauses == 0   ? Text("no pause"_text)
                         : pauses == 1 ? Text("1 pause"_text)
                                       : "%1 pauses"_text(pauses);
  std::vector<Text> counts{of_device, of_pauses};
  const auto lost = of_kind("object_lost");
  if (lost == 1) counts.emplace_back("object lost from the hand once"_text);
  if (lost > 1) counts.emplace_back("object lost from the hand %1 times"_text(lost));
  Text text = listed(counts);
  for (const auto& event : events)
    if (event.kind == "fault" && !event.text.empty()) {
      text = apart({text, "first: %1"_text(Known{event.text})});
      break;
    }
  return {"Faults"_text, text, faults > 0};
}

QualityLine time_line(const std::vector<storage::TrialRecord>& trials, double rate_Hz) {
  double lateness_s = 0.0;
  for (const auto& trial : trials) lateness_s = std::max(lateness_s, trial.worst_lateness_s);
  return {"Timing"_text,
          "%1 frames per second; latest frame %2 ms late"_text(fixed(rate_Hz, 0),
                                                               fixed(1000.0 * lateness_s, 1)),
          lateness_s * rate_Hz > 1.0};
}

QualityLine delay_line(const storage::SessionRecord& session) {
  if (session.calibration.find("delay = \"not measured\"") != std::string::npos)
    return {"Delay"_text, "of tracker and display not measured, contained in all times"_text,
            false};
  if (session.device_delay_s > 0.0)
    return {"Delay"_text,
            "filter delay of %1 ms is contained in lag and tracking error, not subtracted; display "
            "delay not measured"_text(fixed(1000.0 * session.device_delay_s, 1)),
            false};
  return {"Delay"_text,
          "unknown filter delay, if any, is contained in lag and tracking error, not subtracted; "
          "display delay not measured"_text,
          false};
}

}  // namespace

Result<std::vector<QualityLine>> assess_quality(storage::SessionStore& store,
                                                const storage::SessionRecord& session,
                                                const std::vector<storage::TrialRecord>& trials,
                                                const Progress& progress) {
  const auto preparations = store.preparations(session.id);
  if (!preparations) return preparations.error();
  const auto events = store.events(session.id);
  if (!events) return events.error();
  const auto facts = read_signals(store, trials, progress);
  if (!facts) return facts.error();

  std::vector<QualityLine> lines;
  if (session.simulated)
    lines.push_back(
        {"Source"_text, "simulated device: these are not measurements of a person"_text, true});
  if (session.recorded) {
    lines.push_back(
        {"Source"_text, "a replayed recording, not measured with this device"_text, true});
    const auto& text = session.provenance;
    for (std::size_t from = 0; from < text.size();) {
      const auto end = std::min(text.find('\n', from), text.size());
      lines.push_back({{}, "%1"_text(text.substr(from, end - from)), false});
      from = end + 1;
    }
  }
  const std::string apparatus = apparatus_of(trials);
  lines.push_back(preparation_line(apparatus, session, *preparations));
  lines.push_back(trial_line(trials));
  std::int64_t dropped = 0;
  for (const auto& trial : trials) dropped += trial.dropped;
  if (facts->rows > 0)
    lines.push_back((apparatus == kArm ? picture_line : sample_line)(*facts, dropped,
                                                                     lost_on_the_wire(trials)));
  lines.push_back(fault_line(*events));
  lines.push_back(time_line(trials, session.rate_Hz));
  lines.push_back(delay_line(session));
  if (facts->compared > 0 && facts->differing.empty())
    lines.push_back({"Recomputed"_text,
                     "all %1 results follow again from the stored signals"_text(facts->compared),
                     false});
  if (facts->differing.size() == 1)
    lines.push_back({"Recomputed"_text,
                     "1 result cannot be reproduced from the stored signals, first: %1"_text(
                         facts->differing.front()),
                     true});
  if (facts->differing.size() > 1)
    lines.push_back({"Recomputed"_text,
                     "%1 results cannot be reproduced from the stored signals, first: %2"_text(
                         facts->differing.size(), facts->differing.front()),
                     true});
  for (const auto& damaged : facts->damaged) lines.push_back({"Damaged"_text, damaged, true});
  return lines;
}

}  // namespace isograsp::reports

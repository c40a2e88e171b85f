// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of opening and closing a hand. A gap counts where it stood for a moment: one wrong frame
// of a tracker is no opening.
#include <algorithm>
#include <cmath>

#include "hand/hand_columns.hpp"
#include "kinematics/range_of_motion.hpp"
#include "tasks/kinds/hand/hand_opening.hpp"
#include "tasks/kinds/tools/score_tools.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kStandsGap_s = 0.1;       // so long a gap is there before it counts
constexpr double kLeastMovement_m = 0.01;  // a change that is smaller is no movement
constexpr double kReached = 0.9;           // of the change: then the hand is open, or closed
constexpr Words kNeverStood = "the hand was never seen for 0.1 s on end"_text;

/// The gap in the rows of one cue that count.
struct GapTrace {
  Part part;
  Section section;
  std::vector<double> gap_m;
};

GapTrace gap_of(const Record& record, const Part& part) {
  GapTrace gap;
  gap.part = part;
  gap.section = record.select(part.first, part.last, {Phase::active}, {columns::thumb_index_gap_m});
  gap.gap_m = gap.section.values(columns::thumb_index_gap_m);
  return gap;
}

/// The furthest (`sign` 1: largest, -1: least) gap that stood; nothing: none was seen on end.
std::optional<double> furthest_stood(const Record& record, const GapTrace& gap, double sign) {
  const std::vector<std::size_t>& rows = gap.section.rows;
  std::optional<double> furthest;
  std::size_t begin = 0;  // of the rows on end
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0 && rows[k] != rows[k - 1] + 1) begin = k;
    double stood = sign * gap.gap_m[k];
    double stands_s = 0.0;
    for (std::size_t j = k + 1; j-- > begin;) {
      stood = std::min(stood, sign * gap.gap_m[j]);
      stands_s += record.hold_s(rows[j]);
      if (statistics::is_earlier(stands_s, kStandsGap_s)) continue;
      if (!furthest || stood > *furthest) furthest = stood;
      break;
    }
  }
  if (furthest) furthest = sign * *furthest;
  return furthest;
}

/// When the hand was open (`sign` 1) or closed (-1), from the cue on.
statistics::EventTime movement_time(const Record& record, const GapTrace& gap, double sign,
                                    double limit_s) {
  const auto furthest_m = furthest_stood(record, gap, sign);
  if (!furthest_m) return {statistics::Computed(kNeverStood), std::nullopt};
  const double from_m = gap.gap_m.front();
  const double change_m = sign * (*furthest_m - from_m);
  if (change_m < kLeastMovement_m)
    return {statistics::Computed("the hand did not move"_text), limit_s};
  std::size_t k = 0;
  while (sign * (gap.gap_m[k] - from_m) < kReached * change_m) ++k;
  return {gap.section.t_s[k] - record.task_time_s(gap.part.first), std::nullopt};
}

class HandOpeningScore {
 public:
  HandOpeningScore(const HandOpeningSpec& spec, const Record& record)
      : spec_(spec), record_(record) {
    for (const Part& part : parts_of(record)) {
      if (part.phase != Phase::active) continue;
      (part.cue == Cue::open ? opens_ : closes_).push_back(gap_of(record, part));
    }
    whole_ = record.select({Phase::active}, {columns::thumb_index_gap_m});
  }

  [[nodiscard]] std::vector<Measure> measures() {
    add_movements(opens_, 1.0, spec_.open_s, "hand_opening_time", "hand_openings");
    add_movements(closes_, -1.0, spec_.close_s, "hand_closing_time", "hand_closings");
    list_.add("largest_gap", "thumb_index", "m", whole_, largest_gap());
    for (std::size_t d = 0; d < kDigitCount; ++d) add_range(d);
    return list_.take();
  }

 private:
  void add_movements(const std::vector<GapTrace>& gaps, double sign, double limit_s,
                     const std::string& time, const std::string& count) {
    std::vector<statistics::EventTime> times;
    int made = 0;
    for (const GapTrace& gap : gaps) {
      times.push_back(movement_time(record_, gap, sign, limit_s));
      made += times.back().time_s.value ? 1 : 0;
    }
    list_.add(count, "thumb_index", "of " + std::to_string(spec_.repetitions), whole_,
              static_cast<double>(made));
    list_.add_times(time, "thumb_index", whole_, times, limit_s);
  }

  [[nodiscard]] statistics::Computed largest_gap() const {
    std::optional<double> largest_m;
    for (const auto* gaps : {&opens_, &closes_})
      for (const GapTrace& gap : *gaps)
        if (const auto stood_m = furthest_stood(record_, gap, 1.0))
          largest_m = std::max(largest_m.value_or(*stood_m), *stood_m);
    if (!largest_m) return kNeverStood;
    return *largest_m;
  }

  /// Of the three flexions together.
  void add_range(std::size_t digit) {
    const auto& joints = columns::flexion[digit];
    const Section section = record_.select({Phase::active}, {joints[0], joints[1], joints[2]});
    std::vector<double> t_s;
    std::vector<double> flexion_rad;
    if (section.reason.empty())
      for (std::size_t row = 0; row < record_.rows(); ++row) {
        if (record_.phase(row) != Phase::active) continue;
        double sum_rad = record_.counts(row) ? 0.0 : std::nan("");
        for (const Column& joint : joints) sum_rad += record_.signals().column(joint)[row];
        t_s.push_back(record_.task_time_s(row));
        flexion_rad.push_back(sum_rad);
      }
    const Range range = range_of_motion(t_s, flexion_rad);
    const bool held = range.min_held_rad && range.max_held_rad;
    list_.add("flexion_range", std::string(kDigitNames[digit]), "rad", section,
              held ? statistics::Computed(*range.max_held_rad - *range.min_held_rad)
                   : statistics::Computed("the digit was never seen for 0.2 s on end"_text));
  }

  const HandOpeningSpec& spec_;
  const Record& record_;
  std::vector<GapTrace> opens_;
  std::vector<GapTrace> closes_;
  Section whole_;
  MeasureList list_;
};

}  // namespace

std::vector<Measure> score_hand_opening(const HandOpeningSpec& spec, const Record& record) {
  return HandOpeningScore(spec, record).measures();
}

}  // namespace isograsp::tasks

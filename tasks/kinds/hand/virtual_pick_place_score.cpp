// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of placements, by the same rule as they ran (virtual_hand/placement.hpp). What was done
// with one level of assistance has its own channel: it never shares a mean with another.
#include <algorithm>
#include <map>

#include "hand/hand_columns.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

namespace {

using virtual_hand::PlacementRow;
using virtual_hand::PlacementScore;

/// Pauses in which the hand was out of sight; in others nobody asks for it.
constexpr double kNoPause = 0.0;
constexpr double kOutOfSight = 4.0;

/// One placement, with all that was seen of it.
struct Placement {
  std::string channel;
  Section section;  ///< its rows
  virtual_hand::LostShare lost;
  PlacementScore score;
  std::optional<double> release_s;
  bool asked_to_let_go = false;
  bool helped = false;
};

class PlacementReader {
 public:
  explicit PlacementReader(const Record& record) : record_(record), signals_(record.signals()) {
    for (const std::string_view name : needed())
      if (!signals_.has(name) && absent_.empty()) absent_ = kColumnMissing(std::string(name));
  }
  [[nodiscard]] const Text& absent() const noexcept { return absent_; }

  [[nodiscard]] std::vector<Placement> all(const virtual_hand::PlacementRule& rule) const {
    std::vector<Placement> placements;
    if (!absent_.empty()) return placements;
    const auto numbers = signals_.column(columns::placement);
    for (std::size_t first = 0; first < record_.rows();) {
      std::size_t last = first + 1;
      while (last < record_.rows() && numbers[last] == numbers[first]) ++last;
      if (numbers[first] >= 0.0 && level_of(first)) placements.push_back(read(first, last, rule));
      first = last;
    }
    return placements;
  }

 private:
  static std::vector<std::string_view> needed() {
    std::vector<std::string_view> names{columns::placement,      columns::assistance,
                                        columns::eased,          columns::pause_cause,
                                        columns::let_go_asked,   columns::object_helped,
                                        columns::object_held,    columns::object_supported,
                                        columns::object_touched, columns::sample_flags};
    for (const auto& axes : {&columns::actual_position, &columns::target_position})
      for (const Column& column : *axes) names.emplace_back(column);
    for (const auto& parts : {&columns::actual_attitude, &columns::target_attitude})
      for (const Column& column : *parts) names.emplace_back(column);
    return names;
  }

  [[nodiscard]] double value(std::string_view column, std::size_t row) const {
    return signals_.column(column)[row];
  }
  [[nodiscard]] bool is_one(std::string_view column, std::size_t row) const {
    return value(column, row) == 1.0;
  }
  /// Nothing: the record does not say with which help it was done.
  [[nodiscard]] std::optional<std::string_view> level_of(std::size_t row) const {
    for (std::size_t k = 0; k < virtual_hand::kAssistanceLevelNames.size(); ++k)
      if (value(columns::assistance, row) == static_cast<double>(k))
        return virtual_hand::kAssistanceLevelNames[k];
    return std::nullopt;
  }
  [[nodiscard]] Pose pose(const columns::OfAxes& p, const columns::OfComponents& q,
                          std::size_t row) const {
    return {{value(p[0], row), value(p[1], row), value(p[2], row)},
            Quat(value(q[0], row), value(q[1], row), value(q[2], row), value(q[3], row))};
  }

  [[nodiscard]] Placement read(std::size_t first, std::size_t last,
                               const virtual_hand::PlacementRule& rule) const {
    Placement placement;
    placement.channel = *level_of(first);
    if (is_one(columns::eased, first)) placement.channel += "_eased";
    placement.section = record_.select(first, last, {}, {columns::placement});
    std::vector<PlacementRow> rows;
    double seen_s = 0.0;
    std::vector<bool> touched;
    std::vector<bool> asked;
    for (std::size_t row = first; row < last; ++row) {
      const double pause = value(columns::pause_cause, row);
      if (pause == kNoPause || pause == kOutOfSight)
        placement.lost.add(!(value(columns::sample_flags, row) == 0.0));
      // What an object does that was let go for the person is none of the hand's doing.
      placement.helped = placement.helped || is_one(columns::object_helped, row);
      if (placement.helped || !record_.counts(row)) continue;
      // The clock of a placement counts the rows in which the hand was seen.
      rows.push_back({seen_s, is_one(columns::object_held, row),
                      is_one(columns::object_supported, row),
                      pose(columns::actual_position, columns::actual_attitude, row),
                      pose(columns::target_position, columns::target_attitude, row)});
      seen_s += record_.hold_s(row);
      touched.push_back(is_one(columns::object_touched, row));
      asked.push_back(is_one(columns::let_go_asked, row));
    }
    placement.score = virtual_hand::score_placement(rows, rule);
    read_release(rows, touched, asked, placement);
    return placement;
  }

  /// From being asked to the first row from which on no digit touches for a while.
  static void read_release(const std::vector<PlacementRow>& rows, const std::vector<bool>& touched,
                           const std::vector<bool>& asked, Placement& placement) {
    const auto asks = std::find(asked.begin(), asked.end(), true);
    placement.asked_to_let_go = asks != asked.end();
    if (!placement.asked_to_let_go) return;
    const auto done = static_cast<std::size_t>(asks - asked.begin());
    std::optional<double> free_s;
    for (std::size_t k = done + 1; k < rows.size() && !placement.release_s; ++k) {
      const double since_s = rows[k].t_s - rows[done].t_s;
      if (touched[k])
        free_s.reset();
      else if (!free_s)
        free_s = since_s;
      if (free_s && !statistics::is_earlier(since_s - *free_s, VirtualPickPlaceSpec::kFree_s))
        placement.release_s = *free_s;
      if (!statistics::is_earlier(since_s, VirtualPickPlaceSpec::kReleaseLimit_s)) break;
    }
  }

  const Record& record_;
  const Signals& signals_;
  Text absent_;
};

/// All placements of one channel.
class ChannelScore {
 public:
  ChannelScore(std::string channel, MeasureList& list)
      : channel_(std::move(channel)), list_(list) {}

  void add(const Placement& placement) {
    sections_.push_back(placement.section);
    if (!placement.lost.can_be_scored()) {
      ++lost_;
      return;
    }
    ++scored_;
    const PlacementScore& score = placement.score;
    fails_ += score.fails;
    completed_ += score.completed ? 1 : 0;
    if (score.completed)
      carried_.push_back({*score.manipulation_s, std::nullopt});
    else
      carried_.push_back(
          {statistics::Computed("it was not placed"_text), VirtualPickPlaceSpec::kTimeLimit_s});
    const auto add_error = [](std::vector<statistics::Computed>& errors,
                              const std::optional<double>& value) {
      if (value) errors.emplace_back(*value);
    };
    add_error(distance_, score.hold_distance_m);
    add_error(axis_, score.hold_axis_angle_rad);
    add_error(angle_, score.hold_geodesic_rad);
    helped_ += placement.helped ? 1 : 0;
    if (!placement.asked_to_let_go) return;
    if (placement.release_s)
      released_.push_back({*placement.release_s, std::nullopt});
    else
      released_.push_back({statistics::Computed("the hand did not let go"_text),
                           VirtualPickPlaceSpec::kReleaseLimit_s});
  }

  void measures(const Text& absent) {
    Section rows = join(sections_);
    if (rows.reason.empty()) rows.reason = absent;
    const auto number = [](int value) { return statistics::Computed(static_cast<double>(value)); };
    const Words none = "nothing was placed"_text;
    list_.add("placements_completed", channel_, "of " + std::to_string(scored_), rows,
              number(completed_));
    list_.add("placement_fails", channel_, "", rows, number(fails_));
    list_.add("placements_not_scored", channel_, "", rows, number(lost_));
    list_.add_times("manipulation_time", channel_, rows, carried_,
                    VirtualPickPlaceSpec::kTimeLimit_s);
    const auto add_error = [&](const char* name, const char* unit,
                               const std::vector<statistics::Computed>& errors) {
      list_.add(name, channel_, unit, rows, mean_of_repetitions(errors, none));
    };
    add_error("placement_distance", "m", distance_);
    add_error("placement_axis_angle", "rad", axis_);
    add_error("placement_angle", "rad", angle_);
    list_.add_times("object_release_time", channel_, rows, released_,
                    VirtualPickPlaceSpec::kReleaseLimit_s);
    list_.add("releases_helped", channel_, "", rows, number(helped_));
  }

 private:
  std::string channel_;
  MeasureList& list_;
  std::vector<Section> sections_;
  int scored_ = 0;
  int lost_ = 0;
  int completed_ = 0;
  int fails_ = 0;
  int helped_ = 0;
  std::vector<statistics::EventTime> carried_;
  std::vector<statistics::EventTime> released_;
  std::vector<statistics::Computed> distance_;
  std::vector<statistics::Computed> axis_;
  std::vector<statistics::Computed> angle_;
};

}  // namespace

std::vector<Measure> score_virtual_pick_place(const VirtualPickPlaceSpec& spec,
                                              const Record& record) {
  const PlacementReader reader(record);
  MeasureList list;
  std::map<std::string, ChannelScore> channels;
  const auto channel = [&](const std::string& name) -> ChannelScore& {
    return channels.try_emplace(name, name, list).first->second;
  };
  static_cast<void>(channel(std::string(name_of(spec.assistance))));
  for (const Placement& placement : reader.all(spec.rule()))
    channel(placement.channel).add(placement);
  for (auto& [name, score] : channels) score.measures(reader.absent());
  return list.take();
}

}  // namespace isograsp::tasks

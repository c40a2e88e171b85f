// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/arm_trial.hpp"

#include "session/acquisition/json_object.hpp"

namespace isograsp::session {

namespace {

template <class Number>
double as_number(Number value) {
  return static_cast<double>(value);
}

/// Held: the last pose of the object stands in for a moment; missing: nothing does. A rig without
/// an object has no flags.
std::uint8_t flags_of(const ArmSnapshot& seen, const ArmTrial& trial) noexcept {
  if (!trial.has_segment[index_of(ArmSegment::object)]) return 0;
  if (has_pose(seen.segment(ArmSegment::object).state)) return 0;
  return seen.unseen_s > kLongestStandIn_s + kMarkerTimeSlack_s ? bit(SampleFlag::missing)
                                                                : bit(SampleFlag::held);
}

template <class Sink>
void put_task(Sink& sink, const RowFrame& frame, const ArmSnapshot& seen, const ArmTrial& trial) {
  const tasks::ArmView& task = seen.special.arm();
  put_progress(sink, frame);
  sink.put(columns::sample_flags, as_number(flags_of(seen, trial)));
  sink.put(columns::target_index, as_number(frame.task.target_index));
  sink.put(columns::targets_reached, as_number(frame.task.targets_reached));
  sink.put(columns::matched, as_number(task.matched));
  put_pose(sink, columns::reference_position, columns::reference_attitude,
           task.reference_shown ? task.X_WR : missing_pose());
}

template <class Sink>
void put_seen(Sink& sink, const ArmSnapshot& seen, const ArmTrial& trial) {
  sink.begin("arm");
  for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
    if (!trial.has_segment[s]) continue;
    const columns::OfSegment& columns = columns::segment_pose[s];
    const FramePose& pose = seen.segments[s];
    put_pose(sink, columns.position, columns.attitude, pose.X_W);
    sink.put(columns.residual_m, pose.residual_m);
    sink.put(columns.state, as_number(pose.state));
  }
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    for (std::size_t a = 0; a < 3; ++a)
      sink.put(columns::link_angle[link][a], seen.link_angles[link][static_cast<Eigen::Index>(a)]);
  sink.begin("markers");
  for (std::size_t m = 0; m < trial.markers.size(); ++m)
    put_position(sink, trial.markers[m], seen.markers_W[m]);
}

template <class Sink>
void put_all(Sink sink, const RowFrame& frame, const ArmSnapshot& seen, const ArmTrial& trial) {
  put_task(sink, frame, seen, trial);
  put_seen(sink, seen, trial);
  put_timing(sink, frame);
}

}  // namespace

std::vector<columns::OfAxes> marker_columns(std::span<const RecordedMarker> markers) {
  std::vector<columns::OfAxes> all;
  for (const RecordedMarker& marker : markers) {
    columns::OfAxes axes;
    for (std::size_t a = 0; a < 3; ++a) {
      axes[a].name = FixedText<28>(columns::kMarker, std::string_view(marker.name),
                                   std::string_view("_"), columns::kXyz[a], std::string_view("_m"));
      axes[a].axes = "cameras";
      axes[a].component = columns::kXyz[a];
    }
    all.push_back(axes);
  }
  return all;
}

std::vector<storage::SignalGroup> ArmTrial::columns() const {
  std::vector<storage::SignalGroup> groups;
  put_all(ColumnNames{groups}, {}, {}, *this);
  return groups;
}

void ArmTrial::write(const RowFrame& frame, const ArmSnapshot& seen, TrialRow& row) const noexcept {
  put_all(ColumnValues{row}, frame, seen, *this);
}

std::vector<storage::SignalGroup> ArmTrial::seen_columns() const {
  std::vector<storage::SignalGroup> groups;
  ColumnNames sink{groups};
  put_seen(sink, {}, *this);
  return groups;
}

void ArmTrial::write_seen(const ArmSnapshot& seen, TrialRow& row) const noexcept {
  ColumnValues sink{row};
  put_seen(sink, seen, *this);
}

std::string ArmTrial::health_json() const {
  JsonObject counters;
  counters.add("good", health.counters.good);
  counters.add("lost", health.counters.lost);
  counters.add("duplicate", health.counters.duplicate);
  counters.add("unlabelled", health.counters.unlabelled);
  counters.add("damaged", health.counters.damaged);
  counters.add("restarts", health.counters.restarts);
  JsonObject whole;
  whole.add("state", quoted(name_of(health.state)));
  whole.add("fault", quoted(name_of(health.fault)));
  whole.add("cameras", counters.text());
  return whole.text();
}

}  // namespace isograsp::session

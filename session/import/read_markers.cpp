// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of markers to trials of an arm: each file one trial, with the columns that a session
// with these cameras would have recorded of the arm.
#include "device/markers/marker_reader.hpp"
#include "hand/columns.hpp"
#include "session/acquisition/trial_row.hpp"
#include "session/arm/arm_sight.hpp"
#include "session/arm/arm_trial.hpp"
#include "session/import/recorded_trials.hpp"
#include "session/library/library.hpp"

namespace isograsp::session {

namespace {

std::vector<std::string> names_of(const ArmTrial& trial) {
  std::vector<std::string> names{columns::t_s};
  for (const storage::SignalGroup& group : trial.seen_columns())
    names.insert(names.end(), group.columns.begin(), group.columns.end());
  return names;
}

/// Rows of `reader` as rows of `signals`.
Result<void> read_rows(MarkerReader& reader, ArmSight& sight, const ArmTrial& trial,
                       Signals& signals) {
  ArmSnapshot seen;
  TrialRow row;
  double t_s = 0.0;
  std::vector<Vec3> p_W(reader.markers().size());
  for (;;) {
    const auto more = reader.next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) return {};
    sight.see(p_W, seen);
    row.clear();
    row.add(t_s);
    trial.write_seen(seen, row);
    signals.append_row(row.values());
  }
}

}  // namespace

Result<RecordedMarkers> RecordedMarkers::open(const RecordingSpec& spec,
                                              const std::string& library) {
  const auto path = find_in_library(library, "rigs", spec.rig, spec.path);
  if (!path) return path.error();
  auto rig = ArmRig::read(*path, *spec.hand);
  if (!rig) return rig.error();
  return RecordedMarkers(*std::move(rig));
}

Result<void> RecordedMarkers::read(const std::filesystem::path& path, const KeyValues& of_file,
                                   RecordedTrials& trials) const {
  const auto trial = trials.trial_of(of_file, {path, std::nullopt});
  if (!trial) return trial.error();
  const auto reader = open_markers(path);
  if (!reader) return reader.error();
  auto sight = ArmSight::compile(rig_, (*reader)->markers());
  if (!sight) return Error(sight.error()).at(path);
  ArmTrial columns_of;
  columns_of.markers = marker_columns(sight->recorded());
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    columns_of.has_segment[s] = rig_.frame_of[s].has_value();
  (*trial)->signals = Signals(names_of(columns_of));
  (*trial)->calibration = rig_.text;
  (*trial)->simulated = (*reader)->simulated();
  return read_rows(**reader, *sight, columns_of, (*trial)->signals);
}

}  // namespace isograsp::session

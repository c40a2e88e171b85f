// SPDX-License-Identifier: GPL-3.0-or-later
// Which measures of each kind of task the report draws, and which of them stand at a glance.
#include <span>

#include "tasks/facts/measure_words.hpp"

namespace isograsp::tasks {

namespace {

struct Placed {
  std::string_view name;
  std::string_view channel;  ///< empty: any
  Prominence prominence;
};
using Places = std::span<const Placed>;

constexpr Placed kRest[] = {{"resting_force", "grip", Prominence::trend}};
constexpr Placed kMaximum[] = {{"maximum_force", "", Prominence::key},
                               {"comfortable_force", "", Prominence::key},
                               {"coflexion", "", Prominence::trend}};
// The compass and its table show all directions.
constexpr Placed kDirectionalMaxima[] = {{"maximum_force", "thumb_opening", Prominence::trend},
                                         {"maximum_force", "index_opening", Prominence::trend},
                                         {"maximum_force", "middle_opening", Prominence::trend},
                                         {"coflexion", "", Prominence::trend}};
// Rising and falling parts stand in the table of a trial, not in the report.
constexpr Placed kTracking[] = {{"relative_rmse", "", Prominence::key},
                                {"time_in_range", "force", Prominence::trend},
                                {"lag", "", Prominence::trend}};
constexpr Placed kSteadiness[] = {{"cv", "", Prominence::key},
                                  {"time_in_range", "", Prominence::trend}};
constexpr Placed kStepResponse[] = {{"reaction_time", "", Prominence::key},
                                    {"settling_time", "", Prominence::key},
                                    {"settling_time_share", "", Prominence::trend},
                                    {"overshoot", "", Prominence::trend}};
// How many were let go at all is read before how soon.
constexpr Placed kGripRelease[] = {{"release_time_share", "", Prominence::key},
                                   {"release_time", "", Prominence::key},
                                   {"residual_force", "", Prominence::trend},
                                   {"opening_force", "", Prominence::trend}};
constexpr Placed kForceSense[] = {{"absolute_error", "", Prominence::key},
                                  {"constant_error", "", Prominence::trend},
                                  {"variable_error", "", Prominence::trend}};
constexpr Placed kFatigue[] = {{"fatigue_slope", "", Prominence::key},
                               {"endurance", "", Prominence::trend}};
constexpr Placed kIndividuation[] = {{"individuation_index", "", Prominence::key}};
constexpr Placed kForceDirection[] = {{"direction_error", "", Prominence::key},
                                      {"projection_ratio", "", Prominence::trend},
                                      {"path_deviation", "", Prominence::trend}};
constexpr Placed kPoseTargets[] = {{"targets_reached", "", Prominence::key},
                                   {"tilt_in_transport", "", Prominence::key},
                                   {"path_efficiency", "", Prominence::trend}};
// The whole distance and angle stand for the single degrees of freedom.
constexpr Placed kPoseTracking[] = {{"rmse", "position", Prominence::key},
                                    {"rmse", "attitude", Prominence::key},
                                    {"lag", "", Prominence::trend}};
constexpr Placed kPickPlace[] = {{"targets_reached", "", Prominence::key},
                                 {"median_completion_time", "", Prominence::key},
                                 {"drops", "", Prominence::trend}};
constexpr Placed kObserve[] = {{"mean_grip", "", Prominence::trend},
                               {"path_length", "", Prominence::trend},
                               {"contact_time", "", Prominence::trend}};
constexpr Placed kRecorded[] = {{"corridor_rms", "", Prominence::key},
                                {"time_in_corridor", "", Prominence::key},
                                {"corridor_distance", "", Prominence::trend},
                                {"maximum_window_mean", "", Prominence::key},
                                {"relative_rmse", "", Prominence::key},
                                {"time_in_range", "", Prominence::trend},
                                {"rhythm", "", Prominence::trend},
                                {"sharing", "", Prominence::trend}};

// One for each kind: a new kind of task does not compile without its line here.
Places places_of(const RestSpec&) {
  return kRest;
}
Places places_of(const MaximumSpec&) {
  return kMaximum;
}
Places places_of(const DirectionalMaximaSpec&) {
  return kDirectionalMaxima;
}
Places places_of(const ForceTrackingSpec&) {
  return kTracking;
}
Places places_of(const SteadinessSpec&) {
  return kSteadiness;
}
Places places_of(const StepResponseSpec&) {
  return kStepResponse;
}
Places places_of(const GripReleaseSpec&) {
  return kGripRelease;
}
Places places_of(const ForceSenseSpec&) {
  return kForceSense;
}
Places places_of(const FatigueSpec&) {
  return kFatigue;
}
Places places_of(const IndividuationSpec&) {
  return kIndividuation;
}
Places places_of(const ForceDirectionSpec&) {
  return kForceDirection;
}
Places places_of(const PoseTargetsSpec&) {
  return kPoseTargets;
}
Places places_of(const PoseTrackingSpec&) {
  return kPoseTracking;
}
Places places_of(const PickPlaceSpec&) {
  return kPickPlace;
}
Places places_of(const ObserveSpec&) {
  return kObserve;
}
Places places_of(const RecordedSpec&) {
  return kRecorded;
}

}  // namespace

Place place_of(const std::optional<TaskSpec>& spec, std::string_view name,
               std::string_view channel) {
  if (!spec) return {};
  int rank = 0;
  for (const Placed& placed :
       std::visit([](const auto& kind) { return places_of(kind); }, spec->kind)) {
    if (placed.name == name && (placed.channel.empty() || placed.channel == channel))
      return {placed.prominence, rank};
    ++rank;
  }
  return {};
}

}  // namespace isograsp::tasks

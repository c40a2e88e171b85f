// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/grasp_study.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/csv.hpp"

namespace isograsp::reports {

namespace {

constexpr std::array<bool, 2> kModes{true, false};

std::string_view mode_name(bool assistance) noexcept {
  return assistance ? "with assistance" : "without";
}

/// What one placement says of a measure; nothing: it says nothing.
std::optional<double> value_of(const GraspPlacement& placement, GraspMeasure measure,
                               double longest_s) noexcept {
  switch (measure) {
    case GraspMeasure::fails: return placement.fails;
    case GraspMeasure::time: return placement.manipulation_s.value_or(longest_s);
    case GraspMeasure::distance: return placement.hold_distance_m;
    case GraspMeasure::angle: return placement.hold_axis_angle_rad;
    case GraspMeasure::release: return placement.release_s;
  }
  return std::nullopt;
}

StudyCell cell_of(const std::vector<GraspPlacement>& placements, const std::string& group,
                  std::uint64_t seed, std::string_view size, bool assistance, GraspMeasure measure,
                  double longest_s) {
  StudyCell cell;
  double sum = 0.0;
  for (const GraspPlacement& placement : placements) {
    if (placement.group != group || placement.seed != seed || placement.size != size ||
        placement.assistance != assistance)
      continue;
    const auto value = value_of(placement, measure, longest_s);
    if (!value) continue;
    sum += *value;
    ++cell.trials;
  }
  if (cell.trials > 0)
    cell.value = sum / cell.trials;
  else
    cell.reason = "no placement was completed"_text;
  cell.sessions = cell.trials > 0 ? 1 : 0;
  return cell;
}

std::string_view unit_of(GraspMeasure measure) noexcept {
  switch (measure) {
    case GraspMeasure::fails: return "";
    case GraspMeasure::distance: return "m";
    case GraspMeasure::angle: return "rad";
    case GraspMeasure::time:
    case GraspMeasure::release: break;
  }
  return "s";
}

Text words_of_tally(const GraspTally& tally) {
  return "%1, %2, %3: %4 of %5 placements completed, %6 drops, %7 let go by the program"_text(
      tally.group, tally.size, std::string(mode_name(tally.assistance)), tally.completed,
      tally.placements, tally.fails, tally.helped);
}

}  // namespace

std::string_view name_of(GraspMeasure measure) noexcept {
  switch (measure) {
    case GraspMeasure::fails: return "placement_fails";
    case GraspMeasure::time: return "manipulation_time";
    case GraspMeasure::distance: return "placement_distance";
    case GraspMeasure::angle: return "placement_axis_angle";
    case GraspMeasure::release: break;
  }
  return "object_release_time";
}

Study grasp_study(GraspMeasure measure) {
  Study study;
  study.title = "Grasp assistance, simulated";
  study.measure = name_of(measure);
  study.source = Source::simulated;
  StudyFactor sizes{"Size", {}};
  for (const std::string_view size : kGraspSizes) sizes.levels.push_back({std::string(size), {}});
  StudyFactor modes{"Mode", {}};
  for (const bool assistance : kModes)
    modes.levels.push_back({std::string(mode_name(assistance)), {}});
  study.factors = {std::move(sizes), std::move(modes)};
  study.analyses = {StudyAnalysis::anova};
  return study;
}

StudyData grasp_study_data(const std::vector<GraspPlacement>& placements, GraspMeasure measure,
                           double longest_s) {
  StudyData data;
  data.unit = unit_of(measure);
  data.design = {
      "Each value of a person is the mean over the placements of both shapes and both tests."_text,
      "In time a placement that was not completed counts with %1 s; distance, angle and release are of completed placements alone, so read them together with how many there were."_text(
          Number{format_number(longest_s)}),
      "These are people in software: the numbers show what the program does, not what patients do."_text};
  for (const GraspTally& tally : tally_of(placements))
    data.design.push_back("%1."_text(words_of_tally(tally)));
  std::vector<std::string> groups;
  std::map<std::string, std::vector<std::uint64_t>> people;
  for (const GraspPlacement& placement : placements) {
    auto& seeds = people[placement.group];
    if (seeds.empty()) groups.push_back(placement.group);
    if (std::find(seeds.begin(), seeds.end(), placement.seed) == seeds.end())
      seeds.push_back(placement.seed);
  }
  std::size_t number = 0;
  for (const std::string& name : groups) {
    StudyGroupData group;
    group.name = name;
    for (const std::uint64_t seed : people[name]) {
      ++number;
      group.subjects.push_back((number < 10 ? "S0" : "S") + std::to_string(number));
      auto& cells = group.cells.emplace_back();
      for (const std::string_view size : kGraspSizes)
        for (const bool assistance : kModes)
          cells.push_back(cell_of(placements, name, seed, size, assistance, measure, longest_s));
    }
    data.groups.push_back(std::move(group));
  }
  return data;
}

std::string grasp_study_csv(const std::vector<GraspPlacement>& placements) {
  std::string text =
      "group,seed,object,size,assistance,target,completed,fails,manipulation_s,hold_distance_m,"
      "hold_axis_angle_rad,hold_geodesic_rad,release_s,helped,held_open_s,lost_share\n";
  const auto number = [](const std::optional<double>& value) {
    return value ? format_number(*value) : std::string();
  };
  for (const GraspPlacement& one : placements) {
    text += one.group + "," + std::to_string(one.seed) + "," + one.object + "," + one.size + "," +
            (one.assistance ? "on" : "off") + "," + std::to_string(one.target + 1) + "," +
            (one.completed ? "1" : "0") + "," + std::to_string(one.fails);
    for (const auto& value : {one.manipulation_s, one.hold_distance_m, one.hold_axis_angle_rad,
                              one.hold_geodesic_rad, one.release_s})
      text += "," + number(value);
    text += std::string(",") + (one.helped ? "1" : "0") + "," + number(one.held_open_s) + "," +
            number(one.lost_share) + "\n";
  }
  return text;
}

std::vector<GraspTally> tally_of(const std::vector<GraspPlacement>& placements) {
  std::vector<GraspTally> tallies;
  for (const GraspPlacement& one : placements) {
    auto found = std::find_if(tallies.begin(), tallies.end(), [&](const GraspTally& tally) {
      return tally.group == one.group && tally.size == one.size &&
             tally.assistance == one.assistance;
    });
    if (found == tallies.end()) {
      tallies.push_back({one.group, one.size, one.assistance});
      found = tallies.end() - 1;
    }
    ++found->placements;
    found->completed += one.completed ? 1 : 0;
    found->fails += one.fails;
    found->helped += one.helped ? 1 : 0;
    found->longest_held_open_s = std::max(found->longest_held_open_s, one.held_open_s);
  }
  const auto place = [](const GraspTally& tally) {
    const auto size = std::find(kGraspSizes.begin(), kGraspSizes.end(), tally.size);
    return std::make_tuple(tally.group, size - kGraspSizes.begin(), !tally.assistance);
  };
  std::sort(tallies.begin(), tallies.end(),
            [&](const GraspTally& a, const GraspTally& b) { return place(a) < place(b); });
  return tallies;
}

}  // namespace isograsp::reports

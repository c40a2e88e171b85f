// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of single digits: how far they are independent, and where they push.
#include <cmath>

#include "tasks/kinds/score_kinds.hpp"
#include "tasks/kinds/score_tools.hpp"
#include "tasks/measures/digits.hpp"
#include "tasks/measures/direction.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

std::vector<Measure> measures_of(const IndividuationSpec& spec, const Record& record) {
  MeasureList list;
  std::vector<DigitHold> holds;
  std::vector<Individuation> points;
  std::vector<Section> sections;
  std::array<double, kFingerCount> maximum_N;
  maximum_N.fill(std::nan(""));
  PerDigit start_N{};
  bool rested = false;
  for (const Part& part : parts_of(record)) {
    const auto digit = single_digit(part.channel);
    const NormalForces forces = normal_forces(record, part.first, part.last);
    if (part.cue == Cue::relax) {
      rested = !forces.section.rows.empty();
      start_N = forces.mean();
    }
    if (part.phase != Phase::active || !digit) continue;
    maximum_N[index_of(*digit)] = known_in(record, part, "maximum_force_N");
    sections.push_back(forces.section);
    if (forces.section.rows.empty() || !rested) continue;
    holds.push_back({*digit, start_N, forces.mean()});
    const statistics::Computed off = uninstructed_deviation(forces.view(), *digit, start_N);
    if (off.value)
      points.push_back(
          {holds.back().mean_N[index_of(*digit)] - start_N[index_of(*digit)], *off.value});
  }
  const Section all = join(sections);
  const double noise_N = record.constant("noise_sd_N").value_or(0.0);
  constexpr double kLeastRise_sd = 3.0;  // a press that is not above the noise moved nobody
  list.add("individuation_index", "digits", "", all, individuation_index(points));
  list.add("individuation_slope", "digits", "", all, individuation_slope(points));
  for (const Finger j : spec.digits)
    for (const Finger i : kFingers) {
      if (i == j) continue;
      const std::string channel = std::string(name_of(j)) + "_to_" + std::string(name_of(i));
      list.add("enslaving", channel, "", all, enslaving(holds, i, j, kLeastRise_sd * noise_N));
      const double most_N = maximum_N[index_of(i)];
      list.add("enslaving_of_maximum", channel, "", all,
               most_N > 0.0 ? enslaving_of_maximum(holds, i, j, most_N)
                            : statistics::Computed("the maximum of the " + std::string(name_of(i)) +
                                                   " was not measured"));
    }
  return list.take();
}

std::vector<Measure> measures_of(const ForceDirectionSpec&, const Record& record) {
  MeasureList list;
  std::vector<statistics::Computed> deviations;
  std::vector<Section> paths;
  for (const Finger finger : kFingers) {
    const std::string name(name_of(finger));
    std::vector<statistics::Computed> angle, projection, error;
    std::vector<Section> sections;
    for (const Part& part : parts_of(record)) {
      if (part.phase != Phase::active) continue;
      const Vectors target = vectors_of(record, part.first, part.last, "target_" + name);
      if (target.force_N.empty()) {  // this digit was not asked, or nothing can be computed
        if (record.signals().has("target_" + name + "_fz_N") && !target.section.reason.empty())
          sections.push_back(target.section);
        continue;
      }
      const Vectors actual = vectors_of(record, part.first, part.last, name);
      const Vec3 wanted_N = target.force_N.front();
      const double noise_N = known_in(record, part, "noise_sd_N");
      constexpr double kLeast_sd = 3.0;
      angle.push_back(direction_error(actual.force_N, wanted_N, actual.section.weight_s,
                                      std::isnan(noise_N) ? 0.0 : kLeast_sd * noise_N));
      projection.push_back(
          projection_ratio(actual.force_N, wanted_N.normalized(), actual.section.weight_s));
      std::vector<double> size_N, wanted_size_N;
      for (const Vec3& force_N : actual.force_N) size_N.push_back(force_N.norm());
      wanted_size_N.assign(size_N.size(), wanted_N.norm());
      error.push_back(rmse(wanted_size_N, size_N, actual.section.weight_s));
      sections.push_back(actual.section);
    }
    if (sections.empty()) continue;
    const Section all = join(sections);
    list.add_mean("direction_error", name, "rad", all, angle);
    list.add_mean("projection_ratio", name, "", all, projection);
    list.add_mean("rmse", name, "N", all, error);
  }
  // The way from rest to the target, all digits together.
  const auto parts = parts_of(record);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].phase != Phase::active) continue;
    const NormalForces forces = normal_forces(record, parts[i - 1].first, parts[i].last);
    if (forces.section.rows.empty()) continue;
    deviations.push_back(path_deviation(forces.force_N, forces.section.weight_s));
    paths.push_back(forces.section);
  }
  list.add_mean("path_deviation", "digits", "N", join(paths), deviations);
  return list.take();
}

}  // namespace isograsp::tasks

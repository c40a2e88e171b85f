// SPDX-License-Identifier: GPL-3.0-or-later
// Grip and load of the virtual object, from the forces of the fingers and the share of the friction
// limit that each of them used (utilisation): no measure needs to know the scene.
// Row by row, of the fingers that touch:
//   normal = max(0, fz),  grip = (normal of the thumb + normals of the fingers) / 2
//   load = sum sqrt(fx^2 + fy^2) / 2,  needed = sum utilisation normal / 2
//   used = largest utilisation
// touch_s: how long a row lasts, 0 where nothing touches:
//   impulse = sum touch_s grip,  friction utilisation = 100 (95 % quantile of used by touch_s)
#include <algorithm>
#include <cmath>
#include <functional>

#include "hand/columns.hpp"
#include "statistics/quantile.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/measures/coordination/coupling.hpp"

namespace isograsp::tasks {

namespace {

/// One finger's part in the grasp; spans are empty where the record lacks it.
struct Touch {
  std::span<const double> fx_N, fy_N, fz_N, contact, utilisation;
  [[nodiscard]] bool known() const {
    return !fx_N.empty() && !fy_N.empty() && !fz_N.empty() && !contact.empty() &&
           !utilisation.empty();
  }
  [[nodiscard]] bool touches(std::size_t row) const { return known() && contact[row] > 0.5; }
};

/// The touching fingers together, row by row of a section.
struct Grasp {
  std::vector<bool> opposed;               ///< thumb and another finger touch
  std::vector<double> thumb_N, fingers_N;  ///< normal forces
  std::vector<double> load_N;              ///< half the sum of the tangential forces' sizes
  std::vector<double> needed_N;            ///< half the sum of normal forces that friction needs
  std::vector<double> used;                ///< largest share of a finger's friction limit
  std::vector<double> touch_s, opposed_s;  ///< hold lengths, 0 without touch, without opposition
};

Grasp grasp_of(const Section& section, const std::array<Touch, kFingerCount>& fingers) {
  const std::size_t rows = section.rows.size();
  Grasp grasp;
  grasp.opposed.resize(rows);
  for (auto* column : {&grasp.thumb_N, &grasp.fingers_N, &grasp.load_N, &grasp.needed_N,
                       &grasp.used, &grasp.touch_s, &grasp.opposed_s})
    column->resize(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    const std::size_t row = section.rows[k];
    bool thumb = false;
    bool others = false;
    for (const Finger finger : kFingers) {
      const Touch& touch = fingers[index_of(finger)];
      if (!touch.touches(row)) continue;
      const bool is_thumb = finger == Finger::thumb;
      (is_thumb ? thumb : others) = true;
      const double normal_N = std::max(0.0, touch.fz_N[row]);
      (is_thumb ? grasp.thumb_N : grasp.fingers_N)[k] += normal_N;
      grasp.load_N[k] += 0.5 * std::hypot(touch.fx_N[row], touch.fy_N[row]);
      grasp.needed_N[k] += 0.5 * touch.utilisation[row] * normal_N;
      grasp.used[k] = std::max(grasp.used[k], touch.utilisation[row]);
    }
    grasp.opposed[k] = thumb && others;
    if (thumb || others) grasp.touch_s[k] = section.weight_s[k];
    if (grasp.opposed[k]) grasp.opposed_s[k] = section.weight_s[k];
  }
  return grasp;
}

Coupling coupling_of(const Section& section, const Grasp& grasp) {
  const auto runs = statistics::stretches(section.t_s, grasp.opposed, 0.0);
  auto longest = runs.begin();  // the first of those that are as long
  for (auto run = runs.begin(); run != runs.end(); ++run)
    if (statistics::is_earlier(longest->length_s, run->length_s)) longest = run;
  constexpr Words none = "thumb and fingers did not hold the object together"_text;
  if (longest == runs.end() || longest->end - longest->first < 2) return {none, none, none};
  const auto piece = [&](const std::vector<double>& x) {
    return std::span(x).subspan(longest->first, longest->end - longest->first);
  };
  const auto t_s = piece(section.t_s);
  return grip_load_coupling(
      statistics::on_uniform_grid(t_s, opposing_mean(piece(grasp.thumb_N), piece(grasp.fingers_N))),
      statistics::on_uniform_grid(t_s, piece(grasp.load_N)));
}

/// Size of a finger's tangential force, row by row, and the time in which both fingers touch.
statistics::Computed lateral_correlation(const Section& section, const Touch& thumb,
                                         const Touch& other) {
  std::vector<double> of_thumb_N, of_other_N, both_s;
  for (std::size_t k = 0; k < section.rows.size(); ++k) {
    const std::size_t row = section.rows[k];
    if (!thumb.touches(row) || !other.touches(row)) continue;
    of_thumb_N.push_back(std::hypot(thumb.fx_N[row], thumb.fy_N[row]));
    of_other_N.push_back(std::hypot(other.fx_N[row], other.fy_N[row]));
    both_s.push_back(section.weight_s[k]);
  }
  if (both_s.empty()) return "the two digits did not touch together"_text;
  return correlation(of_thumb_N, of_other_N, both_s);
}

}  // namespace

void add_grasp(std::vector<Measure>& measures, const Record& record,
               std::initializer_list<Phase> phases) {
  std::array<Touch, kFingerCount> fingers;
  bool known = false;
  std::vector<std::string> forces, all;
  for (const Finger finger : kFingers) {
    const std::size_t f = index_of(finger);
    const auto& [x, y, z] = columns::finger_force[f];
    const std::vector<std::string> names{x, y, z, columns::contact[f], columns::utilisation[f]};
    const auto column = [&](std::size_t i) { return record.signals().column(names[i]); };
    const Touch touch{column(0), column(1), column(2), column(3), column(4)};
    known = known || touch.known();
    // Never a contact, not even a 0: the scene lacks this finger.
    if (!touch.known() || !record.constant(columns::contact[f])) continue;
    fingers[f] = touch;
    forces.insert(forces.end(), names.begin(), names.begin() + 3);
    all.insert(all.end(), names.begin(), names.end());
  }
  Section section = record.select(phases, all);
  if (!known) section.reason = "forces, contacts or utilisation of the fingers are missing"_text;
  // The forces are checked alone: beside a contact, which is 1, no force would look small.
  if (Text why = record.unusable(section, forces); section.reason.empty() && !why.empty()) {
    section = {};
    section.reason = std::move(why);
  }
  const Grasp grasp = grasp_of(section, fingers);
  const Coupling coupling = coupling_of(section, grasp);
  const auto add = [&](const char* name, const char* channel, const char* unit,
                       const statistics::Computed& computed) {
    measures.push_back(make_measure(name, channel, unit, section, computed));
  };
  add("grip_load_correlation", "grip", "", coupling.correlation);
  add("grip_load_lag", "grip", "s", coupling.lag_s);
  add("grip_load_slope", "grip", "", coupling.slope);
  const std::vector<double> grip_N = opposing_mean(grasp.thumb_N, grasp.fingers_N);
  const statistics::Computed none = "thumb and fingers did not hold the object together"_text;
  const bool held = std::any_of(grasp.opposed.begin(), grasp.opposed.end(), std::identity());
  add("grip_variation", "grip", "%", held ? variation(grip_N, grasp.opposed_s) : none);
  double impulse_Ns = 0.0;
  for (std::size_t k = 0; k < grip_N.size(); ++k) impulse_Ns += grasp.touch_s[k] * grip_N[k];
  add("impulse", "grip", "N s", impulse_Ns);
  const Touch& thumb = fingers[index_of(Finger::thumb)];
  add("lateral_correlation", "thumb_index", "",
      lateral_correlation(section, thumb, fingers[index_of(Finger::index)]));
  add("lateral_correlation", "thumb_middle", "",
      lateral_correlation(section, thumb, fingers[index_of(Finger::middle)]));
  // Without friction there is no load to be carried, and so no margin.
  const bool rubs =
      std::any_of(grasp.used.begin(), grasp.used.end(), [](double share) { return share > 0.0; });
  constexpr Words smooth = "no finger touched with friction"_text;
  add("safety_margin", "grip", "%",
      rubs ? safety_margin(grip_N, grasp.needed_N, grasp.opposed_s) : statistics::Computed(smooth));
  constexpr double kShare = 0.95;
  statistics::Computed used =
      rubs ? statistics::quantile(grasp.used, grasp.touch_s, kShare) : statistics::Computed(smooth);
  if (used.value) used.value = 100.0 * *used.value;
  add("friction_utilisation", "contact", "%", used);
}

}  // namespace isograsp::tasks

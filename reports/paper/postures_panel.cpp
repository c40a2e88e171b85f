// SPDX-License-Identifier: GPL-3.0-or-later
// What stands below a task with postures.
#include <cmath>
#include <numbers>

#include "reports/findings/arm_findings.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::reports {

namespace {

constexpr std::size_t kMostBands = 2;  ///< beside the dots, in the width of a page
constexpr double kMovementsHeight = 132.0;
constexpr double kMillimetresInMetre = 1000.0;
constexpr double kDegreesInRadian = 180.0 / std::numbers::pi;

Text off_by(const PostureResult& posture) {
  if (!posture.position_error_m || !posture.angle_error_rad) return Known{kNoValue};
  return "%1 mm, %2°"_text(fixed(kMillimetresInMetre * *posture.position_error_m, 1),
                           fixed(kDegreesInRadian * *posture.angle_error_rad, 1));
}

PanelTable table_of_postures(const TaskSection& section, const Speaker& say) {
  const auto limit_s = section.spec->kind.get_if<tasks::PoseMatchingSpec>()->time_limit_s;
  PanelTable table;
  table.caption = say("Postures"_text);
  for (const Words head : {"Posture"_text, "Reached"_text, "Median time"_text, "Off by"_text,
                           "Object turned"_text, "Out of sight"_text})
    table.heads.push_back(say(head));
  table.shares = {0.25, 0.13, 0.16, 0.2, 0.13, 0.13};
  for (const PostureResult& one : section.postures)
    table.rows.push_back(
        {say(Known{one.name}), say("%1 of %2"_text(one.reached, one.asked)),
         say(one.median_s ? "%1 s"_text(fixed(*one.median_s, 1))
                          : "longer than %1 s"_text(fixed(limit_s, 0))),
         say(off_by(one)),
         say(one.rotation_rad ? "%1°"_text(fixed(kDegreesInRadian * *one.rotation_rad, 0))
                              : Text(Known{kNoValue})),
         say(one.unseen ? percent_words(*one.unseen) : Text(Known{kNoValue}))});
  return table;
}

}  // namespace

std::optional<Panel> postures_panel(const TaskSection& section, const Language& language) {
  if (section.postures.empty()) return std::nullopt;
  const Speaker say(language);
  Panel panel;
  panel.of_task = true;
  panel.heading = say("Posture by posture, last session"_text);
  panel.notes.push_back(say(tolerance_words(section)));
  panel.table = table_of_postures(section, say);
  if (!section.poses || section.poses->events.empty()) return panel;
  auto with_band = postures_with_band(section);
  if (with_band.size() > kMostBands) with_band.resize(kMostBands);
  const double share = 1.0 / static_cast<double>(with_band.size() + 1);
  for (const std::string& posture : with_band)
    panel.plots.push_back(
        {say("Turns towards %1"_text(Known{posture})),
         say("How far forearm, wrist and fingers had come on their turns: mean and standard "
             "deviation over the movements of the last session."_text),
         share, kMovementsHeight, [&section, posture, &language](QSizeF size, double unit) {
           return turns_plot(section, posture, size, unit, language);
         }});
  panel.plots.push_back({say("Who begins, who does how much"_text),
                         say("For each movement of the last session when forearm, wrist and "
                             "fingers began to turn, and "
                             "the share of its turn that each had."_text),
                         share, kMovementsHeight, [&section, &language](QSizeF size, double unit) {
                           return sharing_plot(section, size, unit, language);
                         }});
  panel.notes.push_back(say(
      "Turns are drawn from where the object began to turn (0) over the length of the movement; "
      "bands are one standard deviation. Who begins and who does how much describes: neither "
      "more nor less is better."_text));
  return panel;
}

}  // namespace isograsp::reports

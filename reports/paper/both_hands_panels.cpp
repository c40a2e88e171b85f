// SPDX-License-Identifier: GPL-3.0-or-later
// The page of both hands: how they share a force, whether one lags, what they lifted and carried.
#include <algorithm>
#include <cmath>
#include <span>

#include "reports/findings/report_text.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"

namespace isograsp::reports {

namespace {

constexpr std::size_t kNewestRows = 10;  ///< of a long course; plots and tasks show all
constexpr double kCourseHeight = 130.0;

/// Says the cells of one session.
class RowOfSession {
 public:
  RowOfSession(const ReportContent& content, std::size_t session, const Speaker& say) : say_(say) {
    const ReportSession& of = content.sessions[session];
    add(listed({"%1"_text(of.number), day_words(of.date)}));
  }
  void add(const Text& text) { cells_.push_back(say_(text)); }
  void add(const std::optional<double>& value, const char* unit) {
    cells_.push_back(value ? say_(value_number(*value, unit)) : std::string(kNoValue));
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(cells_); }

 private:
  const Speaker& say_;
  std::vector<std::string> cells_;
};

template <class Row>
std::span<const Row> newest(const std::vector<Row>& rows) {
  const std::span<const Row> all(rows);
  return all.last(std::min(all.size(), kNewestRows));
}

std::vector<std::string> said_heads(const Speaker& say, std::initializer_list<Words> heads) {
  std::vector<std::string> all;
  for (const Words head : heads) all.push_back(say(head));
  return all;
}

Text lag_words(double lag_s) {
  constexpr double kTogether_s = 0.005;  // half a frame: printed as 0.00
  if (std::abs(lag_s) < kTogether_s) return "It moves together with the other one."_text;
  return lag_s > 0.0 ? "It follows the other one by %1 s."_text(fixed(lag_s, 2))
                     : "It goes before the other one by %1 s."_text(fixed(-lag_s, 2));
}

/// The newest session in sentences.
Text sharing_words(const HandsShared& row, const ReportSession& session) {
  constexpr double kPercent = 0.01;
  if (!row.affected)
    return "Session %1, %2: which hand is affected is not known, so that there are no shares."_text(
        session.number, day_words(session.date));
  if (!row.share_percent)
    return "Session %1, %2: there is no share; its task below says why."_text(
        session.number, day_words(session.date));
  const Text gives =
      (*row.affected == Hand::left
           ? "Session %1, %2: the left hand, which is affected, gives %3 of the force."_text
           : "Session %1, %2: the right hand, which is affected, gives %3 of the "
             "force."_text)(session.number, day_words(session.date),
                            percent_words(kPercent * *row.share_percent));
  return joined({gives,
                 row.capacity_percent ? "Of what both hands can do it can do %1."_text(
                                            percent_words(kPercent * *row.capacity_percent))
                                      : Text(),
                 row.lag_s ? lag_words(*row.lag_s) : Text()});
}

PanelTable sharing_table(const ReportContent& content, const Speaker& say) {
  PanelTable table{say("Sharing a force"_text),
                   said_heads(say, {"Session"_text, "Left hand [N]"_text, "Right hand [N]"_text,
                                    "Share [%]"_text, "Share of capacity [%]"_text,
                                    "Share of effort [%]"_text, "Lag [s]"_text, "Synergy"_text}),
                   {0.17, 0.12, 0.12, 0.1, 0.15, 0.14, 0.1, 0.1},
                   {}};
  for (const HandsShared& one : newest(content.both_hands.shared)) {
    RowOfSession row(content, one.session, say);
    for (const Hand hand : kBothHands) row.add(one.above_rest_N[hand], "N");
    row.add(one.share_percent, "%");
    row.add(one.capacity_percent, "%");
    row.add(one.effort_percent, "%");
    row.add(one.lag_s, "s");
    row.add(one.synergy, "");
    table.rows.push_back(row.take());
  }
  return table;
}

Panel sharing_panel(const ReportContent& content, const Speaker& say) {
  const BothHands& both = content.both_hands;
  Panel panel;
  panel.heading = say("Both hands: sharing a force"_text);
  panel.own_page = true;
  const HandsShared& last = both.shared.back();
  panel.lines.push_back(say(Known{last.task}));
  panel.lines.push_back(say(sharing_words(last, content.sessions[last.session])));
  const auto plot = [&](HandsCourse course, Words title, Words description) {
    panel.plots.push_back(
        {say(title), say(description), 0.5, kCourseHeight,
         [&content, course, &language = say.language()](QSizeF size, double unit) {
           return hands_course_plot(content, course, size, unit, language);
         }});
  };
  plot(HandsCourse::share, "Share of the affected hand"_text,
       "Share of the force and of what both hands can do, over the sessions; the table below holds "
       "the same numbers."_text);
  plot(HandsCourse::lag, "Lag of the affected hand"_text,
       "Above 0 the affected hand follows, below it goes before; the table below holds the same "
       "numbers."_text);
  panel.table = sharing_table(content, say);
  panel.notes.push_back(say(
      "Forces are above rest. A share also rises when the other hand weakens: read both forces "
      "beside it. Share of capacity: of both maxima of one hand alone in the same session. Share "
      "of "
      "effort: of the parts of its own maximum that each hand gives, 50 % where both try alike. "
      "Lag "
      "(above 0: the affected hand follows) and synergy (2: one hand makes up for the other, 0: "
      "each for itself, −2: both waver together) are of research: they describe, and neither more "
      "nor less is better."_text));
  if (!both.other_tasks.empty()) {
    std::vector<Text> names;
    for (const std::string& name : both.other_tasks) names.emplace_back(Known{name});
    panel.notes.push_back(say("Not on this page: %1."_text(listed(names))));
  }
  return panel;
}

Text way_words(const HandsMoved& row) {
  if (!row.carry) return "lifted level"_text;
  if (row.carry->pinch) return row.carry->clutch ? "clutch, pinch"_text : "bubbles, pinch"_text;
  return row.carry->clutch ? "clutch, friction"_text : "bubbles, friction"_text;
}

Panel moving_panel(const ReportContent& content, const Speaker& say) {
  const BothHands& both = content.both_hands;
  Panel panel;
  panel.heading = say("Both hands: lifting and carrying"_text);
  panel.own_page = both.shared.empty();
  PanelTable table{
      say("Lifting and carrying"_text),
      said_heads(say, {"Session"_text, "Task"_text, "Way"_text, "Done"_text, "Dropped"_text,
                       "Mean time [s]"_text, "Tilt [°]"_text, "Share of raising [%]"_text}),
      {0.16, 0.27, 0.15, 0.08, 0.08, 0.09, 0.07, 0.1},
      {}};
  for (const HandsMoved& one : newest(both.moved)) {
    RowOfSession row(content, one.session, say);
    row.add(Known{one.task});
    row.add(way_words(one));
    row.add("%1 of %2"_text(one.done, one.asked));
    row.add("%1"_text(one.drops));
    row.add(one.time_s, "s");
    row.add(one.tilt_rad, "rad");
    row.add(one.raise_percent, "%");
    table.rows.push_back(row.take());
  }
  panel.table = std::move(table);
  panel.notes.push_back(say(
      "Done: lifted, held in the band and level, or placed and let go there, within the time. Mean "
      "time: what was not done counts with the limit. Ways help differently: compare rows of one "
      "way. A level tray gives each hand its half of the raising, whatever the hands can do: less "
      "than 50 % says that the end of the affected hand hangs."_text));
  if (both.moved.size() > kNewestRows)
    panel.notes.push_back(say("The newest %1 rows."_text(kNewestRows)));
  return panel;
}

}  // namespace

std::vector<Panel> both_hands_panels(const ReportContent& content, const Language& language) {
  const Speaker say(language);
  std::vector<Panel> panels;
  if (!content.both_hands.shared.empty()) panels.push_back(sharing_panel(content, say));
  if (!content.both_hands.moved.empty()) panels.push_back(moving_panel(content, say));
  return panels;
}

}  // namespace isograsp::reports

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/grasp_story.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "gui/hand_pages/hand_words.hpp"
#include "gui/trial_pages/recorded_values.hpp"
#include "hand/hand_columns.hpp"
#include "virtual_hand/assistance.hpp"

namespace isograsp::gui {

namespace {

using virtual_hand::DigitSet;
using virtual_hand::GraspChoice;
using What = GraspEvent::What;

struct GraspTexts {
  Q_DECLARE_TR_FUNCTIONS(Hand)
};

constexpr double kTied = static_cast<double>(virtual_hand::DigitState::attached);

/// Columns of the story in the signals.
struct GraspRows {
  explicit GraspRows(const Signals& of) : signals(of) {
    for (std::size_t d = 0; d < kDigitCount; ++d) {
      state[d] = of.find(columns::grasp_state[d]);
      pull[d] = of.find(columns::pull_N[d]);
    }
    limit = of.find(columns::release_pull_N);
    choice = find_choice(of);
    placement = of.find(columns::placement);
    fails = of.find(columns::placement_fails);
    helped = of.find(columns::object_helped);
    to_open = of.find(columns::let_go_asked);
  }
  [[nodiscard]] bool tied(std::size_t digit, std::size_t row) const {
    return value_at(signals, state[digit], row) == kTied;
  }
  /// What the task ordered after a row is seen in the next one.
  [[nodiscard]] bool just_helped(std::size_t row) const {
    const double before = value_at(signals, helped, row >= 2 ? row - 2 : 0);
    return value_at(signals, helped, row) > before;
  }

  const Signals& signals;
  std::array<Place, kDigitCount> state, pull;
  Place limit, placement, fails, helped, to_open;
  ChoicePlaces choice;
};

/// Why a digit is tied no more from this row on.
What why_loose(const GraspRows& rows, std::size_t digit, std::size_t row) {
  if (value_at(rows.signals, rows.placement, row) !=
      value_at(rows.signals, rows.placement, row - 1))
    return What::ended;
  if (rows.just_helped(row)) return What::helped;
  const double pull_N = value_at(rows.signals, rows.pull[digit], row);
  if (pull_N > value_at(rows.signals, rows.limit, row)) return What::pulled;
  return value_at(rows.signals, rows.to_open, row) > 0.0 ? What::placed : What::alone;
}

/// In that row, to no digit yet.
GraspEvent happened(const GraspRows& rows, What what, std::size_t row) {
  GraspEvent event;
  event.t_s = rows.signals.column(columns::t_s)[row];
  event.what = what;
  event.limit_N = value_at(rows.signals, rows.limit, row);
  if (what == What::tied)
    event.grasp = choice_at(rows.signals, rows.choice, row - 1);  // what stood before
  return event;
}

/// Digits to whom the same happens at once share a line; each that pulls has its own number.
void add(std::vector<GraspEvent>& story, const GraspEvent& event) {
  for (auto before = story.rbegin(); before != story.rend() && before->t_s == event.t_s; ++before)
    if (before->what == event.what && event.what != What::pulled) {
      before->digits |= event.digits;
      return;
    }
  story.push_back(event);
}

QString digits_words(DigitSet digits) {
  QStringList names;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if ((digits >> d & 1U) != 0) names << digit_title(static_cast<Digit>(d));
  return names.join(GraspTexts::tr(", "));
}

QString criterion_words(const QString& name, double value, double limit) {
  const auto number = [](double of) { return QLocale().toString(of, 'g', 2); };
  return GraspTexts::tr("%1 %2 > %3").arg(name, number(value), number(limit));
}

QString why_tied(const GraspChoice& grasp) {
  QStringList criteria;
  criteria << criterion_words(criterion_name(0), grasp.G_min, grasp.G_min_limit);
  if (grasp.H_min_limit > 0.0)
    criteria << criterion_words(criterion_name(1), grasp.H_min, grasp.H_min_limit);
  criteria << criterion_words(criterion_name(2), grasp.H_det, grasp.H_det_limit);
  return criteria.join(GraspTexts::tr("; "));
}

}  // namespace

std::vector<GraspEvent> grasp_story(const Signals& signals) {
  std::vector<GraspEvent> story;
  const GraspRows rows(signals);
  if (!rows.state[0]) return story;
  const std::size_t count = signals.rows();
  for (std::size_t row = 1; row < count; ++row) {
    if (value_at(signals, rows.fails, row) > value_at(signals, rows.fails, row - 1))
      add(story, happened(rows, What::dropped, row));
    for (std::size_t d = 0; d < kDigitCount; ++d) {
      const bool now = rows.tied(d, row);
      if (now == rows.tied(d, row - 1)) continue;
      GraspEvent event = happened(rows, now ? What::tied : why_loose(rows, d, row), row);
      event.digits = static_cast<DigitSet>(1U << d);
      event.pull_N = value_at(signals, rows.pull[d], row);
      add(story, event);
    }
  }
  return story;
}

QString words_of(const GraspEvent& event) {
  const auto newtons = [](double force_N) { return QLocale().toString(force_N, 'f', 2); };
  const QString who = digits_words(event.digits);
  switch (event.what) {
    case What::tied:
      if (event.digits == event.grasp.digits)
        return GraspTexts::tr("%1: tied, this grasp holds (%2)").arg(who, why_tied(event.grasp));
      return GraspTexts::tr("%1: tied, the grasp of %2 holds (%3)")
          .arg(who, digits_words(event.grasp.digits), why_tied(event.grasp));
    case What::pulled:
      return GraspTexts::tr("%1: let go, pulled with %2 N > %3 N")
          .arg(who, newtons(event.pull_N), newtons(event.limit_N));
    case What::placed: return GraspTexts::tr("%1: let go as well, the object was placed").arg(who);
    case What::alone: return GraspTexts::tr("%1: let go, what was left held nothing").arg(who);
    case What::helped: return GraspTexts::tr("%1: let go for the person").arg(who);
    case What::dropped: return GraspTexts::tr("The object was dropped");
    case What::ended: return GraspTexts::tr("%1: loose, the placement is over").arg(who);
  }
  return {};
}

}  // namespace isograsp::gui

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
  }
  [[nodiscard]] bool tied(std::size_t digit, std::size_t row) const {
    return value_at(signals, state[digit], row) == kTied;
  }
  /// What the task ordered after a row is seen in the next one.
  [[nodiscard]] bool grew(Place column, std::size_t row) const {
    const double before = value_at(signals, column, row >= 2 ? row - 2 : 0);
    return value_at(signals, column, row) > before;
  }

  const Signals& signals;
  std::array<Place, kDigitCount> state, pull;
  Place limit, placement, fails, helped;
  ChoicePlaces choice;
};

/// Why a digit is tied no more from this row on.
What why_loose(const GraspRows& rows, std::size_t digit, std::size_t row) {
  if (value_at(rows.signals, rows.placement, row) !=
      value_at(rows.signals, rows.placement, row - 1))
    return What::ended;
  if (rows.grew(rows.helped, row)) return What::helped;
  if (rows.grew(rows.fails, row)) return What::dropped;
  const double pull_N = value_at(rows.signals, rows.pull[digit], row);
  return pull_N > value_at(rows.signals, rows.limit, row) ? What::pulled : What::alone;
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
  criteria << criterion_words(GraspTexts::tr("G min"), grasp.G_min, grasp.G_min_limit);
  if (grasp.H_min_limit > 0.0)
    criteria << criterion_words(GraspTexts::tr("H min"), grasp.H_min, grasp.H_min_limit);
  criteria << criterion_words(GraspTexts::tr("H det"), grasp.H_det, grasp.H_det_limit);
  return criteria.join(GraspTexts::tr("; "));
}

}  // namespace

std::vector<GraspEvent> grasp_story(const Signals& signals) {
  std::vector<GraspEvent> story;
  const GraspRows rows(signals);
  if (!rows.state[0]) return story;
  const auto t_s = signals.column(columns::t_s);
  for (std::size_t row = 1; row < t_s.size(); ++row) {
    const std::size_t first = story.size();
    const auto tell = [&](What what, std::size_t digit) {
      for (std::size_t k = first; k < story.size(); ++k)
        if (story[k].what == what && what != What::pulled) {
          story[k].digits |= static_cast<DigitSet>(1U << digit);
          return;
        }
      GraspEvent event;
      event.t_s = t_s[row];
      event.what = what;
      event.digits = static_cast<DigitSet>(1U << digit);
      if (what == What::pulled) {
        event.pull_N = value_at(signals, rows.pull[digit], row);
        event.limit_N = value_at(signals, rows.limit, row);
      } else if (what == What::tied) {
        event.grasp = choice_at(signals, rows.choice, row - 1);  // it is tied by what stood before
      }
      story.push_back(event);
    };
    for (std::size_t d = 0; d < kDigitCount; ++d) {
      const bool now = rows.tied(d, row);
      if (now == rows.tied(d, row - 1)) continue;
      tell(now ? What::tied : why_loose(rows, d, row), d);
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
    case What::alone: return GraspTexts::tr("%1: let go, what was left held nothing").arg(who);
    case What::helped: return GraspTexts::tr("%1: let go for the person").arg(who);
    case What::dropped: return GraspTexts::tr("%1: loose, the object was dropped").arg(who);
    case What::ended: return GraspTexts::tr("%1: loose, the placement is over").arg(who);
  }
  return {};
}

}  // namespace isograsp::gui

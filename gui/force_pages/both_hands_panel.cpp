// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/both_hands_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>

#include "gui/look/look.hpp"
#include "gui/rules/two_hands_live.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

namespace {

QString percent(double value) {
  return QLocale().toString(value, 'f', 0);
}

/// "lost 0, damaged 0"
QString losses(const DeviceHealth& health) {
  std::uint64_t lost = health.bus.kernel_drops;
  std::uint64_t damaged = 0;
  for (const SensorCounters& sensor : health.sensors) {
    lost += sensor.lost;
    damaged += sensor.torn + sensor.invalid;
  }
  return BothHandsPanel::tr("lost %1, damaged %2").arg(lost).arg(damaged);
}

/// "Share of the affected hand (left) 31 %, of effort 48 %"
QString share_words(const HandsLive& live, const tasks::TwoHandsReferences& references) {
  if (!references.affected)
    return BothHandsPanel::tr("No share: the affected side is not on record.");
  if (references.coupled.value_or(false))
    return BothHandsPanel::tr("No share: the platforms move each other.");
  if (!references.of.left.resting_N || !references.of.right.resting_N)
    return BothHandsPanel::tr("Shares are above rest: measure the resting forces first.");
  if (!live.share_affected_percent) return BothHandsPanel::tr("Share: both hands rest.");
  const auto share = (*references.affected == Hand::left
                          ? BothHandsPanel::tr("Share of the affected hand (left) <b>%1 %</b>")
                          : BothHandsPanel::tr("Share of the affected hand (right) <b>%1 %</b>"))
                         .arg(percent(*live.share_affected_percent));
  if (!live.effort_share_affected_percent) return share;
  return BothHandsPanel::tr("%1 · of effort <b>%2 %</b>")
      .arg(share, percent(*live.effort_share_affected_percent));
}

}  // namespace

BothHandsPanel::BothHandsPanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Live forces of both hands"), parent), presenter_(presenter) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(2);
  int row = 0;
  for (const Hand hand : kBothHands) {
    Side& side = of_[hand];
    side.grip = new QLabel;
    side.grip->setObjectName(hand == Hand::left ? "grip_left" : "grip_right");
    side.grip->setMinimumWidth(scaled(96));
    side.grip->setToolTip(
        tr("Grip: the smaller of the thumb and the two fingers together; above rest below it"));
    grid->addWidget(side.grip, row, 0);
    for (const Finger finger : kFingers) {
      side.fingers[index_of(finger)] = new FingerBar(finger);
      side.fingers[index_of(finger)]->setMinimumWidth(scaled(88));
      grid->addWidget(side.fingers[index_of(finger)], row, 1 + static_cast<int>(index_of(finger)));
      grid->setColumnStretch(1 + static_cast<int>(index_of(finger)), 1);
    }
    ++row;
  }
  share_ = new QLabel;
  share_->setObjectName("hands_share");
  share_->setWordWrap(true);
  share_->setToolTip(tr(
      "Mean of the last second above each hand's rest; of effort: each as a part of its maximum. "
      "It also rises when the other hand weakens: look at both forces"));
  plot_ = new HandsPlot;
  take_rest(*plot_, 120);
  describe(
      *plot_, tr("Grip forces of the last 20 seconds"),
      tr("Left L, right R, both L+R, and what is asked of them dashed; the values stand above"));
  column_->addLayout(grid);
  column_->addWidget(share_);
  column_->addWidget(plot_, 1);
  auto* healths = new QHBoxLayout;
  healths->setSpacing(12);
  for (const Hand hand : kBothHands) {
    QLabel*& health = of_[hand].health;
    health = new QLabel;
    health->setObjectName(hand == Hand::left ? "health_left" : "health_right");
    health->setProperty("role", "quiet");
    health->setWordWrap(true);
    healths->addWidget(health, 1);
  }
  column_->addLayout(healths);
  const auto show_for_both = [this] { show_part(*this, measures_both(presenter_.state())); };
  connect(&presenter_.flow(), &SessionFlow::changed, this, show_for_both);
  show_for_both();
  connect(&presenter_.flow(), &SessionFlow::frame, this, &BothHandsPanel::refresh);
  show_words(nullptr);
}

void BothHandsPanel::refresh() {
  // Thirty times a second is enough for the eye; polls come at sixty.
  if (++polls_ % 2 == 0 || !isVisible()) return;
  const auto& open = presenter_.state().open;
  const session::TwoPlatformsSnapshot* const now = open && open->both ? &*open->both : nullptr;
  const HandsHistory& hands = presenter_.state().traces().hands;
  const double full_N = hands.range().most_N;
  for (const Hand hand : kBothHands)
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const double normal_N = now == nullptr ? 0.0 : now->of[hand].forces.wrench_C[f].force.z();
      const std::uint8_t flags = now == nullptr ? 0 : now->of[hand].forces.flags[f];
      of_[hand].fingers[f]->show_force(normal_N, full_N, flags, now != nullptr && now->frames > 0);
    }
  plot_->show_forces(hands);
  // Numbers that change thirty times a second cannot be read: twice is enough.
  constexpr int kTextEvery = 30;
  if (polls_ % kTextEvery == 1) show_words(now);
}

void BothHandsPanel::show_words(const session::TwoPlatformsSnapshot* now) {
  const auto& open = presenter_.state().open;
  const bool known = now != nullptr && now->frames > 0;
  const tasks::TwoHandsReferences references =
      open ? open->session->known().two_hands : tasks::TwoHandsReferences{};
  const HandsLive live = hands_live(presenter_.state().traces().hands, references);
  for (const Hand hand : kBothHands) {
    const Side& side = of_[hand];
    const bool affected = references.affected == hand;
    const auto name = hand == Hand::left ? tr("Left") : tr("Right");
    const auto title = affected ? tr("%1, affected").arg(name) : name;
    const auto grip = known ? tr("%1 N").arg(short_number(now->of[hand].grip_N)) : tr("–");
    const auto& above_N = live.above_rest_N[hand];
    const auto below = known && above_N ? tr("above rest %1 N").arg(short_number(*above_N))
                                        : QString(QChar(QChar::Nbsp));
    side.grip->setText(QStringLiteral("<b>%1</b>\u00a0 <b>%2</b><br><small>%3</small>")
                           .arg(title.toHtmlEscaped(), grip, below));
    side.health->setText((hand == Hand::left ? tr("Left platform: %1") : tr("Right platform: %1"))
                             .arg(known ? losses(now->of[hand].health) : tr("no forces yet")));
    side.health->setToolTip(
        known ? health_line(side_of(*now, hand), presenter_.state().traces().worst_lateness_s)
              : QString());
    for (const Finger finger : kFingers) {
      const auto f = index_of(finger);
      const auto of_hand =
          hand == Hand::left ? tr("Left %1", "a finger") : tr("Right %1", "a finger");
      const auto what = of_hand.arg(in_sentence(finger_title(finger)));
      side.fingers[f]->setAccessibleName(
          known ? tr("%1 %2 N").arg(what, short_number(now->of[hand].forces.wrench_C[f].force.z()))
                : tr("%1, no force yet").arg(what));
    }
  }
  share_->setText(known ? share_words(live, references) : QString());
}

}  // namespace isograsp::gui

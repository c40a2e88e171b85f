// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/arm_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/arm_pages/arm_words.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

namespace {

QString in_mm(double length_m) {
  constexpr double kMmPerM = 1000.0;
  return QLocale().toString(kMmPerM * length_m, 'f', 0);
}

/// "23 mm of 15, 4° of 10".
QString error_words(const ReferenceError& error, const tasks::PoseTolerance& tolerance) {
  const bool near = error.distance_m <= tolerance.position_m;
  const bool turned = error.angle_rad <= tolerance.angle_rad;
  const auto marked = [](bool inside, const QString& words) {
    return inside ? QStringLiteral("✓ %1").arg(words) : words;
  };
  return ArmPanel::tr("Off by <b>%1</b>, <b>%2</b>; %3 mm of it in depth")
      .arg(marked(near, ArmPanel::tr("%1 of %2 mm")
                            .arg(in_mm(error.distance_m), in_mm(tolerance.position_m))),
           marked(turned, ArmPanel::tr("%1° of %2°")
                              .arg(in_degrees(error.angle_rad), in_degrees(tolerance.angle_rad))),
           in_mm(std::abs(error.depth_m)));
}

/// "23°, 63 %".
QString angle_words(const LinkTurns::Turn& turn) {
  if (!turn.angle_rad) return ArmPanel::tr("–");
  const auto angle = ArmPanel::tr("%1°").arg(in_degrees(*turn.angle_rad));
  if (!turn.share_percent) return angle;
  return ArmPanel::tr("%1, %2 %").arg(angle, QLocale().toString(*turn.share_percent, 'f', 0));
}

/// "4:05".
QString minutes_words(double time_s) {
  constexpr int kMinute_s = 60;
  const int whole_s = static_cast<int>(time_s);
  return QStringLiteral("%1:%2")
      .arg(whole_s / kMinute_s)
      .arg(whole_s % kMinute_s, 2, 10, QLatin1Char('0'));
}

/// "Practice 4:05 of 15:00 on a first visit; bout 2: 1:05 of 3:00. Later visits: …"
QString practice_words(const PracticeClock& clock) {
  const auto first = ArmPanel::tr("Practice %1 of %2 on a first visit; bout %3: %4 of %5.")
                         .arg(minutes_words(clock.total_s()), minutes_words(kFirstVisit_s))
                         .arg(clock.bout())
                         .arg(minutes_words(clock.bout_s()), minutes_words(PracticeClock::kBout_s));
  const auto apart = clock.difference();
  if (!apart) return first;
  constexpr double kPercent = 100.0;
  const auto difference = QLocale().toString(kPercent * *apart, 'f', 0);
  return clock.enough_later()
             ? ArmPanel::tr("%1 Last two movements %2 % apart: ✓ enough on a later visit.")
                   .arg(first, difference)
             : ArmPanel::tr("%1 Last two movements %2 % apart: one more on a later visit.")
                   .arg(first, difference);
}

}  // namespace

ArmPanel::ArmPanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Live arm"), parent), presenter_(presenter) {
  make_check();
  make_task();
  make_links();
  constexpr int kLeast_px = 420;
  setMinimumHeight(scaled(kLeast_px));
  views_ = new ArmViews;
  column_->addWidget(views_, 3);
  markers_ = new MarkerTable;
  column_->addWidget(markers_, 2);
  remark_ = new QLabel(
      tr("Left arm: targets are those of a right one in the mirror; a screw turns the other way."));
  remark_->setObjectName("arm_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  health_ = new QLabel;
  health_->setObjectName("arm_health");
  health_->setProperty("role", "quiet");
  health_->setWordWrap(true);
  column_->addWidget(remark_);
  column_->addWidget(health_);
  connect(&presenter_.flow(), &SessionFlow::changed, this, [this] {
    show_part(*this, presenter_.state().measures_arm());
    if (!presenter_.state().open) show_nothing();
    check_->refresh();
  });
  connect(&presenter_.flow(), &SessionFlow::frame, this, &ArmPanel::refresh);
  show_part(*this, presenter_.state().measures_arm());
  show_nothing();
}

/// Whether the picture moves as the arm does.
void ArmPanel::make_check() {
  check_ = new PictureCheckView(presenter_, PictureCheckView::Moves::object, this);
  auto* top = new QHBoxLayout;
  column_->removeWidget(title_);
  top->addWidget(title_, 1);
  top->addWidget(check_->button());
  column_->insertLayout(0, top);
  column_->addWidget(check_->words());
}

void ArmPanel::make_task() {
  reached_ = new QLabel;
  reached_->setObjectName("arm_reached");
  error_ = new QLabel;
  error_->setObjectName("arm_error");
  error_->setTextFormat(Qt::RichText);
  error_->setToolTip(
      tr("From the object to its target, beside what counts as there. Depth is along the line of "
         "sight: without a second picture for the other eye it is harder to see"));
  error_->setWordWrap(true);
  auto* line = new QHBoxLayout;
  line->setSpacing(14);
  line->addWidget(reached_, 0, Qt::AlignTop);
  line->addWidget(error_, 1);
  column_->addLayout(line);
  practice_ = new QLabel;
  practice_->setObjectName("arm_practice");
  practice_->setWordWrap(true);
  practice_->setToolTip(
      tr("On a first visit 15 minutes, in bouts of 3 with a rest between them; later until two "
         "movements on end differ by less than 10 %, four at most. Practice is work, too"));
  practice_->hide();
  column_->addWidget(practice_);
}

/// Each link: how far it has turned since the target appeared, and its share of that.
void ArmPanel::make_links() {
  auto* beside = new QHBoxLayout;
  beside->setSpacing(14);
  for (std::size_t k = 0; k < kArmLinkCount; ++k) {
    const auto title = link_title(static_cast<ArmLink>(k));
    LinkRow& row = links_[k];
    row.angle = new QLabel;
    row.angle->setObjectName(QStringLiteral("link_angle_%1").arg(k));
    row.angle->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.share = new QProgressBar;
    row.share->setObjectName(QStringLiteral("link_share_%1").arg(k));
    row.share->setRange(0, 100);
    describe(*row.share, tr("%1: share of the turn").arg(title),
             tr("%1: how far it has turned since the target appeared, as a share of all three")
                 .arg(title));
    auto* one = new QGridLayout;
    one->setHorizontalSpacing(4);
    one->setVerticalSpacing(3);
    one->addWidget(new QLabel(title), 0, 0);
    one->addWidget(row.angle, 0, 1);
    one->addWidget(row.share, 1, 0, 1, 2);
    beside->addLayout(one, 1);
  }
  column_->addLayout(beside);
}

void ArmPanel::show_nothing() {
  reached_->setText(tr("The arm is shown once the cameras are connected."));
  error_->clear();
  for (LinkRow& row : links_) {
    row.angle->setText(angle_words({}));
    row.share->setValue(0);
  }
  views_->show_nothing();
  markers_->show_nothing();
  practice_->hide();
  remark_->hide();
  health_->clear();
  shows_ = false;
}

void ArmPanel::refresh() {
  // Thirty times a second is enough for the eye; polls come at sixty.
  if (++polls_ % 2 == 0 || !isVisible()) return;
  const auto& open = presenter_.state().open;
  if (!open || !open->arm) return;
  if (!std::exchange(shows_, true)) {
    markers_->show_setup(*open->session->known().arm);
    remark_->setVisible(open->session->known().record.hand == Hand::left);
  }
  views_->show_arm(*open->arm, open->arm_space);
  refresh_task(*open);
  refresh_links(*open);
  // Numbers that change thirty times a second cannot be read: twice is enough.
  constexpr int kTextEvery = 30;
  if (polls_ % kTextEvery != 1) return;
  refresh_cameras(*open);
  const PracticeClock& practice = open->traces.practice;
  practice_->setText(practice_words(practice));
  practice_->setVisible(practice.begun() && (!open->trial || open->trial->practice));
}

void ArmPanel::refresh_task(const OpenSession& open) {
  const session::ArmSnapshot& now = *open.arm;
  if (!open.trial || !open.trial->arrived) {
    reached_->setText(now.zeroed ? tr("No trial is running.")
                                 : tr("The start posture has not been measured yet."));
    error_->clear();
    return;
  }
  if (now.angle.shown) {
    reached_->setText(now.angle.ranged
                          ? tr("Turned from %1° to %2°, now %3")
                                .arg(in_degrees(now.angle.least_rad),
                                     in_degrees(now.angle.largest_rad),
                                     now.angle.seen ? tr("%1°").arg(in_degrees(now.angle.now_rad))
                                                    : tr("not seen"))
                          : tr("The range begins in a moment."));
    error_->clear();
    return;
  }
  reached_->setText(
      tr("<b>%1 of %2</b> reached").arg(now.task.targets_reached).arg(now.task.target_count));
  const auto error = error_of(now, *open.arm_space);
  const auto tolerance = open.trial->task->tolerance();
  error_->setText(!error      ? tr("The object is not seen, or no target is shown.")
                  : tolerance ? error_words(*error, *tolerance)
                              : QString());
}

void ArmPanel::refresh_links(const OpenSession& open) {
  const auto turns = open.traces.turns.turns();
  for (std::size_t k = 0; k < kArmLinkCount; ++k) {
    const auto& turn = turns[k];
    links_[k].angle->setText(angle_words(turn));
    links_[k].share->setValue(static_cast<int>(turn.share_percent.value_or(0.0)));
  }
}

void ArmPanel::refresh_cameras(const OpenSession& open) {
  const session::ArmSnapshot& now = *open.arm;
  markers_->show_arm(now, open.traces.markers);
  const MarkerCounters& count = now.health.counters;
  health_->setText(tr("Pictures %1   ·   lost %2   ·   damaged %3   ·   late %L4 ms")
                       .arg(count.good)
                       .arg(count.lost)
                       .arg(count.damaged)
                       .arg(now.lateness_s * 1e3, 0, 'f', 1));
  health_->setToolTip(timing_details(now.timing, presenter_.state().realtime()));
}

}  // namespace isograsp::gui

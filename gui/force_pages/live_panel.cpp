// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/live_panel.hpp"

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "gui/force_pages/compensation_words.hpp"
#include "gui/look/look.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

FingerBar::FingerBar(Finger finger, QWidget* parent) : QWidget(parent), finger_(finger) {
  setMinimumSize(scaled(110), scaled(46));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(tr("%1: normal force, pressing is positive").arg(finger_title(finger)));
  setAccessibleName(tr("%1, no force yet").arg(finger_title(finger)));
}

void FingerBar::show_force(double normal_N, double full_N, std::uint8_t flags, bool known) {
  normal_N_ = normal_N;
  full_N_ = full_N;
  known_ = known;
  remark_.clear();
  if ((flags & bit(SampleFlag::missing)) != 0)
    remark_ = tr("missing");
  else if ((flags & bit(SampleFlag::overload)) != 0)
    remark_ = tr("overload");
  else if ((flags & bit(SampleFlag::saturated)) != 0)
    remark_ = tr("at its limit");
  else if ((flags & bit(SampleFlag::held)) != 0)
    remark_ = tr("held");
  update();
}

void FingerBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto& colour = look::kFingers[index_of(finger_)];
  const qreal bar_px = scaled(12);
  const qreal bar_top = height() - bar_px - 2.0;
  painter.setPen(colour);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  const QRectF line(0, 0, width(), bar_top - 4.0);
  const auto value = known_ ? QStringLiteral("%1 N").arg(short_number(normal_N_)) : tr("–");
  const auto words = remark_.isEmpty() ? value : remark_;
  constexpr qreal kApart_px = 8.0;
  const QFontMetricsF metrics(bold);
  const qreal room = line.width() - metrics.horizontalAdvance(words) - kApart_px;
  const qreal title_px = metrics.horizontalAdvance(finger_title(finger_));
  if (title_px > room) {  // a long name becomes smaller, the number never
    QFont smaller = bold;
    smaller.setPointSizeF(bold.pointSizeF() * std::max(0.5, room / title_px));
    painter.setFont(smaller);
  }
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, finger_title(finger_));
  painter.setFont(bold);
  painter.setPen(remark_.isEmpty() ? look::kText : look::kFault);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, words);

  const QRectF trough(0, bar_top, width(), bar_px);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look::kTrack);
  painter.drawRoundedRect(trough, 4, 4);
  // A tenth of the bar is for pulling.
  const qreal zero = 0.1 * width();
  if (known_) {
    const qreal end = zero + std::clamp(normal_N_ / full_N_, -1.0 / 9.0, 1.0) * (width() - zero);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(std::min(zero, end), bar_top, std::abs(end - zero), bar_px), 3,
                            3);
  }
  painter.setBrush(look::kQuietText);
  painter.drawRect(QRectF(zero - 0.5, bar_top - 2.0, 1.0, bar_px + 4.0));
}

namespace {

/// `maximum_N`: 0: not known, or not asked for.
QString grip_words(const session::Snapshot& snapshot, double maximum_N) {
  constexpr double kPercent = 100.0;
  if (snapshot.frames == 0) return QObject::tr("Grip  –");
  const auto newtons = short_number(snapshot.grip_N);
  const auto grip =
      maximum_N > 0.0
          ? QObject::tr("Grip  <b>%1 N, %2 %</b>")
                .arg(newtons, QLocale().toString(kPercent * snapshot.grip_N / maximum_N, 'f', 0))
          : QObject::tr("Grip  <b>%1 N</b>").arg(newtons);
  const auto push = push_words(snapshot.push);
  if (push.isEmpty()) return grip + QStringLiteral("<br>&nbsp;");
  const bool much = *snapshot.push.share_of_grip_percent >= session::kRemarkablePush_percent;
  return grip + QStringLiteral("<br>") + (much ? QStringLiteral("<b>! %1</b>").arg(push) : push);
}

}  // namespace

LivePanel::LivePanel(SessionPresenter& presenter, const SettingsFile& settings, QWidget* parent)
    : Card(tr("Live forces"), parent), presenter_(presenter), settings_(settings) {
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  for (const Finger finger : kFingers) {
    fingers_[index_of(finger)] = new FingerBar(finger);
    head->addWidget(fingers_[index_of(finger)], 1);
  }
  grip_ = new QLabel;
  grip_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grip_->setMinimumWidth(scaled(92));
  grip_->setToolTip(
      tr("Grip: the smaller of the thumb and the two fingers together. Push: what the whole hand "
         "pushes the platform, in % of the grip; from 20 % on arm or trunk take part"));
  head->addWidget(grip_);
  plot_ = new LivePlot;
  take_rest(*plot_, 150);
  describe(*plot_, tr("Forces of the last 20 seconds"),
           tr("Thumb T, index I, middle M, and the target dashed; the values stand above"));
  health_ = new QLabel;
  health_->setObjectName("health");
  health_->setProperty("role", "quiet");
  health_->setWordWrap(true);
  health_->hide();
  all_ = new QPushButton(tr("All channels"));
  all_->setObjectName("all_channels");
  all_->setCheckable(true);
  all_->setShortcut(QKeySequence("Ctrl+L"));
  describe(*all_, tr("All channels"), tr("All eighteen forces and moments in numbers (Ctrl+L)"));
  channels_ = new ChannelTable;
  channels_->hide();
  compensation_ = new QLabel;
  compensation_->setObjectName("compensation");
  compensation_->setProperty("role", "problem");
  compensation_->setWordWrap(true);
  compensation_->hide();
  auto* top = new QHBoxLayout;
  column_->removeWidget(title_);
  top->addWidget(title_, 1);
  top->addWidget(all_);
  column_->insertLayout(0, top);
  column_->addLayout(head);
  column_->addWidget(plot_, 1);
  column_->addWidget(channels_);
  column_->addWidget(compensation_);
  column_->addWidget(health_);
  connect(all_, &QPushButton::toggled, channels_, &QWidget::setVisible);
  const auto show_for_forces = [this] {
    const SessionState& state = presenter_.state();
    show_part(*this, !state.measures_arm() && !state.measures_hand() && !measures_both(state));
  };
  connect(&presenter_.flow(), &SessionFlow::changed, this, show_for_forces);
  show_for_forces();
  connect(&presenter_.flow(), &SessionFlow::frame, this, &LivePanel::refresh);
  refresh();
}

/// Today's maximum grip, if it is known and forces are to be shown as a share of it; else 0.
double LivePanel::shown_maximum_N() const noexcept {
  const auto& open = presenter_.state().open;
  const bool wanted = settings_.now().share_of_maximum && open;
  return wanted ? open->session->known().maximum_force_N().value_or(0.0) : 0.0;
}

void LivePanel::refresh() {
  // Thirty times a second is enough for the eye; polls come at sixty.
  if (++polls_ % 2 == 0 || !isVisible()) return;
  const auto& now = presenter_.state().snapshot();
  const bool known = now.frames > 0;
  const double full_N = presenter_.state().traces().forces.range().most_N;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    fingers_[f]->show_force(now.forces.wrench_C[f].force.z(), full_N, now.forces.flags[f], known);
  grip_->setText(grip_words(now, shown_maximum_N()));
  plot_->show_forces(presenter_.state().traces().forces);
  // Numbers that change thirty times a second cannot be read: twice is enough.
  constexpr int kTextEvery = 30;
  if (polls_ % kTextEvery != 1) return;
  if (channels_->isVisible()) channels_->show_channels(now);
  // The last state is too old once no more forces arrive.
  const bool arrive = known && presenter_.flow().view().device_mood != Mood::fault;
  const auto beside = arrive ? compensation_words(presenter_.state().compensation()) : QString();
  compensation_->setText(beside);
  compensation_->setVisible(!beside.isEmpty());
  health_->setVisible(all_->isChecked() || !arrive ||
                      presenter_.flow().view().device_mood == Mood::attention);
  health_->setText(health_line(now, presenter_.state().traces().worst_lateness_s));
  health_->setToolTip(
      tr("Health of the stream: gaps are bridged for at most 50 ms, then the trial waits.\n") +
      timing_details(now.timing, presenter_.state().realtime()));
  for (const Finger finger : kFingers) {
    const auto f = index_of(finger);
    fingers_[f]->setAccessibleName(
        known ? tr("%1 %2 N").arg(finger_title(finger),
                                  short_number(now.forces.wrench_C[f].force.z()))
              : tr("%1, no force yet").arg(finger_title(finger)));
  }
}

}  // namespace isograsp::gui

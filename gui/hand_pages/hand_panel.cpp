// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/hand_panel.hpp"

#include <QHBoxLayout>
#include <QLocale>
#include <algorithm>

#include "gui/hand_pages/hand_words.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

QString in_newtons(double force_N) {
  return QLocale().toString(force_N, 'f', 2);
}

/// Criteria go over four decades.
QString criterion_number(double value) {
  return QLocale().toString(value, 'g', 2);
}

QString criterion_title(std::size_t which) {
  switch (which) {
    case 0: return HandPanel::tr("Hold, weakest direction (G min)");
    case 1: return HandPanel::tr("Hand, weakest direction (H min)");
    default: return HandPanel::tr("Hand, on the whole (H det)");
  }
}

/// "90 pictures a second · 2 % of the last 10 s not seen · times lost: 3"
QString tracker_words(const TrackerWatch& watch) {
  const auto rate_Hz = watch.rate_Hz();
  const auto lost = watch.lost_percent();
  if (!rate_Hz || !lost) return HandPanel::tr("Counting the pictures of the tracker …");
  return HandPanel::tr("%1 pictures a second · %2 % of the last 10 s not seen · times lost: %3")
      .arg(QLocale().toString(*rate_Hz, 'f', 0), QLocale().toString(*lost, 'f', 0))
      .arg(watch.gaps());
}

}  // namespace

HandPanel::HandPanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Live hand"), parent), presenter_(presenter) {
  make_head();
  make_digits();
  make_criteria();
  column_->addStretch(1);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &HandPanel::refresh_part);
  connect(&presenter_.flow(), &SessionFlow::frame, this, &HandPanel::refresh);
  refresh_part();
}

void HandPanel::make_head() {
  let_go_ = new QPushButton(tr("Let the object go"));
  let_go_->setObjectName("let_go");
  let_go_->setShortcut(QKeySequence("Ctrl+O"));
  describe(*let_go_, tr("Let the object go"),
           tr("The object falls through the hand; the placement ends as helped, which is no drop "
              "(Ctrl+O)"));
  camera_ = new QLabel(tr("● Camera on"));
  camera_->setObjectName("camera_on");
  camera_->setProperty("role", "problem");
  camera_->setToolTip(
      tr("A camera looks at the person until the session ends. No picture is read or stored"));
  auto* top = new QHBoxLayout;
  column_->removeWidget(title_);
  top->addWidget(title_, 1);
  top->addWidget(camera_);
  top->addWidget(let_go_);
  column_->insertLayout(0, top);
  connect(let_go_, &QPushButton::clicked, this, [this] { presenter_.trials().let_go(); });
  tracker_ = new QLabel;
  tracker_->setObjectName("tracker_rate");
  tracker_->setProperty("role", "quiet");
  tracker_->setWordWrap(true);
  task_ = new QLabel;
  task_->setObjectName("hand_task");
  task_->setWordWrap(true);
  gap_ = new QLabel;
  gap_->setObjectName("hand_gap");
  gap_->setWordWrap(true);
  for (QLabel* line : {tracker_, task_, gap_}) column_->addWidget(line);
}

/// Each digit: what it does, and its pull beside the one that lets go.
void HandPanel::make_digits() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(2, 1);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto title = digit_title(static_cast<Digit>(d));
    const int at = static_cast<int>(d);
    DigitRow& row = digits_[d];
    row.state = new QLabel;
    row.state->setObjectName(QStringLiteral("digit_state_%1").arg(d));
    row.pull = new QProgressBar;
    row.pull->setObjectName(QStringLiteral("digit_pull_%1").arg(d));
    row.pull->setRange(0, 100);
    row.pull->setTextVisible(false);
    describe(*row.pull, tr("%1: pull").arg(title),
             tr("%1: how hard it pulls away, as a share of the pull at which its tie lets go")
                 .arg(title));
    row.pull_words = new QLabel;
    row.pull_words->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(new QLabel(title), at, 0);
    grid->addWidget(row.state, at, 1);
    grid->addWidget(row.pull, at, 2);
    grid->addWidget(row.pull_words, at, 3);
  }
  // Words that come and go move nothing.
  constexpr int kState_px = 90;
  constexpr int kPull_px = 120;
  grid->setColumnMinimumWidth(1, scaled(kState_px));
  grid->setColumnMinimumWidth(3, scaled(kPull_px));
  column_->addLayout(grid);
}

/// The best set of the digits that touch, against the limits for help.
void HandPanel::make_criteria() {
  grasp_ = new QLabel;
  grasp_->setObjectName("grasp_verdict");
  column_->addSpacing(6);
  column_->addWidget(grasp_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  for (std::size_t k = 0; k < criteria_.size(); ++k) {
    CriterionRow& row = criteria_[k];
    const int at = static_cast<int>(k);
    row.value = new QLabel;
    row.value->setObjectName(QStringLiteral("criterion_%1").arg(k));
    row.limit = new QLabel;
    row.limit->setProperty("role", "quiet");
    row.verdict = new QLabel;
    auto* title = new QLabel(criterion_title(k));
    title->setWordWrap(true);
    grid->addWidget(title, at, 0);
    for (QLabel* number : {row.value, row.limit})
      number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(row.value, at, 1);
    grid->addWidget(row.limit, at, 2);
    grid->addWidget(row.verdict, at, 3);
  }
  constexpr int kNumber_px = 70;
  constexpr int kLimit_px = 100;
  constexpr int kVerdict_px = 16;
  grid->setColumnMinimumWidth(1, scaled(kNumber_px));
  grid->setColumnMinimumWidth(2, scaled(kLimit_px));
  grid->setColumnMinimumWidth(3, scaled(kVerdict_px));
  column_->addLayout(grid);
}

void HandPanel::refresh_part() {
  show_part(*this, presenter_.state().measures_hand());
  let_go_->setEnabled(presenter_.flow().view().may_let_go);
  if (!presenter_.state().open) show_no_hand();
}

void HandPanel::show_no_hand() {
  camera_->hide();
  tracker_->setText(tr("The hand is shown once the tracker is connected."));
  task_->clear();
  gap_->clear();
  show_digits(std::nullopt);
  show_criteria(std::nullopt);
}

void HandPanel::refresh() {
  // Numbers that change more often than ten times a second cannot be read.
  constexpr int kEvery = 6;
  if (++polls_ % kEvery != 0 || !isVisible()) return;
  const auto& open = presenter_.state().open;
  if (!open || !open->hand) return;
  const auto live = grasp_live(*open->hand);
  show_tracker(*open);
  show_task(*open, live);
  show_digits(live);
  show_criteria(live);
}

void HandPanel::show_tracker(const OpenSession& open) {
  const session::HandSnapshot& now = *open.hand;
  camera_->setVisible(now.camera_on);
  tracker_->setText(tracker_words(open.traces.tracker));
}

void HandPanel::show_task(const OpenSession& open, const std::optional<GraspLive>& live) {
  const session::HandSnapshot& now = *open.hand;
  const auto gap = now.hand.held
                       ? tr("The hand is not seen.")
                       : tr("Thumb and index %1 mm apart.").arg(in_whole_mm(now.thumb_index_gap_m));
  if (!live) {
    task_->setText(
        now.stage == session::Stage::trial || now.stage == session::Stage::paused
            ? tr("<b>%1 of %2</b> done").arg(now.task.targets_reached).arg(now.task.target_count)
            : tr("No trial is running."));
    gap_->setText(gap);
    return;
  }
  auto words = tr("<b>%1 of %2</b> placed · placement %3 · help: <b>%4</b> · drops <b>%5</b>")
                   .arg(now.task.targets_reached)
                   .arg(now.task.target_count)
                   .arg(live->placement + 1)
                   .arg(level_words(live->level))
                   .arg(live->fails);
  if (live->eased) words = tr("%1 · eased").arg(words);
  if (live->helped)
    words = tr("%1 · <b>let go for the hand</b>").arg(words);
  else if (live->let_go_asked)
    words = tr("%1 · <b>the hand is to open</b>").arg(words);
  task_->setText(words);
  gap_->setText(
      tr("%1 Virtual hand %2 mm from the tracked one.").arg(gap, in_whole_mm(live->tracked_gap_m)));
}

void HandPanel::show_digits(const std::optional<GraspLive>& live) {
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    DigitRow& row = digits_[d];
    const DigitLive digit = live ? live->digits[d] : DigitLive{};
    constexpr double kPercent = 100.0;
    row.state->setText(live ? state_words(digit.state) : tr("–"));
    row.pull->setValue(static_cast<int>(kPercent * digit.share.value_or(0.0)));
    row.pull_words->setText(
        digit.share ? tr("%1 of %2 N").arg(in_newtons(digit.pull_N), in_newtons(*live->release_N))
                    : QString());
  }
}

void HandPanel::show_criteria(const std::optional<GraspLive>& live) {
  const bool touches = live && live->criteria[0];
  const bool tied =
      live && std::any_of(live->digits.begin(), live->digits.end(), [](const DigitLive& digit) {
        return digit.state == virtual_hand::DigitState::attached;
      });
  grasp_->setText(!live            ? tr("Grasp: no object is there.")
                  : !touches       ? tr("Grasp: fewer than two fingers touch.")
                  : live->feasible ? tr("Grasp: ✓ it holds, and may be helped.")
                  : tied           ? tr("Grasp: ✗ only the help holds it.")
                                   : tr("Grasp: ✗ it does not hold yet."));
  for (std::size_t k = 0; k < criteria_.size(); ++k) {
    const auto criterion = live ? live->criteria[k] : std::nullopt;
    CriterionRow& row = criteria_[k];
    row.value->setText(criterion ? criterion_number(criterion->value) : tr("–"));
    row.limit->setText(criterion ? tr("above %1").arg(criterion_number(criterion->limit))
                                 : QString());
    row.verdict->setText(!criterion         ? QString()
                         : criterion->met() ? QStringLiteral("✓")
                                            : QStringLiteral("✗"));
  }
}

}  // namespace isograsp::gui

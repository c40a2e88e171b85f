// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/hand_panel.hpp"

#include <QHBoxLayout>
#include <QLocale>
#include <algorithm>

#include "gui/hand_pages/hand_words.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

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
  grasp_ = new GraspView({}, GraspView::Form::wide);
  column_->addWidget(grasp_);
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
  camera_->hide();  // until a frame says so
  auto* top = new QHBoxLayout;
  column_->removeWidget(title_);
  top->addWidget(title_, 1);
  top->addWidget(camera_);
  check_ = new PictureCheckView(presenter_, PictureCheckView::Moves::hand, this);
  top->addWidget(check_->button());
  top->addWidget(let_go_);
  column_->insertLayout(0, top);
  column_->addWidget(check_->words());
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

void HandPanel::refresh_part() {
  show_part(*this, presenter_.state().measures_hand());
  let_go_->setEnabled(presenter_.flow().view().may_let_go);
  check_->refresh();
  if (!presenter_.state().open) show_no_hand();
}

void HandPanel::show_no_hand() {
  camera_->hide();
  tracker_->setText(tr("The hand is shown once the tracker is connected."));
  task_->clear();
  gap_->clear();
  grasp_->show_grasp(std::nullopt);
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
  grasp_->show_grasp(live);
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

}  // namespace isograsp::gui

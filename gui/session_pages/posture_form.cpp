// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/posture_form.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "gui/arm_pages/arm_words.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

Mood mood_of_arm(StillWatch::State state) {
  switch (state) {
    case StillWatch::State::unseen: return Mood::fault;
    case StillWatch::State::moving: return Mood::attention;
    case StillWatch::State::still: break;
  }
  return Mood::ready;
}

QString words_of_arm_light(const StillWatch& watch) {
  switch (watch.state()) {
    case StillWatch::State::unseen: {
      QStringList missing;
      for (std::size_t k = 0; k < session::kArmChain.size(); ++k)
        if (watch.unseen()[k]) missing += segment_title(session::kArmChain[k]);
      return PostureForm::tr("Not in sight: %1").arg(missing.join(QStringLiteral(", ")));
    }
    case StillWatch::State::moving: return PostureForm::tr("In sight. Hold the arm still.");
    case StillWatch::State::still: break;
  }
  return PostureForm::tr("In sight and still: measure it now.");
}

}  // namespace

PostureForm::PostureForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  light_ = new StateLight(22);
  light_->setObjectName("posture_light");
  words_ = new QLabel;
  words_->setObjectName("posture_words");
  words_->setWordWrap(true);
  measure_ = new QPushButton(tr("Measure the start posture"));
  measure_->setObjectName("start_posture");
  describe(
      *measure_, tr("Measure the start posture"),
      tr("The arm is held still for a second; targets are made for its size (Tab, then space)"));
  progress_ = new QProgressBar;
  progress_->setObjectName("posture_progress");
  progress_->setRange(0, 100);
  describe(*progress_, tr("Measuring the start posture"), tr("Measuring the start posture"));
  progress_->hide();
  auto* state = new QHBoxLayout;
  state->setSpacing(8);
  state->addWidget(light_, 0, Qt::AlignTop);
  state->addWidget(words_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  column->addLayout(state);
  column->addWidget(measure_);
  column->addWidget(progress_);
  connect(measure_, &QPushButton::clicked, this, [this] { presenter_.preparing().set_zero(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &PostureForm::refresh);
  connect(&presenter_.flow(), &SessionFlow::frame, this, &PostureForm::refresh_light);
  refresh();
}

void PostureForm::refresh() {
  const auto& view = presenter_.flow().view();
  show_part(*this, view.start_posture);
  measure_->setEnabled(view.may_zero);
  mark_next(*measure_, view.press == NextPress::zero);
  refresh_light();
}

void PostureForm::refresh_light() {
  const auto& open = presenter_.state().open;
  if (!open || !open->arm) {
    light_->show_mood(Mood::off);
    words_->setText(tr("The arm is looked for once the cameras are connected."));
    return;
  }
  const bool measuring = open->snapshot.stage == session::Stage::zeroing;
  progress_->setVisible(measuring);
  progress_->setValue(static_cast<int>(100.0 * open->snapshot.zero_progress));
  const Mood mood = mood_of_arm(open->still.state());
  if (light_->mood() != mood) light_->show_mood(mood);
  words_->setText(words_of_arm_light(open->still));
}

}  // namespace isograsp::gui

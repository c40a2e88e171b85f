// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/prepare_panel.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/arm_pages/arm_screening_form.hpp"
#include "gui/clinic/patient_course.hpp"
#include "gui/force_pages/both_screening_form.hpp"
#include "gui/force_pages/crosstalk_form.hpp"
#include "gui/force_pages/screening_form.hpp"
#include "gui/hand_pages/hand_screening_form.hpp"
#include "gui/hand_pages/hand_words.hpp"
#include "gui/look/look.hpp"
#include "gui/session_pages/device_forms.hpp"
#include "gui/session_pages/entry_form.hpp"
#include "gui/session_pages/other_hand_button.hpp"
#include "gui/session_pages/patient_form.hpp"
#include "gui/session_pages/posture_form.hpp"
#include "gui/session_pages/protocol_form.hpp"
#include "gui/session_pages/strap_form.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

/// As long as nobody knows what measures, the words fit a device and cameras.
QString words_of(Step step, const FlowView& view) {
  const bool arm = view.start_posture;
  switch (step) {
    case Step::patient: return PreparePanel::tr("Patient");
    case Step::hand:
      return arm               ? PreparePanel::tr("Arm today")
             : view.both_hands ? PreparePanel::tr("Hands today")
                               : PreparePanel::tr("Hand today");
    case Step::screening: return PreparePanel::tr("Screening");
    case Step::device:
      return arm                 ? PreparePanel::tr("Cameras")
             : view.hand_entry   ? PreparePanel::tr("Tracker")
             : view.both_hands   ? PreparePanel::tr("Platforms")
             : view.device_known ? PreparePanel::tr("Device")
                                 : PreparePanel::tr("Device or cameras");
    case Step::zero:
      return arm                 ? PreparePanel::tr("Start posture")
             : view.hand_entry   ? PreparePanel::tr("Entry test")
             : view.both_hands   ? PreparePanel::tr("Zeros, both empty")
             : view.device_known ? PreparePanel::tr("Zero, empty")
                                 : PreparePanel::tr("Zero or start posture");
    case Step::rest:
      return view.both_hands ? PreparePanel::tr("Hands in") : PreparePanel::tr("Hand in");
    case Step::work: return PreparePanel::tr("Protocol");
  }
  return {};
}

}  // namespace

PreparePanel::PreparePanel(SessionPresenter& presenter, SettingsFile& settings, Staff& staff,
                           QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* patient = new PatientForm(presenter_);
  connect(patient, &PatientForm::other_patient, this, &PreparePanel::other_patient);
  const std::array<QWidget*, kStepCount> bodies{patient,
                                                make_hand(),
                                                make_screening(),
                                                new ConnectForm(presenter_, settings, staff),
                                                make_zero(),
                                                new StrapForm(presenter_),
                                                new ProtocolForm(presenter_)};
  row_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(5);
  for (std::size_t i = 0; i < kStepCount; ++i) {
    sections_[i] =
        new StepSection(static_cast<int>(i) + 1,
                        words_of(static_cast<Step>(i), presenter_.flow().view()), bodies[i]);
    row_->addWidget(sections_[i]);
    connect(sections_[i], &StepSection::head_pressed, this, &PreparePanel::head_pressed);
    connect(sections_[i], &StepSection::opened, this, &PreparePanel::opened);
  }
  row_->addStretch(1);
  connect(this, &PreparePanel::opened, this, &PreparePanel::share_room);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &PreparePanel::refresh);
  refresh();
}

/// In a column the steps of the protocol take what is left, while they are shown; in a row all have
/// the same.
void PreparePanel::share_room() {
  const auto work = static_cast<std::size_t>(Step::work);
  const bool shown = sections_[work]->is_open();
  for (std::size_t i = 0; i < kStepCount; ++i)
    row_->setStretch(static_cast<int>(i), folded_ || (i == work && shown) ? 1 : 0);
  row_->setStretch(row_->count() - 1, folded_ || shown ? 0 : 1);
}

void PreparePanel::fold(bool folded) {
  if (folded == folded_) return;
  folded_ = folded;
  row_->setDirection(folded ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  for (auto* section : sections_) section->fold(folded);
  share_room();
}

bool PreparePanel::any_open() const {
  return std::any_of(sections_.begin(), sections_.end(),
                     [](const StepSection* section) { return section->is_open(); });
}

/// The questions before forces, of one hand or of both, about an arm, or about a tracked hand: one
/// of them is shown.
QWidget* PreparePanel::make_screening() {
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(new ScreeningForm(presenter_));
  column->addWidget(new BothScreeningForm(presenter_));
  column->addWidget(new ArmScreeningForm(presenter_));
  column->addWidget(new HandScreeningForm(presenter_));
  return body;
}

/// The empty device, the start posture of an arm, or the entry test of a hand: one is shown.
QWidget* PreparePanel::make_zero() {
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addWidget(new ZeroForm(presenter_));
  column->addWidget(new CrossTalkForm(presenter_));
  column->addWidget(new PostureForm(presenter_));
  column->addWidget(new EntryForm(presenter_));
  return body;
}

QWidget* PreparePanel::make_hand() {
  auto* body = new QWidget;
  const auto make = [&](const char* name, Hand hand) {
    auto* button = new QPushButton;
    button->setObjectName(QLatin1String(name));
    button->setCheckable(true);
    connect(button, &QPushButton::clicked, &presenter_, [this, hand] {
      presenter_.choices().choose_hand(hand);
      refresh();
    });
    return button;
  };
  left_ = make("hand_left", Hand::left);
  right_ = make("hand_right", Hand::right);
  both_ = new QPushButton(tr("Both, on two platforms"));
  both_->setObjectName("hand_both");
  both_->setCheckable(true);
  describe(*both_, tr("Both hands, on two platforms"),
           tr("Each hand on a platform of its own: asked in every session (Tab, then "
              "space)"));
  connect(both_, &QPushButton::clicked, this, [this] {
    presenter_.choices().choose_both_hands();
    refresh();
  });
  confirm_hand_ = new QPushButton;
  confirm_hand_->setObjectName("confirm_hand");
  connect(confirm_hand_, &QPushButton::clicked, this,
          [this] { presenter_.choices().confirm_hand(); });
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(left_);
  row->addWidget(right_);
  auto* column = new QVBoxLayout(body);
  column->setSpacing(7);
  column->addLayout(row);
  column->addWidget(both_);
  column->addWidget(confirm_hand_);
  column->addWidget(new OtherHandButton(presenter_, "other_hand"));
  return body;
}

/// Of a hand, or of an arm.
void PreparePanel::name_sides() {
  const bool arm = presenter_.flow().view().start_posture;
  const auto name = [](QPushButton& button, const QString& text, const QString& key) {
    if (button.text() == text) return;
    button.setText(text);
    const auto plain = QString(text).remove(QLatin1Char('&'));
    describe(button, plain, tr("%1: asked in every session (%2)").arg(plain, key));
  };
  name(*left_, arm ? tr("&Left arm") : tr("&Left hand"), tr("Alt+L"));
  name(*right_, arm ? tr("&Right arm") : tr("&Right hand"), tr("Alt+R"));
  confirm_hand_->setText(arm ? tr("Yes, the less affected arm")
                             : tr("Yes, the less affected hand"));
  describe(*confirm_hand_, confirm_hand_->text(),
           tr("The affected side is the other one; this one is meant (Tab, then space)"));
}

QString PreparePanel::summary_of(Step step) const {
  const auto& view = presenter_.flow().view();
  const auto hand = presenter_.state().choices.today.hand;
  const bool done = view.steps[static_cast<std::size_t>(step)] == StepState::done;
  switch (step) {
    case Step::patient: {
      const auto screen = summary(presenter_.seating().presentation());
      const auto code = QString::fromStdString(presenter_.state().choices.patient);
      return screen.isEmpty() ? code : tr("%1, %2").arg(code, screen);
    }
    case Step::hand:
      if (presenter_.state().choices.today.both) return tr("both");
      return !hand ? QString() : *hand == Hand::left ? tr("left") : tr("right");
    case Step::screening: {
      const auto& today = presenter_.state().choices.today;
      const SessionState& state = presenter_.state();
      return state.measures_arm()    ? summary(today.arm_screening)
             : state.measures_hand() ? summary(today.hand_screening)
             : measures_both(state)  ? summary(today.screenings)
                                     : summary(today.screening);
    }
    case Step::device: return QString::fromStdString(view.device_words);
    case Step::zero:
      if (view.start_posture) return done ? tr("measured") : QString();
      if (view.hand_entry)
        return done ? tr("opens %1 mm").arg(in_whole_mm(presenter_.state().open->hand->opening_m))
                    : QString();
      return done ? tr("set") : presenter_.state().snapshot().zeroed ? tr("once more") : QString();
    case Step::rest: return done ? tr("measured") : QString();
    case Step::work: {
      const auto& guide = presenter_.state().guide();
      if (guide.over()) return tr("finished");
      if (guide.active()) return tr("%1 of %2").arg(guide.acts_done()).arg(guide.acts());
      if (!presenter_.state().has_protocol()) return tr("one by one");
      return translated(presenter_.state().chosen_protocol().spec.name);
    }
  }
  return {};
}

/// A word for each in the row: what was chosen, or which step it is, as its mark says the rest.
QString PreparePanel::folded_words(Step step, const QString& summary) const {
  switch (step) {
    case Step::hand: return hand_words(presenter_.state().choices.today.hand);
    case Step::patient:
    case Step::screening: return summary;
    case Step::device:
    case Step::zero:
    case Step::rest: break;
    case Step::work: return tr("Protocol: %1").arg(summary);
  }
  return words_of(step, presenter_.flow().view());
}

void PreparePanel::refresh() {
  const auto& view = presenter_.flow().view();
  const auto asked = std::count_if(view.steps.begin(), view.steps.end(),
                                   [](StepState state) { return state != StepState::absent; });
  int number = 0;
  for (std::size_t i = 0; i < kStepCount; ++i) {
    sections_[i]->set_title(words_of(static_cast<Step>(i), view));
    const bool counts = view.steps[i] != StepState::absent;
    sections_[i]->show_number(counts ? ++number : 0, static_cast<int>(asked));
    const auto step = static_cast<Step>(i);
    const auto summary = summary_of(step);
    sections_[i]->show_state(view.steps[i], summary, folded_words(step, summary));
  }
  name_sides();
  const auto hand = presenter_.state().choices.today.hand;
  left_->setChecked(hand == Hand::left);
  right_->setChecked(hand == Hand::right);
  both_->setChecked(presenter_.state().choices.today.both);
  both_->setVisible(!view.start_posture && !view.hand_entry);
  both_->setEnabled(view.may_change_hand);
  for (auto* button : {left_, right_}) {
    button->setEnabled(view.may_change_hand);
    mark_choice(*button, view.press == NextPress::hand);
  }
  confirm_hand_->setVisible(presenter_.flow().hand_to_confirm());
  mark_next(*confirm_hand_, view.press == NextPress::confirm_hand);
}

}  // namespace isograsp::gui

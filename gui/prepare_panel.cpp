// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/prepare_panel.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <utility>

#include "gui/device_forms.hpp"
#include "gui/look.hpp"
#include "gui/protocol_form.hpp"
#include "gui/screening_form.hpp"

namespace isograsp {

namespace {

QString title_of(Step step) {
  switch (step) {
    case Step::patient: return PreparePanel::tr("Patient");
    case Step::hand: return PreparePanel::tr("Hand today");
    case Step::screening: return PreparePanel::tr("Screening");
    case Step::device: return PreparePanel::tr("Device");
    case Step::zero: return PreparePanel::tr("Zero, empty");
    case Step::rest: return PreparePanel::tr("Hand in");
    case Step::work: return PreparePanel::tr("Protocol");
  }
  return {};
}

}  // namespace

PreparePanel::PreparePanel(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  const std::array<QWidget*, kStepCount> bodies{make_patient(),
                                                make_hand(),
                                                new ScreeningForm(presenter_),
                                                new ConnectForm(presenter_),
                                                new ZeroForm(presenter_),
                                                new StrapForm(presenter_),
                                                new ProtocolForm(presenter_)};
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  for (std::size_t i = 0; i < kStepCount; ++i) {
    sections_[i] = new Section(static_cast<int>(i) + 1, title_of(static_cast<Step>(i)), bodies[i]);
    column->addWidget(sections_[i]);
  }
  column->addStretch(1);
  // The steps of the protocol take what is left, while they are shown.
  const auto share = [this, column] {
    const bool shown = sections_[static_cast<std::size_t>(Step::work)]->is_open();
    column->setStretch(static_cast<int>(Step::work), shown ? 1 : 0);
    column->setStretch(column->count() - 1, shown ? 0 : 1);
  };
  connect(sections_[static_cast<std::size_t>(Step::work)], &Section::opened, this, share);
  connect(&presenter_, &SessionPresenter::changed, this, &PreparePanel::refresh);
  refresh();
}

QWidget* PreparePanel::make_patient() {
  auto* body = new QWidget;
  patients_ = new QPushButton(tr("Choose or add a p&atient"));
  patients_->setObjectName("other_patient");
  describe(*patients_, tr("Choose or add a patient"), tr("Opens the list of patients (Alt+A)"));
  connect(patients_, &QPushButton::clicked, this, &PreparePanel::other_patient);
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(patients_);
  return body;
}

QWidget* PreparePanel::make_hand() {
  auto* body = new QWidget;
  const auto make = [&](const QString& text, const QString& name, const QString& key, Hand hand) {
    auto* button = new QPushButton(text);
    button->setObjectName(hand == Hand::left ? "hand_left" : "hand_right");
    button->setCheckable(true);
    describe(*button, name, tr("%1: asked in every session (%2)").arg(name, key));
    connect(button, &QPushButton::clicked, &presenter_, [this, hand] {
      presenter_.choose_hand(hand);
      refresh();
    });
    return button;
  };
  left_ = make(tr("&Left hand"), tr("Left hand"), tr("Alt+L"), Hand::left);
  right_ = make(tr("&Right hand"), tr("Right hand"), tr("Alt+R"), Hand::right);
  confirm_hand_ = new QPushButton(tr("Yes, the less affected hand"));
  confirm_hand_->setObjectName("confirm_hand");
  describe(*confirm_hand_, tr("Yes, today the less affected hand"),
           tr("The hand on the affected side is another one; this one is meant (Tab, then space)"));
  connect(confirm_hand_, &QPushButton::clicked, &presenter_, &SessionPresenter::confirm_hand);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(left_);
  row->addWidget(right_);
  auto* column = new QVBoxLayout(body);
  column->setSpacing(7);
  column->addLayout(row);
  column->addWidget(confirm_hand_);
  return body;
}

QString PreparePanel::summary_of(Step step) const {
  const auto& view = presenter_.view();
  const auto hand = presenter_.hand();
  switch (step) {
    case Step::patient: return QString::fromStdString(presenter_.patient());
    case Step::hand: return !hand ? QString() : *hand == Hand::left ? tr("left") : tr("right");
    case Step::screening: return summary(presenter_.screening());
    case Step::device: return QString::fromStdString(view.device_words);
    case Step::zero: return presenter_.snapshot().zeroed ? tr("set") : QString();
    case Step::rest:
      return view.steps[static_cast<std::size_t>(Step::rest)] == StepState::done ? tr("measured")
                                                                                 : QString();
    case Step::work: {
      const auto& guide = presenter_.guide();
      if (guide.over()) return tr("finished");
      if (guide.active()) return tr("%1 of %2").arg(guide.acts_done()).arg(guide.acts());
      const int chosen = presenter_.protocol();
      if (chosen == SessionPresenter::kByHand) return tr("one by one");
      return QString::fromStdString(
          presenter_.protocols()[static_cast<std::size_t>(chosen)].spec.name);
    }
  }
  return {};
}

void PreparePanel::refresh() {
  const auto& view = presenter_.view();
  for (std::size_t i = 0; i < kStepCount; ++i)
    sections_[i]->show_state(view.steps[i], summary_of(static_cast<Step>(i)));
  // Each of these is asked for at a time that is not its turn in the list.
  const auto turn = [&](Step step, bool now, bool& before) {
    if (now != std::exchange(before, now)) sections_[static_cast<std::size_t>(step)]->open(now);
  };
  turn(Step::zero, presenter_.zero_is_next() && presenter_.snapshot().zeroed, zero_again_);
  turn(Step::work, presenter_.earlier() && !presenter_.goes_on_earlier(), earlier_asked_);
  patients_->setEnabled(view.may_change_patient);
  mark_next(*patients_, view.next() == Step::patient && view.may_change_patient);
  const auto hand = presenter_.hand();
  left_->setChecked(hand == Hand::left);
  right_->setChecked(hand == Hand::right);
  for (auto* button : {left_, right_}) {
    button->setEnabled(view.may_change_hand);
    mark_next(*button, view.next() == Step::hand && !presenter_.hand_to_confirm());
  }
  confirm_hand_->setVisible(presenter_.hand_to_confirm());
  mark_next(*confirm_hand_, true);
}

}  // namespace isograsp

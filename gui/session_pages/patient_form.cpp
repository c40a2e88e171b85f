// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/patient_form.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

using PlaceHalf = Presentation::Half;

/// In the order of PatientForm::switches_.
constexpr std::array<bool Presentation::*, 4> kPatientSwitches{
    &Presentation::calm, &Presentation::sound, &Presentation::hear, &Presentation::voice};
constexpr std::array<const char*, 4> kNames{"screen_calm", "screen_sound", "screen_hear",
                                            "screen_voice"};

}  // namespace

PatientForm::PatientForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  patients_ = new QPushButton(tr("Choose or add a p&atient"));
  patients_->setObjectName("other_patient");
  describe(*patients_, tr("Choose or add a patient"), tr("Opens the list of patients (Alt+A)"));
  connect(patients_, &QPushButton::clicked, this, &PatientForm::other_patient);
  half_ = new ChoiceBox;
  half_->setObjectName("screen_half");
  half_->addItem(tr("the whole screen"), static_cast<int>(PlaceHalf::whole));
  half_->addItem(tr("the left half"), static_cast<int>(PlaceHalf::left));
  half_->addItem(tr("the right half"), static_cast<int>(PlaceHalf::right));
  describe(
      *half_, tr("What the patient sees"),
      tr("For somebody with half the field of view: all is shown on that side (Tab, then arrow "
         "keys)"));
  const std::array<QString, 4> words{tr("Calm: nothing scrolls"), tr("Sounds"),
                                     tr("Force can be heard"), tr("Instructions are spoken")};
  const std::array<QString, 4> hints{
      tr("The target stands still while the mark crosses it, fingers do not approach"),
      tr("Soft tones for begin, success and targets"),
      tr("A tone that is higher above the target, lower below it and quiet on it"),
      tr("By the voice of this computer, in the language of the window")};
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  column->addWidget(patients_);
  auto* sees = new QHBoxLayout;
  auto* label = new QLabel(tr("Sees"));
  label->setBuddy(half_);
  sees->addWidget(label);
  sees->addWidget(half_, 1);
  column->addLayout(sees);
  for (std::size_t i = 0; i < kPatientSwitches.size(); ++i) {
    auto* box = switches_[i] = new QCheckBox(words[i]);
    box->setObjectName(kNames[i]);
    describe(*box, words[i], tr("%1 (Tab, then space)").arg(hints[i]));
    column->addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, i](bool on) {
      Presentation presentation = presenter_.seating().presentation();
      presentation.*kPatientSwitches[i] = on;
      presenter_.seating().say_presentation(presentation);
    });
  }
  connect(half_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    Presentation presentation = presenter_.seating().presentation();
    presentation.half = static_cast<PlaceHalf>(half_->currentData().toInt());
    presenter_.seating().say_presentation(presentation);
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &PatientForm::refresh);
  refresh();
}

void PatientForm::refresh() {
  const auto& view = presenter_.flow().view();
  const auto& presentation = presenter_.seating().presentation();
  patients_->setEnabled(view.may_change_patient);
  mark_next(*patients_, view.press == NextPress::patient);
  half_->setCurrentIndex(half_->findData(static_cast<int>(presentation.half)));
  half_->setEnabled(!presenter_.state().choices.patient.empty());
  for (std::size_t i = 0; i < kPatientSwitches.size(); ++i) {
    const QSignalBlocker quiet(switches_[i]);
    switches_[i]->setChecked(presentation.*kPatientSwitches[i]);
    switches_[i]->setEnabled(!presenter_.state().choices.patient.empty());
  }
}

}  // namespace isograsp::gui

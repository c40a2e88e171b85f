// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_panel.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "gui/look.hpp"

namespace isograsp {

PatientPanel::PatientPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : Card({}, parent), clinic_(clinic), presenter_(presenter) {
  title_->setText(tr("&Patient"));
  search_ = new QLineEdit;
  search_->setObjectName("patient_search");
  search_->setPlaceholderText(tr("Search a code"));
  search_->setClearButtonEnabled(true);
  describe(*search_, tr("Search patients"), tr("Type a part of the code (Ctrl+F)"));
  list_ = new QListWidget;
  list_->setObjectName("patient_list");
  take_rest(*list_, 64);
  describe(*list_, tr("Patients"), tr("Choose the patient of this session (Alt+P)"));
  title_->setBuddy(list_);
  empty_ = new QLabel;
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  add_ = new QPushButton(tr("&Add patient"));
  add_->setObjectName("add_patient");
  describe(*add_, tr("Add patient"),
           tr("Add a patient with a generated code; names are never stored (Alt+A)"));
  column_->addWidget(search_);
  column_->addWidget(empty_);
  column_->addWidget(list_, 1);
  column_->addWidget(add_);

  connect(search_, &QLineEdit::textChanged, this, &PatientPanel::fill);
  connect(list_, &QListWidget::currentTextChanged, this, [this](const QString& code) {
    if (!code.isEmpty()) presenter_.choose_patient(code.toStdString());
  });
  connect(add_, &QPushButton::clicked, &clinic_, &Clinic::add_patient);
  connect(&clinic_, &Clinic::patients_changed, this, &PatientPanel::fill);
  connect(&clinic_, &Clinic::patient_added, this, [this](const QString& code) {
    search_->clear();
    presenter_.choose_patient(code.toStdString());
    fill();
  });
  connect(&presenter_, &SessionPresenter::changed, this, &PatientPanel::refresh);
  fill();
  refresh();
}

void PatientPanel::fill() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  const auto chosen = QString::fromStdString(presenter_.patient());
  // Newest first: the patient who was added last is the likeliest one to be sought.
  const auto& patients = clinic_.patients();
  for (auto patient = patients.rbegin(); patient != patients.rend(); ++patient) {
    const auto code = QString::fromStdString(patient->code);
    if (!code.contains(search_->text().trimmed(), Qt::CaseInsensitive)) continue;
    list_->addItem(code);
    list_->item(list_->count() - 1)->setSizeHint({0, 24});
    if (code == chosen) list_->setCurrentRow(list_->count() - 1);
  }
  empty_->setVisible(list_->count() == 0);
  empty_->setText(patients.empty() ? tr("No patients yet. Add the first one.")
                                   : tr("No code contains this text."));
}

void PatientPanel::refresh() {
  const auto& view = presenter_.view();
  list_->setEnabled(view.may_change_patient);
  add_->setEnabled(view.may_change_patient);
  const bool next = view.next() == Step::patient && view.may_change_patient;
  mark_next(*add_, next && clinic_.patients().empty());
  mark_next(*list_, next && !clinic_.patients().empty());
}

HandPanel::HandPanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Hand in the device today"), parent), presenter_(presenter) {
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
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(left_);
  row->addWidget(right_);
  column_->addLayout(row);
  connect(&presenter_, &SessionPresenter::changed, this, &HandPanel::refresh);
  refresh();
}

void HandPanel::refresh() {
  const auto& view = presenter_.view();
  const auto hand = presenter_.hand();
  left_->setChecked(hand == Hand::left);
  right_->setChecked(hand == Hand::right);
  const bool next = view.next() == Step::hand;
  for (auto* button : {left_, right_}) {
    button->setEnabled(view.may_change_hand);
    mark_next(*button, next);
  }
}

}  // namespace isograsp

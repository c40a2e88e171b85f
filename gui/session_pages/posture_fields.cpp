// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/posture_fields.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kLongestMark = 60;  // letters

}  // namespace

QWidget* PostureFields::Field::widget() const {
  return choice != nullptr ? static_cast<QWidget*>(choice) : written;
}

std::string PostureFields::Field::value() const {
  const auto text =
      choice != nullptr ? choice->currentData().toString() : written->text().trimmed();
  return text.toStdString();
}

PostureFields::PostureFields(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(5);
  of_hands_ = make_heads();
  grid->addWidget(of_hands_, 0, 0, 1, 2);
  for (const auto item : kPostureOrder) {
    const auto i = static_cast<std::size_t>(item);
    const int row = static_cast<int>(i) + 1;
    fields_[i] = make_field(item);
    auto* label = new QLabel(words_of(item));
    label->setBuddy(fields_[i].widget());
    grid->addWidget(label, row, 0);
    grid->addWidget(fields_[i].widget(), row, 1);
  }
  grid->setColumnStretch(1, 1);
}

QWidget* PostureFields::make_heads() {
  auto* heads = new QWidget;
  auto* row = new QHBoxLayout(heads);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  for (const Hand hand : kBothHands) {
    auto* head = heads_[hand] =
        new QPushButton(hand == Hand::left ? tr("Left hand") : tr("Right hand"));
    head->setObjectName(hand == Hand::left ? "posture_of_left" : "posture_of_right");
    head->setCheckable(true);
    describe(*head, head->text(), tr("Posture and straps of this hand (Tab, then space)"));
    row->addWidget(head);
    connect(head, &QPushButton::clicked, this, [this, hand] { show_hand(hand); });
  }
  return heads;
}

PostureFields::Field PostureFields::make_field(PostureItem item) {
  Field field;
  const auto& choices = choices_of(item);
  if (choices.empty()) {
    field.written = new QLineEdit;
    field.written->setMaxLength(kLongestMark);
    connect(field.written, &QLineEdit::editingFinished, this, &PostureFields::say);
  } else {
    field.choice = new ChoiceBox;
    field.choice->addItem(words_of(item, ""), QString());
    for (const char* choice : choices)
      field.choice->addItem(words_of(item, choice), QString(choice));
    connect(field.choice, QOverload<int>::of(&QComboBox::activated), this, &PostureFields::say);
  }
  field.widget()->setObjectName(QStringLiteral("posture_%1").arg(QLatin1String(name_of(item))));
  return field;
}

Hand PostureFields::hand() const {
  const SessionState& state = presenter_.state();
  return measures_both(state) ? of_both_ : state.choices.today.hand.value_or(Hand::right);
}

void PostureFields::show_hand(Hand hand) {
  say();  // what is being written is of the hand that was shown
  of_both_ = hand;
  refresh();
}

void PostureFields::say() {
  if (seen_ != hand()) return;  // values of the other hand
  SittingPosture posture;
  for (const auto item : kPostureOrder)
    posture.of(item) = fields_[static_cast<std::size_t>(item)].value();
  presenter_.seating().say_posture(hand(), posture);
}

void PostureFields::show_value(const Field& field, PostureItem item,
                               const std::string& value) const {
  const auto stored = QString::fromStdString(value);
  if (field.choice != nullptr) {
    // A value of another station is kept, in its own words.
    if (field.choice->findData(stored) < 0) field.choice->addItem(words_of(item, value), stored);
    field.choice->setCurrentIndex(field.choice->findData(stored));
  } else if (!field.written->hasFocus() || seen_ != hand()) {
    const QSignalBlocker quiet(field.written);
    field.written->setText(stored);
  }
}

void PostureFields::name_fields() {
  const bool both = measures_both(presenter_.state());
  for (const auto item : kPostureOrder) {
    const Field& field = fields_[static_cast<std::size_t>(item)];
    QString name = words_of(item);
    if (both && item != PostureItem::seat)
      name = (hand() == Hand::left ? tr("%1, left hand") : tr("%1, right hand")).arg(name);
    describe(*field.widget(), name,
             (field.choice == nullptr ? tr("%1: the marks as written on them (Tab)")
                                      : tr("%1 (Tab, then arrow keys)"))
                 .arg(name));
  }
}

void PostureFields::refresh() {
  of_hands_->setVisible(measures_both(presenter_.state()));
  for (const Hand one : kBothHands) heads_[one]->setChecked(one == of_both_);
  const SittingPosture& posture = presenter_.seating().posture(hand());
  for (const auto item : kPostureOrder)
    show_value(fields_[static_cast<std::size_t>(item)], item, posture.of(item));
  seen_ = hand();
  name_fields();
}

}  // namespace isograsp::gui

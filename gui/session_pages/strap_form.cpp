// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/strap_form.hpp"

#include <QGridLayout>
#include <QSignalBlocker>
#include <QStringList>
#include <QVBoxLayout>

#include "gui/force_pages/safety_form.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kLongestMark = 60;  // letters

/// "chair with back, elbow 90°, …"
QString in_words(const SittingPosture& posture) {
  QStringList words;
  for (const auto item : kPostureOrder) {
    if (posture.of(item).empty()) continue;
    const auto value = words_of(item, posture.of(item));
    words += item == PostureItem::seat
                 ? value
                 : StrapForm::tr("%1 %2").arg(in_sentence(words_of(item)), value);
  }
  return words.join(QStringLiteral(", "));
}

}  // namespace

StrapForm::StrapForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  posture_ = new QLabel;
  posture_->setObjectName("posture");
  posture_->setWordWrap(true);
  edit_ = new QPushButton(tr("Posture an&d straps …"));
  edit_->setObjectName("posture_edit");
  edit_->setCheckable(true);
  describe(*edit_, tr("Posture and straps"),
           tr("Say how the patient sits and where the straps are (Alt+D)"));
  fields_ = make_fields();
  fields_->hide();
  deviations_ = new QLabel;
  deviations_->setObjectName("posture_deviations");
  deviations_->setProperty("role", "problem");
  deviations_->setWordWrap(true);
  strapped_ = new QPushButton;
  strapped_->setObjectName("strapped");
  words_ = new QLabel;
  words_->setObjectName("strap_words");
  words_->setProperty("role", "quiet");
  words_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  for (QWidget* widget :
       {static_cast<QWidget*>(posture_), static_cast<QWidget*>(edit_), fields_,
        static_cast<QWidget*>(deviations_), static_cast<QWidget*>(new SafetyForm(presenter_)),
        static_cast<QWidget*>(strapped_), static_cast<QWidget*>(words_)})
    column->addWidget(widget);
  connect(edit_, &QPushButton::toggled, fields_, &QWidget::setVisible);
  connect(strapped_, &QPushButton::clicked, this, [this] {
    edit_->setChecked(false);
    presenter_.preparing().mark_strapped();
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &StrapForm::refresh);
  refresh();
}

QWidget* StrapForm::make_fields() {
  auto* fields = new QWidget;
  auto* grid = new QGridLayout(fields);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(5);
  for (const auto item : kPostureOrder) {
    const auto i = static_cast<std::size_t>(item);
    const auto name = QStringLiteral("posture_%1").arg(QLatin1String(name_of(item)));
    const auto& choices = choices_of(item);
    QWidget* field = nullptr;
    if (choices.empty()) {
      field = written_[i] = new QLineEdit;
      written_[i]->setMaxLength(kLongestMark);
      connect(written_[i], &QLineEdit::editingFinished, this, &StrapForm::say);
    } else {
      auto* box = choices_[i] = new ChoiceBox;
      box->addItem(words_of(item, ""), QString());
      for (const char* choice : choices) box->addItem(words_of(item, choice), QString(choice));
      connect(box, QOverload<int>::of(&QComboBox::activated), this, &StrapForm::say);
      field = box;
    }
    field->setObjectName(name);
    describe(*field, words_of(item),
             choices.empty() ? tr("%1: the marks as written on them (Tab)").arg(words_of(item))
                             : tr("%1 (Tab, then arrow keys)").arg(words_of(item)));
    auto* label = new QLabel(words_of(item));
    label->setBuddy(field);
    grid->addWidget(label, static_cast<int>(i), 0);
    grid->addWidget(field, static_cast<int>(i), 1);
  }
  grid->setColumnStretch(1, 1);
  return fields;
}

void StrapForm::say() {
  SittingPosture posture;
  for (const auto item : kPostureOrder) {
    const auto i = static_cast<std::size_t>(item);
    const auto value = choices_[i] != nullptr ? choices_[i]->currentData().toString()
                                              : written_[i]->text().trimmed();
    posture.of(item) = value.toStdString();
  }
  presenter_.seating().say_posture(posture);
}

void StrapForm::refresh() {
  const auto& view = presenter_.flow().view();
  const auto& posture = presenter_.seating().posture();
  const auto& last = presenter_.seating().last_posture();
  for (const auto item : kPostureOrder) {
    const auto i = static_cast<std::size_t>(item);
    const auto value = QString::fromStdString(posture.of(item));
    if (auto* box = choices_[i]) {
      // A value of another station is kept, in its own words.
      if (box->findData(value) < 0) box->addItem(words_of(item, posture.of(item)), value);
      box->setCurrentIndex(box->findData(value));
    } else if (!written_[i]->hasFocus()) {
      const QSignalBlocker quiet(written_[i]);
      written_[i]->setText(value);
    }
  }
  const bool as_last_time = last.said() && posture == last;
  posture_->setText(as_last_time     ? tr("As last time: %1.").arg(in_words(posture))
                    : posture.said() ? tr("Now: %1.").arg(in_words(posture))
                                     : QString());
  posture_->setVisible(posture.said());
  const auto differs = deviations(posture, last);
  deviations_->setText(tr("Not as last time: %1.").arg(differs));
  deviations_->setVisible(!differs.isEmpty());
  const bool both = view.both_hands;
  strapped_->setText(both && as_last_time ? tr("Both hands &in, as last time")
                     : both               ? tr("Both hands are &in")
                     : as_last_time       ? tr("Hand &in, strapped, as last time")
                                          : tr("Hand is &in and strapped"));
  describe(*strapped_, strapped_->text().remove(QLatin1Char('&')),
           tr("It is as said above. From now a minute to settle, then the resting force can be "
              "measured (Alt+I)"));
  strapped_->setEnabled(view.may_strap);
  mark_next(*strapped_, view.press == NextPress::strap);
  const auto rest = presenter_.state().rest_words();
  words_->setText(rest.empty() ? tr("After a minute of settling the resting force is measured.")
                               : translated(rest));
}

}  // namespace isograsp::gui

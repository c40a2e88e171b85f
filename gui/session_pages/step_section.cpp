// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/step_section.hpp"

#include <QHBoxLayout>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/look/look.hpp"

namespace isograsp::gui {

/// What came of a step: its beginning is shown, the tooltip of the step has all of it.
class StepSummary final : public QLabel {
 public:
  void show_words(const QString& words) {
    words_ = words;
    fit();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    fit();
  }

 private:
  void fit() { setText(fontMetrics().elidedText(words_, Qt::ElideRight, width())); }
  QString words_;
};

StepSection::StepSection(int place, const QString& title, QWidget* body, QWidget* parent)
    : QFrame(parent),
      number_(place),
      count_(static_cast<int>(kStepCount)),
      title_(title),
      body_(body) {
  setProperty("section", "open");
  head_ = new QPushButton;
  head_->setObjectName(QStringLiteral("section_%1").arg(place));
  head_->setProperty("flat_head", true);
  head_->setMinimumHeight(scaled(30));
  mark_ = new QLabel;
  mark_->setFixedWidth(scaled(20));
  mark_->setAlignment(Qt::AlignCenter);
  name_ = new QLabel(title);
  summary_ = new StepSummary;
  summary_->setObjectName(QStringLiteral("summary_%1").arg(place));
  summary_->setProperty("role", "quiet");
  summary_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  summary_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the name is never cut
  for (QLabel* label : {mark_, name_, static_cast<QLabel*>(summary_)})
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* line = new QHBoxLayout(head_);
  line->setContentsMargins(8, 0, 10, 0);
  line->setSpacing(6);
  line->addWidget(mark_);
  line->addWidget(name_);
  line->addWidget(summary_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 1);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(body_);
  body_->layout()->setContentsMargins(10, 4, 10, 10);
  body_->hide();
  may_fold(*body_);
  connect(head_, &QPushButton::clicked, this, [this] {
    const bool was_open = is_open();
    Q_EMIT head_pressed();  // a row of folded steps unfolds
    open(!was_open);
  });
  show_number(number_, count_);
  show_state(StepState::open, {}, title_);
}

void StepSection::show_number(int number, int count) {
  const QKeySequence key =
      number == 0 ? QKeySequence() : QKeySequence(Qt::ALT | (Qt::Key_0 + number));
  if (head_->shortcut() != key) head_->setShortcut(key);
  number_ = number;
  count_ = count;
}

void StepSection::set_title(const QString& title) {
  if (title == title_) return;
  title_ = title;
  name_->setText(title);
  name_->setMinimumWidth(name_->sizeHint().width());
}

void StepSection::show_state(StepState state, const QString& summary, const QString& folded) {
  // A step that becomes the next one is opened; one that is done is closed.
  if (state != state_) open(state == StepState::next);
  if (state == StepState::absent || state_ == StepState::absent)
    setVisible(state != StepState::absent);
  state_ = state;
  const bool done = state == StepState::done;
  const bool next = state == StepState::next;
  mark_->setText(done ? QStringLiteral("✓") : QString::number(number_));
  words_ = summary;
  folded_words_ = folded;
  show_summary();
  const auto* word = done ? "done" : next ? "next" : "open";
  if (property("section").toString() != QLatin1String(word)) {
    for (QWidget* widget : {static_cast<QWidget*>(this), static_cast<QWidget*>(mark_),
                            static_cast<QWidget*>(name_)}) {
      widget->setProperty("section", word);
      widget->style()->unpolish(widget);
      widget->style()->polish(widget);
    }
    name_->setMinimumWidth(name_->sizeHint().width());
  }
  const auto state_words = done ? tr("done") : next ? tr("next") : tr("to come");
  describe(
      *head_, tr("Step %1 of %2, %3: %4").arg(number_).arg(count_).arg(title_, state_words),
      (summary.isEmpty()
           ? tr("%1: %2. Opens and closes this step (Alt+%3)").arg(title_, state_words).arg(number_)
           : tr("%1: %2. Opens and closes this step (Alt+%3)").arg(title_, summary).arg(number_)));
}

void StepSection::open(bool open) {
  body_->setVisible(open && !folded_);
  Q_EMIT opened();
}

void StepSection::fold(bool folded) {
  if (folded == folded_) return;
  folded_ = folded;
  name_->setVisible(!folded);
  summary_->setAlignment((folded ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  open(!folded && state_ == StepState::next);
  show_summary();
}

void StepSection::show_summary() {
  summary_->show_words(folded_ ? folded_words_ : words_);
}

}  // namespace isograsp::gui

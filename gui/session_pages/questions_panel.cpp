// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/questions_panel.hpp"

#include <QStyle>

#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

QuestionsPanel::QuestionsPanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("About the last trial"), parent), presenter_(presenter) {
  scale_ = new QLabel;
  scale_->setObjectName("questions_scale");
  scale_->setProperty("role", "quiet");
  scale_->setWordWrap(true);
  column_->addWidget(scale_);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &QuestionsPanel::refresh);
  refresh();
}

void QuestionsPanel::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  setMinimumHeight(layout()->totalHeightForWidth(width()));
}

void QuestionsPanel::build(const tasks::Questionnaire& asked) {
  delete questions_;
  rows_.clear();
  questions_ = new QWidget;
  auto* grid = new QGridLayout(questions_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 3);
  grid->setColumnStretch(1, 4);
  for (std::size_t i = 0; i < asked.questions.size(); ++i) {
    const tasks::Question& question = asked.questions[i];
    const QString words = translated(question.words);
    const auto name = "question_" + QString::fromUtf8(question.name.data(),
                                                      static_cast<int>(question.name.size()));
    auto* label = new QLabel(words);
    label->setWordWrap(true);
    auto* numbers = new ScoreRow(name, words, {asked.least, asked.most});
    auto* none = new QToolButton;
    none->setObjectName(name + "_none");
    none->setText(tr("No answer"));
    none->setCheckable(true);
    none->setProperty("score", true);
    constexpr int kBesideWords_px = 24;  // chosen, they are bold
    none->setMinimumWidth(none->fontMetrics().horizontalAdvance(none->text()) +
                          scaled(kBesideWords_px));
    describe(*none, tr("%1: no answer").arg(words), tr("%1: no answer").arg(words));
    const auto row = static_cast<int>(i);
    grid->addWidget(label, row, 0);
    grid->addWidget(numbers, row, 1);
    grid->addWidget(none, row, 2);
    connect(numbers, &ScoreRow::chosen, this,
            [this, i](int number) { presenter_.remarks().answer_question(i, number); });
    connect(none, &QToolButton::clicked, this,
            [this, i] { presenter_.remarks().answer_question(i, std::nullopt); });
    rows_.push_back({numbers, none});
  }
  column_->insertWidget(column_->indexOf(scale_), questions_);
  scale_->setText(tr("%1: %2, %3: %4. Each answer is kept at once; another one corrects it.")
                      .arg(asked.least)
                      .arg(translated(asked.least_words))
                      .arg(asked.most)
                      .arg(translated(asked.most_words)));
  shown_ = &asked;
}

void QuestionsPanel::refresh() {
  const TrialQuestions& questions = presenter_.state().rating().questions;
  setVisible(questions.asked != nullptr);
  if (questions.asked == nullptr) return;
  if (questions.asked != shown_) build(*questions.asked);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto& said = questions.said[i];
    rows_[i].numbers->show_value(said ? *said : std::nullopt);
    rows_[i].none->setChecked(said && !*said);
  }
  if (property("due").toBool() != questions.due()) {
    setProperty("due", questions.due());
    style()->unpolish(this);
    style()->polish(this);
  }
}

}  // namespace isograsp::gui

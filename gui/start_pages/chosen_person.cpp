// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/start_pages/chosen_person.hpp"

#include <utility>

#include "gui/look/look.hpp"
#include "gui/record_pages/trend_tile.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "reports/findings/patient_verdicts.hpp"

namespace isograsp::gui {

namespace {
constexpr std::size_t kMostTiles = 3;
constexpr int kMostSessionLines = 6;

/// Newest first, a line for each.
QString session_lines(const PatientCourse& course) {
  QStringList lines;
  for (auto one = course.sessions.rbegin();
       one != course.sessions.rend() && lines.size() < kMostSessionLines; ++one) {
    const auto protocol = one->record.protocol_name.empty() ? ChosenPerson::tr("tasks one by one")
                                                            : translated(one->record.protocol_name);
    lines << ChosenPerson::tr("%1   %2, %3, %4")
                 .arg(local_time(one->record.started_utc), hand_words(one->record.hand), protocol,
                      trials_words(static_cast<int>(one->trials.size())));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

ChosenPerson::ChosenPerson(Clinic& clinic, QWidget* parent) : Card({}, parent), clinic_(clinic) {
  setObjectName("chosen_person");
  title_->setProperty("role", "large");
  hint_ = new QLabel(tr("Choose a card to see how somebody is doing."));
  hint_->setProperty("role", "quiet");
  hint_->setWordWrap(true);
  tiles_ = new QVBoxLayout;
  tiles_->setSpacing(8);
  sessions_ = new QLabel;
  sessions_->setProperty("role", "quiet");
  column_->setContentsMargins(16, 12, 16, 12);
  column_->setSpacing(8);
  column_->addWidget(hint_);
  column_->addLayout(tiles_);
  column_->addWidget(sessions_);
  column_->addStretch(1);
  empty();
}

void ChosenPerson::empty() {
  title_->setVisible(!code_.empty());
  title_->setText(QString::fromStdString(code_));
  hint_->setVisible(code_.empty());
  sessions_->clear();
  while (QLayoutItem* item = tiles_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
}

void ChosenPerson::show_person(const std::string& code) {
  if (code == code_) return;
  code_ = code;
  renew();
}

void ChosenPerson::renew() {
  shown_ = false;
  ++reading_;
  empty();
  if (isVisible()) read();
}

void ChosenPerson::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  if (!shown_) read();
}

void ChosenPerson::read() {
  if (code_.empty()) return;
  shown_ = clinic_.read(
      this,
      [code = code_](storage::SessionStore& store) -> Result<Read> {
        auto course = read_course(store, code);
        if (!course) return course.error();
        Read read{*std::move(course), {}};
        read.trends = choose_trends(read.course);
        if (const auto verdicts = reports::gather_verdicts(store, code))
          add_verdicts(read.trends, *verdicts);
        return read;
      },
      [this, reading = reading_](const Result<Read>& read) {
        if (read && reading == reading_) show_read(*read);
      });
}

void ChosenPerson::show_read(const Read& read) {
  for (std::size_t i = 0; i < read.trends.size() && i < kMostTiles; ++i) {
    auto* tile = new TrendTile(read.trends[i]);
    tile->setFocusPolicy(Qt::NoFocus);
    tile->setAttribute(Qt::WA_TransparentForMouseEvents);
    tiles_->addWidget(tile);
  }
  sessions_->setText(read.course.sessions.empty() ? tr("No session yet.")
                                                  : session_lines(read.course));
}

}  // namespace isograsp::gui

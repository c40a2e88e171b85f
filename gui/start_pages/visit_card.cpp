// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/start_pages/visit_card.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>

#include "core/measure.hpp"
#include "gui/clinic/patient_course.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "reports/findings/report_text.hpp"

namespace isograsp::gui {

namespace {

constexpr int kCardButton_px = 36;
constexpr int kSparkWide_px = 96;
constexpr int kSparkHigh_px = 30;
constexpr int kCardApart_px = 8;  // at its right and below it
constexpr int kInside_px = 16;    // from its left and right edge to what stands on it

QString protocol_words(const storage::SessionRecord& session) {
  return session.protocol_name.empty() ? VisitCard::tr("tasks one by one")
                                       : translated(session.protocol_name);
}

QString mark_words(const PersonOfDay& person) {
  switch (person.visit) {
    case Visit::here: return VisitCard::tr("TODAY");
    case Visit::usual: return VisitCard::tr("USUAL DAY");
    case Visit::none: break;
  }
  return {};
}

QString next_words(const PersonOfDay& person, const DayCard* card) {
  const auto& last = card != nullptr && card->last ? card->last : person.last;
  if (card != nullptr && !card->unfinished_since_utc.empty())
    return VisitCard::tr("Unfinished since %1: %2")
        .arg(local_time(card->unfinished_since_utc).section(QLatin1Char(' '), -1),
             protocol_words(*last));
  if (last) return VisitCard::tr("Next: %1").arg(protocol_words(*last));
  return card == nullptr ? QString() : VisitCard::tr("Next: first session");
}

QString last_words(const PersonOfDay& person, const DayCard* card) {
  const auto& last = card != nullptr && card->last ? card->last : person.last;
  if (last)
    return VisitCard::tr("Last session %1, %2")
        .arg(local_date(last->started_utc), hand_words(last->hand));
  if (card == nullptr) return {};
  return VisitCard::tr("No session yet; added %1").arg(local_date(person.patient.created_utc));
}

/// When and with which hand: what that was, is clear from where it stands.
QString seen_words(const PersonOfDay& person, const DayCard* card) {
  const auto& last = card != nullptr && card->last ? card->last : person.last;
  return last ? VisitCard::tr("%1, %2").arg(local_date(last->started_utc), hand_words(last->hand))
              : last_words(person, card);
}

}  // namespace

QString CardWords::aloud() const {
  QStringList parts{code};
  for (const QString& part : {name, mark, next, last, measure, verdict})
    if (!part.isEmpty()) parts << part;
  return parts.join(QStringLiteral(". "));
}

CardWords words_of(const PersonOfDay& person, const QString& name, const DayCard* card) {
  CardWords words;
  words.code = QString::fromStdString(person.patient.code);
  words.name = name;
  words.mark = mark_words(person);
  words.next = next_words(person, card);
  words.last = last_words(person, card);
  words.seen = seen_words(person, card);
  if (card == nullptr || !card->primary) return words;
  Measure measure;
  measure.name = card->primary->primary.measure;
  measure.channel = card->primary->primary.channel;
  words.measure = VisitCard::tr("%1: %2").arg(translated(card->primary->primary.task_name),
                                              measure_title(measure));
  if (card->primary->verdict)
    words.verdict = translated(reports::verdict_words(*card->primary->verdict));
  return words;
}

VisitCard::VisitCard(QWidget* parent) : QFrame(parent) {
  const auto line = [](const char* role) {
    auto* label = new QLabel;
    label->setProperty("role", role);
    label->setTextInteractionFlags(Qt::NoTextInteraction);
    label->setMinimumWidth(1);
    return label;
  };
  code_ = line("title");
  mark_ = line("quiet");
  next_ = line("");
  last_ = line("quiet");
  verdict_ = line("quiet");
  verdict_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  mark_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  spark_ = new Sparkline;
  spark_->setFixedSize(scaled(kSparkWide_px), scaled(kSparkHigh_px));
  begin_ = new QPushButton(tr("Begin"));
  open_ = new QPushButton(tr("Open"));
  remove_ = new QPushButton(tr("Remove"));
  for (QPushButton* button : {begin_, open_, remove_}) {
    button->setMinimumHeight(scaled(kCardButton_px));
    button->setFocusPolicy(Qt::NoFocus);  // the list has the keys: Enter begins
  }
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(kInside_px, 8, kInside_px + kCardApart_px, 12 + kCardApart_px);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->addWidget(code_, 0, 0);
  grid->addWidget(mark_, 0, 1);
  grid->addWidget(next_, 1, 0, 1, 2);
  grid->addWidget(last_, 2, 0, 1, 2);
  grid->addWidget(spark_, 1, 0, 2, 2, Qt::AlignRight | Qt::AlignVCenter);
  auto* acts = new QHBoxLayout;
  acts->setSpacing(8);
  acts->addWidget(begin_);
  acts->addWidget(open_);
  acts->addWidget(remove_);
  acts->addWidget(verdict_, 1);
  grid->addLayout(acts, 3, 0, 1, 2);
  grid->setRowMinimumHeight(3, scaled(kCardButton_px) + 4);
  grid->setColumnStretch(0, 1);
  connect(begin_, &QPushButton::clicked, this, &VisitCard::begin_pressed);
  connect(open_, &QPushButton::clicked, this, &VisitCard::open_pressed);
  connect(remove_, &QPushButton::clicked, this, &VisitCard::remove_pressed);
}

void VisitCard::show_person(const PersonOfDay& person, const CardWords& words,
                            const DayCard* card) {
  words_ = words;
  const auto code = QString::fromStdString(person.patient.code);
  begin_->setObjectName(QStringLiteral("begin_") + code);
  open_->setObjectName(QStringLiteral("open_") + code);
  remove_->setObjectName(QStringLiteral("remove_") + code);
  describe(*remove_, tr("Remove %1").arg(code),
           tr("Added by mistake: nothing is stored of this person; the log keeps that it was "
              "removed"));
  show_part(*remove_, card != nullptr && card->blank);
  describe(*begin_, tr("Begin a session with %1").arg(code), tr("Enter on the card begins, too"));
  describe(*open_, tr("Open %1").arg(code), tr("Sessions, measures and trials so far (Ctrl+2)"));
  const bool measured = card != nullptr && card->primary && !card->primary->values.empty();
  spark_->show_values(measured ? card->primary->values : std::vector<double>{});
  show_part(*spark_, measured);
  elide();
}

void VisitCard::show_chosen(bool chosen) {
  if (chosen == chosen_) return;
  chosen_ = chosen;
  update();
}

void VisitCard::allow(bool begin, bool open) {
  begin_->setEnabled(begin);
  open_->setEnabled(open);
  remove_->setEnabled(begin);
}

void VisitCard::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  elide();
}

/// A line that has no room is cut; the tooltip of the card has all of it.
void VisitCard::elide() {
  const int inside_px = width() - 2 * kInside_px - kCardApart_px;
  const auto set = [](QLabel& label, const QString& text, int room_px) {
    label.setText(label.fontMetrics().elidedText(text, Qt::ElideRight, room_px));
  };
  const int beside_px = spark_->isHidden() ? inside_px : inside_px - spark_->width() - 8;
  mark_->setText(words_.mark);
  set(*code_, words_.name.isEmpty() ? words_.code : tr("%1  %2").arg(words_.code, words_.name),
      inside_px - mark_->fontMetrics().horizontalAdvance(words_.mark) - 16);
  set(*next_, words_.next, beside_px);
  set(*last_, words_.seen, beside_px);
  set(*verdict_, words_.verdict,
      inside_px - begin_->sizeHint().width() - open_->sizeHint().width() - 24);
}

void VisitCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(chosen_ ? look::kAccent : look::kLine, chosen_ ? 2.0 : 1.0));
  painter.setBrush(chosen_ ? look::kHover : look::kCard);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1 - kCardApart_px, -1 - kCardApart_px), 8,
                          8);
}

}  // namespace isograsp::gui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/protocol_form.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kProtocolRow_px = 24;

QString mark_of(ProtocolGuide::RowState state) {
  switch (state) {
    case ProtocolGuide::RowState::done: return QStringLiteral("✓");
    case ProtocolGuide::RowState::current: return QStringLiteral("▸");
    case ProtocolGuide::RowState::open: break;
  }
  return QStringLiteral("  ");
}

QString words_of(const ProtocolGuide::Row& row) {
  const auto title = QString::fromStdString(row.title);
  if (row.practice && row.count > 1)
    return ProtocolForm::tr("%1, practice (%2)").arg(title).arg(row.count);
  if (row.practice) return ProtocolForm::tr("%1, practice").arg(title);
  if (row.count > 1) return ProtocolForm::tr("%1 (%2)").arg(title).arg(row.count);
  return title;
}

}  // namespace

QString duration_words(const tasks::Duration& duration) {
  const auto minutes = [](double duration_s) {
    return static_cast<int>(std::ceil(duration_s / 60.0));
  };
  return ProtocolForm::tr("About %1 min, at most %2 min, rests included")
      .arg(minutes(duration.nominal_s))
      .arg(minutes(duration.worst_s));
}

ProtocolForm::ProtocolForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  protocols_ = new ChoiceBox;
  protocols_->setObjectName("protocols");
  protocols_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  describe(*protocols_, tr("Protocol"),
           tr("What this session consists of; chosen before connecting (Alt+7, then arrow keys)"));
  duration_ = new QLabel;
  duration_->setObjectName("protocol_duration");
  duration_->setProperty("role", "quiet");
  duration_->setWordWrap(true);
  make_question();
  steps_ = new QListWidget;
  steps_->setObjectName("protocol_steps");
  steps_->setProperty("plain", true);
  steps_->setSelectionMode(QAbstractItemView::NoSelection);
  describe(*steps_, tr("Steps of the protocol"),
           tr("What is done and what comes (Tab, arrow keys)"));
  take_rest(*steps_, 3 * kProtocolRow_px);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  column->addWidget(protocols_);
  column->addWidget(duration_);
  column->addWidget(earlier_);
  column->addWidget(steps_, 1);
  connect(protocols_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    const bool by_hand = index == protocols_->count() - 1;
    presenter_.choices().choose_protocol(by_hand ? std::nullopt : std::optional(index));
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ProtocolForm::refresh);
  connect(&presenter_.flow(), &SessionFlow::library_changed, this, &ProtocolForm::fill_protocols);
  fill_protocols();
}

/// Whether an interrupted protocol goes on.
void ProtocolForm::make_question() {
  earlier_ = new QFrame;
  earlier_->setProperty("confirm", true);
  question_ = new QLabel;
  question_->setObjectName("earlier_question");
  question_->setWordWrap(true);
  go_on_ = new QPushButton(tr("&Go on with it"));
  go_on_->setObjectName("earlier_go_on");
  go_on_->setCheckable(true);
  describe(*go_on_, tr("Go on with the interrupted protocol"),
           tr("What was done is not asked again; zero and resting force are (Alt+G)"));
  anew_ = new QPushButton(tr("&Begin anew"));
  anew_->setObjectName("earlier_anew");
  anew_->setCheckable(true);
  describe(*anew_, tr("Begin the protocol anew"), tr("Everything is asked again (Alt+B)"));
  auto* answers = new QHBoxLayout;
  answers->addWidget(go_on_);
  answers->addWidget(anew_);
  auto* asking = new QVBoxLayout(earlier_);
  asking->setContentsMargins(8, 6, 8, 8);
  asking->addWidget(question_);
  asking->addLayout(answers);
  connect(go_on_, &QPushButton::clicked, this, [this] {
    presenter_.choices().decide_earlier(true);
    refresh();
  });
  connect(anew_, &QPushButton::clicked, this, [this] {
    presenter_.choices().decide_earlier(false);
    refresh();
  });
}

void ProtocolForm::fill_protocols() {
  {
    const QSignalBlocker quiet(protocols_);
    protocols_->clear();
    for (const auto& protocol : presenter_.state().library.protocols)
      protocols_->addItem(translated(protocol.spec.name));
    protocols_->addItem(tr("Tasks one by one"));
  }
  is_described_ = false;
  refresh();
}

void ProtocolForm::refresh() {
  const bool by_hand = !presenter_.state().has_protocol();
  const auto chosen = by_hand ? std::nullopt : presenter_.state().choices.protocol;
  {
    const QSignalBlocker quiet(protocols_);
    protocols_->setCurrentIndex(chosen.value_or(protocols_->count() - 1));
  }
  protocols_->setEnabled(presenter_.flow().view().may_change_hand);
  if (!is_described_ || described_ != chosen) {
    is_described_ = true;
    described_ = chosen;
    preview_.end();
    if (!by_hand) preview_.begin(presenter_.state().chosen_protocol(), {}, 0);
    duration_->setText(by_hand ? tr("You choose every task yourself.")
                               : duration_words(presenter_.state().chosen_protocol().duration()));
  }
  const auto earlier = presenter_.state().choices.interrupted.acts;
  earlier_->setVisible(earlier.has_value() && presenter_.flow().view().may_change_hand);
  if (earlier) {
    question_->setText(
        tr("Interrupted today after %n step(s). Go on where it stopped?", "", *earlier));
    go_on_->setChecked(presenter_.state().choices.interrupted.go_on == true);
    anew_->setChecked(presenter_.state().choices.interrupted.go_on == false);
    const bool asked = presenter_.flow().view().press == NextPress::earlier;
    mark_choice(*go_on_, asked);
    mark_choice(*anew_, asked);
  }
  fill_steps();
}

void ProtocolForm::fill_steps() {
  auto rows = presenter_.state().guide().rows();
  if (rows.empty()) {  // before the session: the whole way, nothing done
    rows = preview_.rows();
    for (auto& row : rows) row.state = ProtocolGuide::RowState::open;
  }
  steps_->setVisible(!rows.empty());
  if (rows == shown_) return;
  shown_ = rows;
  steps_->clear();
  for (const auto& row : rows) {
    auto* item =
        new QListWidgetItem(mark_of(row.state) + QStringLiteral("  ") + words_of(row), steps_);
    item->setToolTip(words_of(row));
    item->setSizeHint({0, scaled(kProtocolRow_px)});
    QFont font = steps_->font();
    font.setBold(row.state == ProtocolGuide::RowState::current);
    item->setFont(font);
    if (row.state == ProtocolGuide::RowState::done) item->setForeground(look::kReady);
    if (row.state == ProtocolGuide::RowState::current) steps_->scrollToItem(item);
  }
}

}  // namespace isograsp::gui

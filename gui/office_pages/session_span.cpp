// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/session_span.hpp"

#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

namespace {
constexpr int kDateLetters = 10;  // YYYY-MM-DD
}

SessionSpan::SessionSpan(const QString& first, const QString& last, const QString& name,
                         QWidget* parent)
    : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  const auto add = [&](const QString& words, const char* ending) {
    auto* box = new ChoiceBox;
    box->setObjectName(name + QLatin1String(ending));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto plain = words;
    plain.remove('&');
    describe(*box, plain,
             tr("%1 (Alt+%2, then arrow keys)")
                 .arg(plain, words.mid(words.indexOf('&') + 1, 1).toUpper()));
    auto* label = new QLabel(words);
    label->setBuddy(box);
    column->addWidget(label);
    column->addWidget(box);
    return box;
  };
  first_ = add(first, "_first");
  last_ = add(last, "_last");
  connect(first_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (last_->currentIndex() < index) last_->setCurrentIndex(index);
    Q_EMIT changed();
  });
  connect(last_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (first_->currentIndex() > index) first_->setCurrentIndex(index);
    Q_EMIT changed();
  });
}

void SessionSpan::show_sessions(const std::vector<storage::SessionRecord>& sessions,
                                bool same_patient) {
  const int from = same_patient ? std::max(0, first_->currentIndex()) : 0;
  const int to =
      same_patient && last() ? last_->currentIndex() : static_cast<int>(sessions.size()) - 1;
  for (auto* box : {first_, last_}) {
    const QSignalBlocker quiet(box);
    box->clear();
    int number = 0;
    for (const auto& session : sessions)
      box->addItem(
          tr("%1: %2").arg(++number).arg(local_time(session.started_utc).left(kDateLetters)));
    box->setCurrentIndex(box == first_ ? std::min(from, number - 1) : std::min(to, number - 1));
    box->setEnabled(number > 0);
  }
}

std::optional<int> SessionSpan::last() const {
  if (last_->currentIndex() == last_->count() - 1) return std::nullopt;
  return last_->currentIndex() + 1;
}

}  // namespace isograsp::gui

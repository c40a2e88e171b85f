// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/start_pages/open_session.hpp"

#include <QHBoxLayout>
#include <QVariant>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/look.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

OpenSessionStrip::OpenSessionStrip(SessionPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  setProperty("card", true);
  words_ = new QLabel;
  words_->setObjectName("open_session");
  words_->setWordWrap(true);
  go_ = new QPushButton(tr("&Go to it"));
  go_->setObjectName("go_to_session");
  describe(*go_, tr("Go to the open session"), tr("Alt+G"));
  end_ = new QPushButton(tr("&End it"));
  end_->setObjectName("end_open_session");
  describe(
      *end_, tr("End the open session"),
      tr("All that was measured is kept; a trial that stands still is ended and marked (Alt+E)"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(8);
  row->addWidget(words_, 1);
  row->addWidget(go_);
  row->addWidget(end_);
  connect(go_, &QPushButton::clicked, this, &OpenSessionStrip::go_to_session);
  connect(end_, &QPushButton::clicked, this, [this] { presenter_.connecting().end_session(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &OpenSessionStrip::refresh);
  hide();
  refresh();
}

void OpenSessionStrip::refresh() {
  const SessionState& state = presenter_.state();
  show_part(*this, state.session_open());
  if (!state.session_open()) return;
  const storage::SessionRecord& record = state.open->session->known().record;
  const bool works = presenter_.flow().view().may_pause;
  const QString words =
      tr("The session of %1, %2, is open since %3.")
          .arg(QString::fromStdString(state.choices.patient), hand_words(record.hand),
               local_time(record.started_utc).section(QLatin1Char(' '), -1));
  words_->setText(works ? tr("%1 A trial runs.").arg(words) : words);
  end_->setEnabled(!works);
}

}  // namespace isograsp::gui

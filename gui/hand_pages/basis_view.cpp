// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/basis_view.hpp"

#include <QStringList>
#include <QVBoxLayout>

#include "gui/hand_pages/basis_dialog.hpp"
#include "gui/look/look.hpp"
#include "gui/words/consent_words.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

BasisView::BasisView(SessionPresenter& presenter, Staff& staff, QWidget* parent)
    : QWidget(parent), presenter_(presenter), staff_(staff) {
  words_ = new QLabel;
  words_->setObjectName("basis_words");
  words_->setWordWrap(true);
  record_ = new QPushButton(tr("Lawful basis …"));
  record_->setObjectName("basis_open");
  describe(*record_, tr("Lawful basis of this person"),
           tr("Shows what is on record, and records one more entry (Tab, then space)"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  column->addWidget(words_);
  column->addWidget(record_);
  connect(record_, &QPushButton::clicked, this, &BasisView::ask);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &BasisView::refresh);
  // Somebody else may have recorded it meanwhile: what a refused session has read counts.
  connect(&presenter_.flow(), &SessionFlow::settled, this, &BasisView::read);
  connect(&staff_, &Staff::changed, this, [this] {
    if (staff_.closed()) code_.clear();
    refresh();
  });
  refresh();
}

void BasisView::refresh() {
  const SessionState& state = presenter_.state();
  const FlowView& view = presenter_.flow().view();
  const bool shown = state.watches_hand() && !state.choices.patient.empty() && !staff_.closed();
  show_part(*this, shown);
  if (!shown) return;
  record_->setVisible(view.may_change_device);
  record_->setEnabled(staff_.allows(storage::Right::write_records));
  mark_next(*record_, view.press == NextPress::basis);
  if (code_ == state.choices.patient) return;
  code_ = state.choices.patient;
  words_->setText(tr("Looking for a lawful basis …"));
  read();
}

void BasisView::read() {
  if (code_.empty() || !presenter_.state().watches_hand()) return;
  staff_.read_consents(this, code_,
                       [this, code = code_](const Result<std::vector<storage::Consent>>& recorded) {
                         if (code == code_) show_recorded(recorded);
                       });
}

void BasisView::show_recorded(const Result<std::vector<storage::Consent>>& recorded) {
  if (!recorded) return words_->setText(tr("⚠ %1").arg(translated(recorded.error())));
  if (storage::allow_cameras(*recorded)) presenter_.connecting().basis_recorded();
  QStringList lines;
  for (const storage::Consent& one : storage::standing(*recorded)) lines << consent_words(one);
  if (lines.isEmpty())
    lines << tr("✗ No camera may look at this person: no lawful basis is on record.");
  else if (!storage::allow_cameras(*recorded))
    lines.prepend(tr("No camera may look at this person:"));
  words_->setText(lines.join(QLatin1Char('\n')));
}

void BasisView::ask() {
  auto* dialog = new BasisDialog(staff_, code_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, &BasisView::read);
  dialog->open();
}

}  // namespace isograsp::gui

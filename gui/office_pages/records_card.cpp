// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/records_card.hpp"

#include <QVBoxLayout>

#include "gui/words/texts.hpp"

namespace isograsp::gui {

RecordsCard::RecordsCard(const Staff& staff, QWidget* parent)
    : Card(tr("The records"), parent), staff_(staff) {
  const auto add = [this](const char* name, const QString& words) {
    auto* label = new QLabel(words);
    label->setObjectName(name);
    label->setWordWrap(true);
    column().addWidget(label);
    return label;
  };
  found_ = add("records_found", {});
  found_->setProperty("role", "problem");
  if (staff.is_protected()) {
    add("records_hold",
        tr("Names, notes and goals are sealed. What somebody without a password changes is found "
           "at the login or by isograsp db check."));
    add("records_limits",
        tr("Not hidden from whoever has the file: codes, dates, forces, the names of those who "
           "work here. Not noticed: an older copy of the file that is put back together with its "
           "FILE-audit."));
  } else {
    add("records_hold",
        tr("This database has no passphrase: whoever has the file can read all of it. What is "
           "changed, removed or added by another program is found by isograsp db check."));
    add("records_limits",
        tr("Not noticed: changes by somebody who computes seals and log anew, and an older copy "
           "of the file that is put back. isograsp db protect gives the database a passphrase."));
  }
  auto* helps = add("records_helps",
                    tr("What helps: an encrypted disk, copies elsewhere, and on paper the head of "
                       "the audit log and the key of signed backups (isograsp db audit)."));
  helps->setProperty("role", "quiet");
  connect(&staff_, &Staff::changed, this, &RecordsCard::refresh);
  refresh();
}

void RecordsCard::refresh() {
  QString all;
  for (const Text& notice : staff_.notices())
    all += (all.isEmpty() ? "" : "\n") + translated(notice);
  found_->setText(all);
  found_->setVisible(!all.isEmpty());
}

}  // namespace isograsp::gui

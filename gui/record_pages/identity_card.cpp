// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/identity_card.hpp"

#include <QHBoxLayout>

#include "core/date.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

IdentityCard::IdentityCard(Staff& staff, QWidget* parent)
    : Card(tr("Identity"), parent), staff_(staff) {
  const auto field = [&](auto* made, const char* object_name, const QString& name,
                         const QString& tooltip) {
    made->setObjectName(QLatin1String(object_name));
    describe(*made, name, tooltip);
    return made;
  };
  name_ = field(new QLineEdit, "identity_name", tr("Name"), tr("Encrypted (Tab)"));
  name_->setPlaceholderText(tr("Name"));
  birth_ = field(new DateField(Ahead::refused), "identity_birth", tr("Born"),
                 tr("Date of birth, encrypted (Tab)"));
  contact_ = field(new QLineEdit, "identity_contact", tr("Contact"), tr("Encrypted (Tab)"));
  contact_->setPlaceholderText(tr("Contact"));
  show_ = field(new QPushButton(tr("Show the identit&y")), "identity_show", tr("Show the identity"),
                tr("Who this code is; the audit log says who looked (Alt+Y)"));
  store_ = field(new QPushButton(tr("&Keep")), "identity_store", tr("Keep the identity"),
                 tr("Encrypted, apart from everything that was measured (Alt+K)"));
  remark_ = new Remark;
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(show_);
  row->addWidget(name_, 3);
  row->addWidget(birth_, 1);
  row->addWidget(contact_, 3);
  row->addWidget(store_);
  column().addLayout(row);
  column().addWidget(remark_);
  connect(show_, &QPushButton::clicked, this, &IdentityCard::read);
  connect(store_, &QPushButton::clicked, this, &IdentityCard::store);
  connect(&staff_, &Staff::changed, this, [this] {
    if (staff_.closed()) close();
    refresh();
  });
  refresh();
}

void IdentityCard::show_patient(const std::string& code) {
  if (code == code_) return;
  code_ = code;
  close();
  refresh();
}

void IdentityCard::close() {
  open_ = false;
  // Set, not cleared: an undo would bring it back.
  for (auto* field : {name_, static_cast<QLineEdit*>(birth_), contact_}) field->setText({});
  remark_->say({});
}

void IdentityCard::read() {
  staff_.read_identity(
      this, code_, [this, code = code_](const Result<std::optional<storage::Identity>>& read) {
        if (code != code_ || staff_.closed()) return;
        if (!read) return remark_->warn(translated(read.error()));
        open_ = true;
        const storage::Identity identity = read->value_or(storage::Identity{});
        name_->setText(QString::fromStdString(identity.name));
        birth_->show_date(date_from_iso(identity.birth_date));
        contact_->setText(QString::fromStdString(identity.contact));  // its lines stay in it
        remark_->say(*read ? QString() : tr("Nothing is known of this person yet."));
        refresh();
        name_->setFocus();
      });
}

void IdentityCard::store() {
  const auto birth = birth_->typed();
  if (!birth.problem.isEmpty()) return remark_->warn(birth.problem);
  storage::Identity identity;
  identity.name = name_->text().trimmed().toStdString();
  if (birth.value) identity.birth_date = iso_text(*birth.value);
  identity.contact = contact_->text().trimmed().toStdString();
  staff_.store_identity(this, code_, identity, [this, code = code_](const Result<void>& stored) {
    if (code != code_) return;
    if (stored)
      remark_->say(tr("Kept."));
    else
      remark_->warn(translated(stored.error()));
  });
}

void IdentityCard::refresh() {
  setVisible(!code_.empty() && staff_.is_protected() && staff_.allows(storage::Right::identities));
  show_->setVisible(!open_);
  for (QWidget* widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(birth_),
                          static_cast<QWidget*>(contact_), static_cast<QWidget*>(store_)})
    widget->setVisible(open_);
}

}  // namespace isograsp::gui

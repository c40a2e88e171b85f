// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/login_page.hpp"

#include <QShowEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/card.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/form_fields.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kCard_px = 420;
// What the entries of the list that are no accounts open with.
constexpr const char* kPassphrase = "\n passphrase";
constexpr const char* kRecovery = "\n recovery";

}  // namespace

LoginPage::LoginPage(Staff& staff, QWidget* parent) : QWidget(parent), staff_(staff) {
  auto* centred = new QVBoxLayout(this);
  centred->addStretch(2);
  centred->addWidget(make_card(), 0, Qt::AlignHCenter);
  centred->addStretch(3);
  watch();
  refresh();
}

QWidget* LoginPage::make_card() {
  auto* card = new Card({});
  card->setFixedWidth(scaled(kCard_px));
  title_ = card->findChild<QLabel*>();
  why_ = new QLabel;
  why_->setWordWrap(true);
  why_->setProperty("role", "quiet");
  who_ = new ChoiceBox;
  who_->setObjectName("login_who");
  describe(*who_, tr("Who are you?"), tr("Your account (Alt+W, then arrow keys)"));
  auto* who_caption = new QLabel(tr("&Who are you?"));
  who_caption->setBuddy(who_);
  secret_ = new QLineEdit;
  secret_->setObjectName("login_secret");
  secret_->setEchoMode(QLineEdit::Password);
  secret_->setInputMethodHints(Qt::ImhHiddenText | Qt::ImhNoPredictiveText | Qt::ImhSensitiveData);
  secret_caption_ = new QLabel;
  secret_caption_->setBuddy(secret_);
  with_password_ = new QPushButton(tr("With the &password instead"));
  with_password_->setObjectName("login_with_password");
  with_password_->setCheckable(true);
  with_password_->setFlat(true);
  describe(*with_password_, tr("With the password instead"),
           tr("For somebody without a PIN, or after three wrong ones (Alt+P)"));
  enter_ = new QPushButton(tr("&Log in"));
  enter_->setObjectName("login");
  enter_->setDefault(true);
  describe(*enter_, tr("Log in"), tr("Who logs in stands in the record of every act (Enter)"));
  mark_main(*enter_, true);
  problem_ = new QLabel;
  problem_->setObjectName("login_problem");
  problem_->setWordWrap(true);
  auto& column = card->column();
  column.addWidget(why_);
  column.addSpacing(4);
  column.addWidget(who_caption);
  column.addWidget(who_);
  column.addWidget(secret_caption_);
  column.addWidget(secret_);
  column.addWidget(with_password_, 0, Qt::AlignLeft);
  column.addSpacing(4);
  column.addWidget(enter_);
  column.addWidget(problem_);
  return card;
}

void LoginPage::watch() {
  connect(&staff_, &Staff::changed, this, &LoginPage::refresh);
  connect(&staff_, &Staff::login_refused, this, [this](const QString& why) {
    problem_->setText(why);
    refresh();
  });
  connect(who_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    chosen_ = true;
    problem_->clear();
    refresh();
    secret_->setFocus();
  });
  connect(with_password_, &QPushButton::toggled, this, [this] {
    refresh();
    secret_->setFocus();
  });
  connect(enter_, &QPushButton::clicked, this, &LoginPage::log_in);
  connect(secret_, &QLineEdit::returnPressed, this, &LoginPage::log_in);
  connect(secret_, &QLineEdit::textChanged, this, &LoginPage::refresh);
}

void LoginPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (event->spontaneous()) return;  // the window only comes back to the screen
  chosen_ = false;
  fill_who();
  secret_->setText({});
  problem_->clear();
  with_password_->setChecked(false);
  refresh();
  secret_->setFocus();
}

/// Whoever was in last is the likeliest one to come back, unless somebody has chosen another.
void LoginPage::fill_who() {
  const QSignalBlocker quiet(who_);
  const auto before =
      chosen_ ? who_->currentData().toString() : QString::fromStdString(staff_.user());
  who_->clear();
  for (const auto& user : staff_.users()) {
    const auto name = QString::fromStdString(user.name);
    who_->addItem(name, name);
  }
  who_->addItem(tr("The clinic's passphrase"), QString(kPassphrase));
  who_->addItem(tr("The recovery key"), QString(kRecovery));
  who_->setCurrentIndex(std::max(0, who_->findData(before)));
}

/// The list shows those who have an account now.
bool LoginPage::who_is_filled() const {
  const auto& users = staff_.users();
  if (who_->count() != static_cast<int>(users.size()) + 2) return false;
  for (std::size_t i = 0; i < users.size(); ++i)
    if (who_->itemText(static_cast<int>(i)) != QString::fromStdString(users[i].name)) return false;
  return true;
}

Staff::Key LoginPage::key() const {
  const auto who = who_->currentData().toString();
  if (who == QLatin1String(kPassphrase)) return Staff::Key::passphrase;
  if (who == QLatin1String(kRecovery)) return Staff::Key::recovery_key;
  const auto& users = staff_.users();
  const bool has_pin = std::any_of(users.begin(), users.end(), [&](const storage::User& user) {
    return user.has_pin && who == QString::fromStdString(user.name);
  });
  return staff_.locked() && has_pin && !with_password_->isChecked() ? Staff::Key::pin
                                                                    : Staff::Key::password;
}

void LoginPage::log_in() {
  if (!enter_->isEnabled()) return;
  problem_->clear();
  QString secret = secret_->text();
  // An undo would bring it back.
  secret_->setText({});
  staff_.log_in(key(), who_->currentData().toString().toStdString(), secret);
}

void LoginPage::refresh() {
  if (!who_is_filled()) fill_who();
  title_->setText(staff_.locked() ? tr("Locked") : tr("This database is protected"));
  why_->setText(staff_.locked()
                    ? tr("Nobody has touched anything for a while, or somebody has locked it. A "
                         "session that is open goes on behind this page.")
                    : tr("Names, notes and goals are encrypted. Log in to open it."));
  switch (key()) {
    case Staff::Key::password: secret_caption_->setText(tr("Pa&ssword or phrase")); break;
    case Staff::Key::pin: secret_caption_->setText(tr("P&IN")); break;
    case Staff::Key::passphrase: secret_caption_->setText(tr("Passphrase of the &clinic")); break;
    case Staff::Key::recovery_key:
      secret_caption_->setText(tr("Recover&y key, as it was printed"));
      break;
  }
  const auto words = secret_caption_->text().remove(QLatin1Char('&'));
  describe(*secret_, words, tr("%1 (Enter logs in)").arg(words));
  with_password_->setVisible(staff_.locked() &&
                             (with_password_->isChecked() || key() == Staff::Key::pin));
  secret_->setEnabled(!staff_.busy());
  enter_->setEnabled(!staff_.busy() && !secret_->text().isEmpty());
  enter_->setText(staff_.busy() ? tr("One moment …") : tr("&Log in"));
  problem_->setVisible(!problem_->text().isEmpty());
}

}  // namespace isograsp::gui

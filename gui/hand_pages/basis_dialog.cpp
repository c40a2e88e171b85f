// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/basis_dialog.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <utility>

#include "gui/look/look.hpp"
#include "gui/look/value_table.hpp"
#include "gui/words/consent_words.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

/// Begins with a question that is no answer.
template <class Names, class WordsOf>
ChoiceBox* make_choice(const char* object_name, const QString& name, const Names& names,
                       WordsOf words_of) {
  auto* box = new ChoiceBox;
  box->setObjectName(QLatin1String(object_name));
  box->addItem(BasisDialog::tr("choose …"));
  for (const std::string_view one : names) box->addItem(words_of(one), qt(one));
  describe(*box, name, BasisDialog::tr("%1 (arrow keys)").arg(name));
  return box;
}

std::string chosen(const ChoiceBox& box) {
  return box.currentData().toString().toStdString();
}

QString basis_and_article(std::string_view basis) {
  return BasisDialog::tr("%1 – %2").arg(basis_words(basis), article_of(basis));
}

}  // namespace

BasisDialog::BasisDialog(Staff& staff, std::string code, QWidget* parent)
    : QDialog(parent), staff_(staff), code_(std::move(code)) {
  setWindowTitle(tr("Lawful basis"));
  auto* about = new QLabel(
      tr("No camera looks at a person before a lawful basis is on record. Of each purpose the last "
         "entry counts; treatment or research must be given."));
  about->setWordWrap(true);
  recorded_ = make_value_table(
      "basis_recorded", {tr("Purpose"), tr("Basis"), tr("Answer"), tr("Day"), tr("Recorded by")},
      110);
  describe(*recorded_, tr("What is on record"), tr("In the order in which it was recorded"));
  nothing_ = new QLabel(tr("Nothing is on record."));
  nothing_->setObjectName("basis_nothing");
  nothing_->setProperty("role", "quiet");
  make_fields();
  auto* buttons = new QDialogButtonBox;
  record_ = buttons->addButton(tr("Record"), QDialogButtonBox::AcceptRole);
  record_->setObjectName("basis_record");
  auto* cancel = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  cancel->setObjectName("basis_cancel");
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  column->addWidget(about);
  column->addWidget(nothing_);
  column->addWidget(recorded_, 1);
  column->addLayout(make_form());
  column->addWidget(remark_);
  column->addWidget(buttons);
  constexpr int kWidth_px = 560;
  setMinimumWidth(scaled(kWidth_px));
  connect(buttons, &QDialogButtonBox::accepted, this, &BasisDialog::record);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show_recorded({});
  read();
  refresh();
}

void BasisDialog::make_fields() {
  purpose_ = make_choice("basis_purpose", tr("Purpose"), storage::kPurposes, purpose_words);
  basis_ = make_choice("basis_basis", tr("Basis"), storage::kLawfulBases, basis_and_article);
  state_ = make_choice("basis_state", tr("Answer"), storage::kConsentStates, answer_words);
  for (ChoiceBox* box : {purpose_, basis_, state_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &BasisDialog::refresh);
  date_ = new DateField(Ahead::refused);
  date_->setObjectName("basis_date");
  describe(*date_, tr("Day"), tr("When it was said or signed; Up and Down change it (Tab)"));
  date_->show_date(local_today());
  constexpr int kLongest = 200;
  text_ = new QLineEdit;
  text_->setObjectName("basis_text");
  text_->setMaxLength(kLongest);
  text_->setPlaceholderText(tr("such as the version of the form"));
  describe(*text_, tr("Remark"), tr("Such as the version of the form; may be left empty (Tab)"));
  remark_ = new Remark;
  remark_->setObjectName("basis_remark");
}

QLayout* BasisDialog::make_form() {
  auto* form = new QFormLayout;
  form->addRow(tr("Purpose"), purpose_);
  form->addRow(tr("Basis"), basis_);
  form->addRow(tr("Answer"), state_);
  form->addRow(tr("Day"), date_);
  form->addRow(tr("Remark"), text_);
  return form;
}

void BasisDialog::read() {
  staff_.read_consents(this, code_, [this](const Result<std::vector<storage::Consent>>& recorded) {
    if (recorded)
      show_recorded(*recorded);
    else
      remark_->warn(translated(recorded.error()));
  });
}

void BasisDialog::show_recorded(const std::vector<storage::Consent>& recorded) {
  nothing_->setVisible(recorded.empty());
  recorded_->setVisible(!recorded.empty());
  recorded_->setRowCount(static_cast<int>(recorded.size()));
  for (int row = 0; row < recorded_->rowCount(); ++row) {
    const storage::Consent& one = recorded[static_cast<std::size_t>(row)];
    const QStringList cells{purpose_words(one.purpose), basis_words(one.basis),
                            answer_words(one.state), translated_date(one.on_date),
                            one.recorded_by.empty() ? QStringLiteral("–") : qt(one.recorded_by)};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(one.text.empty() ? cells[column] : qt(one.text));
      recorded_->setItem(row, column, item);
    }
  }
  recorded_->scrollToBottom();  // the newest
}

void BasisDialog::record() {
  const auto day = date_->typed();
  if (!day.problem.isEmpty()) return remark_->warn(day.problem);
  if (!day.value) return remark_->warn(tr("Give the day on which it was said."));
  storage::Consent consent;
  consent.on_date = iso_text(*day.value);
  consent.purpose = chosen(*purpose_);
  consent.basis = chosen(*basis_);
  consent.state = chosen(*state_);
  consent.text = text_->text().trimmed().toStdString();
  recording_ = true;
  refresh();
  staff_.record_consent(this, code_, consent, [this](const Result<void>& stored) {
    recording_ = false;
    refresh();
    if (stored)
      accept();
    else
      remark_->warn(translated(stored.error()));
  });
}

void BasisDialog::refresh() {
  const bool whole =
      !chosen(*purpose_).empty() && !chosen(*basis_).empty() && !chosen(*state_).empty();
  record_->setEnabled(whole && !recording_);
  describe(*record_, tr("Record"),
           whole ? tr("Adds this entry under your name; it is not changed any more (Enter)")
                 : tr("Choose purpose, basis and answer first"));
  mark_main(*record_, whole);
}

}  // namespace isograsp::gui

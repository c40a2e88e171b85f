// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/profile_panel.hpp"

#include <QHBoxLayout>
#include <QPointer>
#include <QResizeEvent>
#include <QStyle>
#include <utility>

#include "gui/look/look.hpp"
#include "reports/findings/patient_verdicts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kAfterLastKey_ms = 1000;
constexpr int kTwoColumns_px = 720;

}  // namespace

ProfilePanel::ProfilePanel(Clinic& clinic, PersonFile& file, QWidget* parent)
    : QWidget(parent), clinic_(clinic), file_(file) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(make_header());
  column->addWidget(make_form(), 1);
  watch();
  show_state();
}

/// Whose profile it is, and whether it is stored.
QLayout* ProfilePanel::make_header() {
  title_ = new QLabel;
  title_->setObjectName("profile_title");
  title_->setProperty("role", "title");
  state_ = new QLabel;
  state_->setObjectName("profile_state");
  state_->setWordWrap(true);
  state_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  again_ = new QPushButton(tr("Try again"));
  again_->setObjectName("profile_again");
  describe(*again_, tr("Try to store or read it again"),
           tr("Try to store or read it again (Ctrl+Shift+R)"));
  auto* header = new QHBoxLayout;
  header->setContentsMargins(12, 8, 12, 4);
  header->addWidget(title_);
  header->addWidget(state_, 1);
  header->addWidget(again_);
  return header;
}

/// The cards, in two columns where there is room.
QWidget* ProfilePanel::make_form() {
  person_ = new PersonCard;
  treatment_ = new TreatmentCard;
  scores_ = new ScoreCard;
  primary_ = new PrimaryCard;
  stable_ = new StableCard;
  auto* page = new QWidget;
  page->setObjectName("page");
  columns_ = new QBoxLayout(QBoxLayout::TopToBottom, page);
  columns_->setContentsMargins(8, 4, 8, 8);
  columns_->setSpacing(8);
  auto* about = new QVBoxLayout;
  about->setSpacing(8);
  about->addWidget(person_, 1);
  about->addWidget(primary_);
  columns_->addLayout(about, 1);
  auto* dated = new QVBoxLayout;
  dated->setSpacing(8);
  dated->addWidget(treatment_);
  dated->addWidget(scores_);
  dated->addWidget(stable_);
  dated->addStretch();
  columns_->addLayout(dated, 1);
  scroll_ = new QScrollArea;
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidgetResizable(true);
  scroll_->setWidget(page);
  return scroll_;
}

void ProfilePanel::watch() {
  delay_.setSingleShot(true);
  delay_.setInterval(kAfterLastKey_ms);
  connect(&delay_, &QTimer::timeout, this, &ProfilePanel::store);
  connect(person_, &PersonCard::typed, this, [this] {
    delay_.start();
    show_state();
  });
  connect(person_, &PersonCard::left, this, &ProfilePanel::store);
  using storage::SessionStore;
  connect_card<storage::TreatmentMark>(treatment_, &SessionStore::add_treatment_mark,
                                       &SessionStore::remove_treatment_mark);
  connect_card<storage::ClinicalScore>(scores_, &SessionStore::add_clinical_score,
                                       &SessionStore::remove_clinical_score);
  connect_card<storage::PrimaryMeasure>(primary_, &SessionStore::add_primary_measure,
                                        &SessionStore::remove_primary_measure);
  connect_card<storage::StablePeriod>(stable_, &SessionStore::add_stable_period,
                                      &SessionStore::remove_stable_period);
  connect(again_, &QPushButton::clicked, this, &ProfilePanel::try_again);
  add_key(this, "Ctrl+Shift+R", [this] {
    if (!again_->isHidden()) try_again();
  });
  connect(&clinic_, &Clinic::opened, this, &ProfilePanel::load);
  connect(&clinic_, &Clinic::history_changed, this, &ProfilePanel::load_choices);
  connect(&file_, &PersonFile::changed, this, &ProfilePanel::take_answer);
  connect(&file_, &PersonFile::failed, this, &ProfilePanel::refuse);
}

template <class Entry, class Card>
void ProfilePanel::connect_card(Card* card, PersonFile::Add<Entry> add, PersonFile::Remove remove) {
  connect(card, &Card::added, this, [this, add](const Entry& entry) {
    change([code = code_, entry, add](PersonFile& file, Stored then) {
      file.add(code, add, entry, std::move(then));
    });
  });
  connect(card, &Card::removed, this, [this, remove](storage::RowId id) {
    change([code = code_, id, remove](PersonFile& file, Stored then) {
      file.remove(code, remove, id, std::move(then));
    });
  });
}

ProfilePanel::~ProfilePanel() {
  store_now();
}

void ProfilePanel::show_patient(const std::string& code) {
  if (code == code_) return;
  try_again();
  forget();
  code_ = code;
  load();
  show_state();
}

void ProfilePanel::forget() {
  delay_.stop();
  code_.clear();
  filled_ = false;
  changed_ = false;
  refused_.clear();
  problem_.clear();
  person_->show_profile({});
  treatment_->clear();
  scores_->clear();
  primary_->clear();
  stable_->clear();
  show_state();
}

void ProfilePanel::load() {
  if (code_.empty()) return;  // what others loaded is not forgotten for it
  file_.load(code_);
  load_choices();
}

void ProfilePanel::load_choices() {
  if (code_.empty() || !isVisible()) return;
  clinic_.read(
      this,
      [code = code_](storage::SessionStore& store) {
        return reports::primary_choices(store, code);
      },
      [this, code = code_](const Result<std::vector<storage::PrimaryMeasure>>& choices) {
        if (choices && code == code_) primary_->offer(*choices);
      });
}

void ProfilePanel::store_now() {
  person_->finish();
  store();
}

void ProfilePanel::store() {
  delay_.stop();
  if (!filled_) return;
  const storage::PatientProfile now = person_->profile();
  if (now != sent_) {
    sent_ = now;
    changed_ = true;
    ++under_way_;
    file_.save(code_, now, [panel = QPointer(this), code = code_, now](bool stored) {
      if (!panel) return;
      --panel->under_way_;
      if (panel->code_ != code) return;
      if (stored) panel->stored_ = now;
      if (!stored && panel->sent_ == now) panel->sent_ = panel->stored_;  // to be sent again
    });
  }
  show_state();
}

void ProfilePanel::change(const Change& change) {
  changed_ = true;
  ++under_way_;
  change(file_, [panel = QPointer(this), code = code_, change](bool stored) {
    if (!panel) return;
    --panel->under_way_;
    if (!stored && panel->code_ == code) panel->refused_.push_back(change);
  });
  show_state();
}

void ProfilePanel::try_again() {
  if (filled_) {
    store_now();
    for (const Change& refused : std::exchange(refused_, {})) change(refused);
  } else {
    load();
  }
}

void ProfilePanel::take_answer() {
  if (code_.empty() || file_.code() != code_ || !file_.records()) return;
  const PersonRecords& records = *file_.records();
  // Only the first answer goes into the fields: a later one may be older than what is typed.
  if (!filled_) {
    sent_ = stored_ = records.profile;
    person_->show_profile(records.profile);
    filled_ = true;
  }
  treatment_->show_marks(records.marks);
  scores_->show_scores(records.scores);
  primary_->show_primaries(records.primaries);
  stable_->show_periods(records.stable);
  if (refused_.empty() && sent_ == stored_ && person_->profile() == stored_) problem_.clear();
  show_state();
}

void ProfilePanel::refuse(const QString& code, const QString& why) {
  if (code.toStdString() != code_) return;
  problem_ = why;
  show_state();
}

void ProfilePanel::show_state() {
  title_->setText(code_.empty() ? tr("Profile") : QString::fromStdString(code_));
  for (QWidget* card : {static_cast<QWidget*>(person_), static_cast<QWidget*>(treatment_),
                        static_cast<QWidget*>(scores_), static_cast<QWidget*>(primary_),
                        static_cast<QWidget*>(stable_)})
    card->setEnabled(filled_);
  again_->setVisible(!problem_.isEmpty());
  QString words;
  if (code_.empty())
    words = tr("Choose a patient first.");
  else if (!problem_.isEmpty())
    words = filled_ ? tr("⚠ Not saved: %1").arg(problem_) : tr("⚠ Not read: %1").arg(problem_);
  else if (!filled_)
    words = tr("Reading …");
  else if (delay_.isActive() || under_way_ > 0)
    words = tr("Saving …");
  else if (const auto refused = person_->refused(); !refused.isEmpty())
    words = refused;
  else if (changed_)
    words = tr("Saved");
  state_->setText(words);
  const QString role = problem_.isEmpty() ? "quiet" : "problem";
  if (state_->property("role") == role) return;
  state_->setProperty("role", role);
  state_->style()->unpolish(state_);
  state_->style()->polish(state_);
}

void ProfilePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  load_choices();
}

void ProfilePanel::resizeEvent(QResizeEvent* event) {
  columns_->setDirection(event->size().width() >= scaled(kTwoColumns_px) ? QBoxLayout::LeftToRight
                                                                         : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

}  // namespace isograsp::gui

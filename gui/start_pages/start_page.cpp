// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/start_pages/start_page.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/card.hpp"
#include "gui/look/look.hpp"
#include "gui/start_pages/open_session.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {
constexpr int kWideFrom_px = 1500;  // four cards side by side, or three and the chosen person
}  // namespace

StartPage::StartPage(Clinic& clinic, SessionPresenter& presenter, Staff& staff, QWidget* parent)
    : QWidget(parent),
      clinic_(clinic),
      presenter_(presenter),
      staff_(staff),
      book_(new DayBook(clinic, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 8, 8);
  column->setSpacing(8);
  column->addLayout(make_search());
  auto* open = new OpenSessionStrip(presenter_);
  connect(open, &OpenSessionStrip::go_to_session, this, &StartPage::go_to_session);
  column->addWidget(open);
  first_start_ = make_first_start();
  column->addWidget(first_start_);
  empty_ = new QLabel;
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  cards_ = new VisitCards(*book_);
  describe(*cards_, tr("Patients"),
           tr("Choose a patient; Enter begins a session (Tab, arrow keys)"));
  chosen_ = new ChosenPerson(clinic_);
  auto* day = new QHBoxLayout;
  day->setSpacing(16);
  day->addWidget(cards_, 5);
  auto* beside = new QHBoxLayout;
  beside->setContentsMargins(0, 0, 8, 8);
  beside->addWidget(chosen_);
  day->addLayout(beside, 2);
  column->addLayout(day, 1);
  column->addWidget(empty_);
  column->addStretch(0);
  watch();
  offer_demonstration(false);
  fill();
  refresh();
}

void StartPage::watch() {
  connect(book_, &DayBook::changed, this, &StartPage::fill);
  connect(book_, &DayBook::changed, chosen_, &ChosenPerson::renew);
  connect(book_, &DayBook::card_read, cards_, &VisitCards::renew);
  connect(book_, &DayBook::searchable, this, &StartPage::fill);
  connect(&clinic_, &Clinic::patient_added, this, [this](const QString& code) {
    search_->setText({});
    presenter_.choices().choose_patient(code.toStdString());
    fill();
    // Whoever adds a patient begins a session with them.
    Q_EMIT begin_session();
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &StartPage::refresh);
  connect(&presenter_.flow(), &SessionFlow::settled, book_, &DayBook::renew);
  connect(&staff_, &Staff::changed, this, [this] {
    if (staff_.closed()) {
      search_->setText({});  // it may be a name
      book_->forget();
    } else if (book_->people().empty()) {
      book_->renew();  // somebody is in again
    }
    fill();
  });
  connect(cards_, &VisitCards::chosen, this,
          [this](const QString& code) { presenter_.choices().choose_patient(code.toStdString()); });
  connect(cards_, &VisitCards::begin_pressed, this, &StartPage::begin_with);
  connect(cards_, &VisitCards::remove_pressed, this, [this](const QString& code) {
    if (presenter_.state().choices.patient == code.toStdString())
      presenter_.choices().choose_patient({});
    clinic_.remove_patient(code.toStdString());
  });
  connect(cards_, &VisitCards::open_pressed, this, [this](const QString& code) {
    presenter_.choices().choose_patient(code.toStdString());
    Q_EMIT open_patient();
  });
}

QLayout* StartPage::make_search() {
  search_ = new QLineEdit;
  search_->setObjectName("patient_search");
  search_->setPlaceholderText(tr("Search: code, treatment, protocol"));
  search_->setClearButtonEnabled(true);
  describe(*search_, tr("Search patients"),
           tr("A part of the code, of a treatment, of a protocol, or of a name that is shown "
              "(Ctrl+F)"));
  names_ = new QPushButton(tr("Show &names"));
  names_->setObjectName("show_names");
  describe(*names_, tr("Show names"),
           tr("Names beside codes, until the window is locked; the audit log says who read them "
              "(Alt+N)"));
  add_ = new QPushButton(tr("&Add patient"));
  add_->setObjectName("add_patient");
  describe(*add_, tr("Add patient"),
           tr("Add a patient with a generated code and begin a session (Alt+A)"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->setContentsMargins(0, 0, 8, 0);
  row->addWidget(search_, 1);
  row->addWidget(names_);
  row->addWidget(add_);
  connect(search_, &QLineEdit::textChanged, this, &StartPage::fill);
  connect(names_, &QPushButton::clicked, &staff_, &Staff::show_names);
  connect(add_, &QPushButton::clicked, &clinic_, &Clinic::add_patient);
  return row;
}

QWidget* StartPage::make_first_start() {
  auto* card = new Card(tr("This clinic is empty"));
  auto* words = new QLabel(
      tr("Add the first patient, or look around in a demonstration clinic of simulated patients. "
         "It is kept in a file of its own; nothing of it comes into this one."));
  words->setWordWrap(true);
  demonstration_ = new QPushButton;
  demonstration_->setObjectName("demonstration");
  describe(*demonstration_, tr("Open a demonstration clinic"),
           tr("Simulated patients with sessions so far, in a file of their own (Alt+D)"));
  card->column().addWidget(words);
  card->column().addWidget(demonstration_, 0, Qt::AlignLeft);
  connect(demonstration_, &QPushButton::clicked, this, [this] {
    offer_demonstration(true);
    Q_EMIT demonstration_wanted();
  });
  card->hide();
  return card;
}

void StartPage::offer_demonstration(bool making) {
  making_ = making;
  demonstration_->setEnabled(!making);
  demonstration_->setText(making ? tr("Making it …") : tr("Open a &demonstration clinic"));
}

void StartPage::fill() {
  const QString wanted = search_->text().trimmed();
  if (!wanted.isEmpty()) book_->prepare_search();
  std::vector<VisitCards::Shown> found;
  for (const auto& person : book_->people()) {
    const auto code = QString::fromStdString(person.patient.code);
    const auto known = staff_.names().find(person.patient.code);
    const auto name =
        known == staff_.names().end() ? QString() : QString::fromStdString(known->second);
    if (wanted.isEmpty() || code.contains(wanted, Qt::CaseInsensitive) ||
        name.contains(wanted, Qt::CaseInsensitive) || book_->found_by(person.patient.code, wanted))
      found.push_back({person, name});
  }
  cards_->show_people(found);
  const int more = static_cast<int>(found.size()) - VisitCards::kMost;
  empty_->setVisible(found.empty() || more > 0);
  empty_->setText(more > 0                     ? tr("%1 more are found by the search.").arg(more)
                  : clinic_.patients().empty() ? tr("No patients yet. Add the first one.")
                  : wanted.isEmpty()           ? QString()
                                               : tr("Nobody is found by this text."));
  first_start_->setVisible(clinic_.is_open() && clinic_.patients().empty());
  shown_.clear();
  for (std::size_t i = 0; i < found.size() && i < VisitCards::kMost; ++i)
    shown_.push_back(found[i].person.patient);
  read_cards();
  refresh();
}

/// What stands on the cards is read while somebody looks at them.
void StartPage::read_cards() {
  if (isVisible() && !presenter_.state().session_open()) book_->look_at(shown_);
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  show_chosen();
}

void StartPage::show_chosen() {
  show_part(*chosen_, width() >= scaled(kWideFrom_px) && !presenter_.state().session_open());
}

void StartPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  read_cards();
}

/// The protocol that the card names is proposed; all else is asked.
void StartPage::begin_with(const QString& code) {
  presenter_.choices().choose_patient(code.toStdString());
  const auto& state = presenter_.state();
  const DayCard* card = book_->card(code.toStdString());
  if (card != nullptr && card->last && !state.busy())
    presenter_.library().propose(card->last->protocol_name);
  Q_EMIT begin_session();
}

void StartPage::refresh() {
  const auto& view = presenter_.flow().view();
  const SessionState& state = presenter_.state();
  names_->setVisible(staff_.is_protected() && staff_.allows(storage::Right::identities) &&
                     staff_.names().empty());
  // While a session is open no other person is on any screen.
  const bool open = state.session_open();
  show_part(*cards_, !open);
  search_->setEnabled(!open);
  show_chosen();
  cards_->setEnabled(view.may_change_patient);
  cards_->allow(view.may_change_patient && !state.config.look_only, view.may_change_patient);
  add_->setEnabled(view.may_change_patient && !state.config.look_only);
  cards_->choose(QString::fromStdString(state.choices.patient));
  chosen_->show_person(staff_.closed() ? std::string() : state.choices.patient);
  const bool next = view.next() == Step::patient && view.may_change_patient;
  mark_next(*add_, next && clinic_.patients().empty());
  mark_choice(*cards_, next && !clinic_.patients().empty());
  cards_->mark_begin(view.may_change_patient && !state.config.look_only);
  Q_EMIT renewed();
}

}  // namespace isograsp::gui

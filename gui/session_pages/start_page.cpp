// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/start_page.hpp"

#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/card.hpp"
#include "gui/look/look.hpp"
#include "gui/look/two_line_delegate.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

namespace {

constexpr int kStartRow_px = 28;

}  // namespace

StartPage::StartPage(Clinic& clinic, SessionPresenter& presenter, Staff& staff, QWidget* parent)
    : QWidget(parent), clinic_(clinic), presenter_(presenter), staff_(staff) {
  auto* columns = new QBoxLayout(side_by_side(), this);
  columns->setContentsMargins(12, 12, 12, 12);
  columns->setSpacing(12);
  columns->addWidget(make_patients(), 2);
  auto* right = new QVBoxLayout;
  right->setSpacing(12);
  first_start_ = make_first_start();
  right->addWidget(first_start_);
  right->addWidget(make_recent(), 1);
  columns->addLayout(right, 3);
  connect(&clinic_, &Clinic::patients_changed, this, &StartPage::fill);
  connect(&clinic_, &Clinic::patients_changed, this, &StartPage::load_recent);
  connect(&clinic_, &Clinic::patient_added, this, [this](const QString& code) {
    search_->setText({});
    presenter_.choices().choose_patient(code.toStdString());
    fill();
    // Whoever adds a patient begins a session with them.
    Q_EMIT begin_session();
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &StartPage::refresh);
  connect(&staff_, &Staff::changed, this, [this] {
    if (staff_.closed()) search_->setText({});  // it may be a name
    fill();
  });
  connect(&presenter_.flow(), &SessionFlow::settled, this, &StartPage::load_recent);
  offer_demonstration(false);
  fill();
  load_recent();
  refresh();
}

QWidget* StartPage::make_patients() {
  auto* card = new Card(tr("Patients"));
  search_ = new QLineEdit;
  search_->setObjectName("patient_search");
  search_->setPlaceholderText(tr("Search a code"));
  search_->setClearButtonEnabled(true);
  describe(*search_, tr("Search patients"), tr("Type a part of the code (Ctrl+F)"));
  names_ = new QPushButton(tr("Show &names"));
  names_->setObjectName("show_names");
  describe(*names_, tr("Show names"),
           tr("Names beside codes, until the window is locked; the audit log says who read them "
              "(Alt+N)"));
  connect(names_, &QPushButton::clicked, &staff_, &Staff::show_names);
  list_ = new QListWidget;
  list_->setObjectName("patient_list");
  list_->setItemDelegate(new TwoLineDelegate(list_));
  take_rest(*list_, 3 * kStartRow_px);
  describe(*list_, tr("Patients"),
           tr("Choose a patient; Enter begins a session (Tab, arrow keys)"));
  empty_ = new QLabel;
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  add_ = new QPushButton(tr("&Add patient"));
  add_->setObjectName("add_patient");
  describe(*add_, tr("Add patient"),
           tr("Add a patient with a generated code and begin a session (Alt+A)"));
  begin_ = new QPushButton(tr("&Begin session"));
  begin_->setObjectName("begin_session");
  describe(*begin_, tr("Begin a session"), tr("With the chosen patient (Alt+B)"));
  open_ = new QPushButton(tr("Open pat&ient"));
  open_->setObjectName("open_patient");
  describe(*open_, tr("Open the patient"), tr("Sessions, measures and trials so far (Alt+I)"));
  auto* acts = new QHBoxLayout;
  acts->setSpacing(8);
  acts->addWidget(begin_, 1);
  acts->addWidget(open_, 1);
  auto& column = card->column();
  auto* seek = new QHBoxLayout;
  seek->setSpacing(8);
  seek->addWidget(search_, 1);
  seek->addWidget(names_);
  column.addLayout(seek);
  column.addWidget(empty_);
  column.addWidget(list_, 1);
  column.addLayout(acts);
  column.addWidget(add_);
  connect(search_, &QLineEdit::textChanged, this, &StartPage::fill);
  connect(list_, &QListWidget::currentTextChanged, this, [this](const QString& code) {
    if (!code.isEmpty()) presenter_.choices().choose_patient(code.toStdString());
  });
  connect(list_, &QListWidget::itemActivated, this, &StartPage::begin_session);
  connect(add_, &QPushButton::clicked, &clinic_, &Clinic::add_patient);
  connect(begin_, &QPushButton::clicked, this, &StartPage::begin_session);
  connect(open_, &QPushButton::clicked, this, &StartPage::open_patient);
  return card;
}

QWidget* StartPage::make_recent() {
  auto* card = new Card(tr("Recent sessions"));
  recent_ = new QTableWidget(0, 4);
  recent_->setObjectName("recent_sessions");
  recent_->setHorizontalHeaderLabels({tr("When"), tr("Patient"), tr("Hand"), tr("Protocol")});
  recent_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  recent_->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  recent_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  recent_->verticalHeader()->hide();
  recent_->verticalHeader()->setDefaultSectionSize(scaled(kStartRow_px));
  recent_->setShowGrid(false);
  recent_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  recent_->setSelectionBehavior(QAbstractItemView::SelectRows);
  recent_->setSelectionMode(QAbstractItemView::SingleSelection);
  recent_->setTabKeyNavigation(false);
  take_rest(*recent_, 3 * kStartRow_px);
  describe(*recent_, tr("Recent sessions"), tr("Enter opens the patient (Tab, arrow keys)"));
  no_recent_ = new QLabel(tr("No sessions yet."));
  no_recent_->setProperty("role", "quiet");
  auto& column = card->column();
  no_recent_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  column.addWidget(no_recent_, 1);  // in the place of the table
  column.addWidget(recent_, 1);
  connect(recent_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int row = recent_->currentRow();
    if (row >= 0 && !recent_->selectedItems().isEmpty())
      presenter_.choices().choose_patient(recent_->item(row, 1)->text().toStdString());
  });
  connect(recent_, &QTableWidget::itemActivated, this, &StartPage::open_patient);
  return card;
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
  const QSignalBlocker quiet(list_);
  list_->clear();
  const auto chosen = QString::fromStdString(presenter_.state().choices.patient);
  // The newest sessions and patients come first: they are the most likely ones to be looked for.
  auto patients = clinic_.patients();
  const auto newest = [this](const storage::PatientRecord& patient) {
    const auto session = newest_.find(patient.id);
    return session == newest_.end() ? patient.created_utc
                                    : std::max(session->second.started_utc, patient.created_utc);
  };
  std::stable_sort(patients.begin(), patients.end(), [&](const auto& a, const auto& b) {
    return std::pair(newest(a), a.id) > std::pair(newest(b), b.id);
  });
  const auto today = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  for (const auto& patient : patients) {
    const auto code = QString::fromStdString(patient.code);
    const auto known = staff_.names().find(patient.code);
    const auto name =
        known == staff_.names().end() ? QString() : QString::fromStdString(known->second);
    const auto wanted = search_->text().trimmed();
    if (!code.contains(wanted, Qt::CaseInsensitive) && !name.contains(wanted, Qt::CaseInsensitive))
      continue;
    const auto session = newest_.find(patient.id);
    const bool here = local_date(newest(patient)) == local_date(today);
    const auto below = session == newest_.end()
                           ? tr("No session yet; added %1").arg(local_date(patient.created_utc))
                           : tr("Last session %1, %2")
                                 .arg(local_time(session->second.started_utc),
                                      !session->second.hand                ? tr("both hands")
                                      : session->second.hand == Hand::left ? tr("left hand")
                                                                           : tr("right hand"));
    add_two_lines(*list_, {code, here ? tr("TODAY") : QString(),
                           name.isEmpty() ? below : tr("%1. %2").arg(name, below)});
    if (code == chosen) list_->setCurrentRow(list_->count() - 1);
  }
  empty_->setVisible(list_->count() == 0);
  empty_->setText(patients.empty() ? tr("No patients yet. Add the first one.")
                                   : tr("No code contains this text."));
  first_start_->setVisible(clinic_.is_open() && patients.empty());
  refresh();
}

void StartPage::load_recent() {
  if (!clinic_.is_open()) return;
  constexpr int kMost = 1000;  // for the last session of each patient; read in milliseconds
  clinic_.read(
      this, [](storage::SessionStore& store) { return store.recent_sessions(kMost); },
      [this](const Result<std::vector<storage::SessionRecord>>& sessions) {
        if (!sessions) return;
        newest_.clear();
        for (const auto& session : *sessions) newest_.emplace(session.patient_id, session);
        fill();
        fill_recent(*sessions);
      });
}

void StartPage::fill_recent(const std::vector<storage::SessionRecord>& sessions) {
  constexpr std::size_t kMostShown = 40;
  const QSignalBlocker quiet(recent_);
  recent_->setRowCount(0);
  for (const auto& session : sessions) {
    if (static_cast<std::size_t>(recent_->rowCount()) == kMostShown) break;
    const int row = recent_->rowCount();
    recent_->insertRow(row);
    QString code;
    for (const auto& patient : clinic_.patients())
      if (patient.id == session.patient_id) code = QString::fromStdString(patient.code);
    const auto hand = !session.hand                ? tr("both")
                      : session.hand == Hand::left ? tr("left")
                                                   : tr("right");
    auto what = gui::translated(session.protocol_name);
    if (what.isEmpty()) what = tr("Tasks one by one");
    if (session.simulated) what = tr("%1, simulated").arg(what);
    const std::array<QString, 4> texts{local_time(session.started_utc), code, hand, what};
    for (int column = 0; column < 4; ++column)
      recent_->setItem(row, column, new QTableWidgetItem(texts[static_cast<std::size_t>(column)]));
  }
  no_recent_->setVisible(recent_->rowCount() == 0);
  recent_->setVisible(recent_->rowCount() > 0);
}

void StartPage::refresh() {
  const auto& view = presenter_.flow().view();
  const bool chosen = !presenter_.state().choices.patient.empty();
  names_->setVisible(staff_.is_protected() && staff_.allows(storage::Right::identities) &&
                     staff_.names().empty());
  list_->setEnabled(view.may_change_patient);
  recent_->setEnabled(view.may_change_patient);
  add_->setEnabled(view.may_change_patient && !presenter_.state().config.look_only);
  begin_->setEnabled(chosen && !presenter_.state().config.look_only);
  open_->setEnabled(chosen);
  const bool next = view.next() == Step::patient && view.may_change_patient;
  mark_next(*add_, next && clinic_.patients().empty());
  mark_choice(*list_, next && !clinic_.patients().empty());
  mark_next(*begin_, chosen && view.may_change_patient);
  const auto code = QString::fromStdString(presenter_.state().choices.patient);
  const auto shown = list_->currentItem() == nullptr ? QString() : list_->currentItem()->text();
  if (code != shown) {
    const QSignalBlocker quiet(list_);
    list_->setCurrentRow(-1);  // nobody, so that a click on any row chooses
    for (int row = 0; row < list_->count(); ++row)
      if (list_->item(row)->text() == code) list_->setCurrentRow(row);
  }
  Q_EMIT renewed();
}

}  // namespace isograsp::gui

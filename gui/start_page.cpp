// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/start_page.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/card.hpp"
#include "gui/look.hpp"
#include "gui/words.hpp"

namespace isograsp {

namespace {

constexpr int kRow_px = 28;

}  // namespace

StartPage::StartPage(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), clinic_(clinic), presenter_(presenter) {
  auto* columns = new QHBoxLayout(this);
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
  connect(&clinic_, &Clinic::patients_changed, this, &StartPage::fill_recent);
  connect(&clinic_, &Clinic::patient_added, this, [this](const QString& code) {
    search_->clear();
    presenter_.choose_patient(code.toStdString());
    fill();
    // Whoever adds a patient begins a session with them.
    Q_EMIT begin_session();
  });
  connect(&presenter_, &SessionPresenter::changed, this, &StartPage::refresh);
  connect(&presenter_, &SessionPresenter::settled, this, &StartPage::fill_recent);
  fill();
  refresh();
}

QWidget* StartPage::make_patients() {
  auto* card = new Card(tr("Patients"));
  search_ = new QLineEdit;
  search_->setObjectName("patient_search");
  search_->setPlaceholderText(tr("Search a code"));
  search_->setClearButtonEnabled(true);
  describe(*search_, tr("Search patients"), tr("Type a part of the code (Ctrl+F)"));
  list_ = new QListWidget;
  list_->setObjectName("patient_list");
  take_rest(*list_, 3 * kRow_px);
  describe(*list_, tr("Patients"),
           tr("Choose a patient; Enter begins a session (Tab, arrow keys)"));
  empty_ = new QLabel;
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  add_ = new QPushButton(tr("&Add patient"));
  add_->setObjectName("add_patient");
  describe(*add_, tr("Add patient"),
           tr("Add a patient with a generated code and begin a session; names are never stored "
              "(Alt+A)"));
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
  column.addWidget(search_);
  column.addWidget(empty_);
  column.addWidget(list_, 1);
  column.addLayout(acts);
  column.addWidget(add_);
  connect(search_, &QLineEdit::textChanged, this, &StartPage::fill);
  connect(list_, &QListWidget::currentTextChanged, this, [this](const QString& code) {
    if (!code.isEmpty()) presenter_.choose_patient(code.toStdString());
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
  recent_->verticalHeader()->setDefaultSectionSize(kRow_px);
  recent_->setShowGrid(false);
  recent_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  recent_->setSelectionBehavior(QAbstractItemView::SelectRows);
  recent_->setSelectionMode(QAbstractItemView::SingleSelection);
  recent_->setTabKeyNavigation(false);
  take_rest(*recent_, 3 * kRow_px);
  describe(*recent_, tr("Recent sessions"), tr("Enter opens the patient (Tab, arrow keys)"));
  no_recent_ = new QLabel(tr("No sessions yet."));
  no_recent_->setProperty("role", "quiet");
  auto& column = card->column();
  column.addWidget(no_recent_);
  column.addWidget(recent_, 1);
  connect(recent_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int row = recent_->currentRow();
    if (row >= 0 && !recent_->selectedItems().isEmpty())
      presenter_.choose_patient(recent_->item(row, 1)->text().toStdString());
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
  demonstration_ = new QPushButton(tr("Open a &demonstration clinic"));
  demonstration_->setObjectName("demonstration");
  describe(*demonstration_, tr("Open a demonstration clinic"),
           tr("Simulated patients with sessions so far, in a file of their own (Alt+D)"));
  card->column().addWidget(words);
  card->column().addWidget(demonstration_, 0, Qt::AlignLeft);
  connect(demonstration_, &QPushButton::clicked, this, [this] {
    demonstration_->setEnabled(false);
    demonstration_->setText(tr("Making it …"));
    Q_EMIT demonstration_wanted();
  });
  card->hide();
  return card;
}

void StartPage::fill() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  const auto chosen = QString::fromStdString(presenter_.patient());
  // Newest first: the patient who was added last is the likeliest one to be sought.
  const auto& patients = clinic_.patients();
  for (auto patient = patients.rbegin(); patient != patients.rend(); ++patient) {
    const auto code = QString::fromStdString(patient->code);
    if (!code.contains(search_->text().trimmed(), Qt::CaseInsensitive)) continue;
    list_->addItem(code);
    list_->item(list_->count() - 1)->setSizeHint({0, kRow_px});
    if (code == chosen) list_->setCurrentRow(list_->count() - 1);
  }
  empty_->setVisible(list_->count() == 0);
  empty_->setText(patients.empty() ? tr("No patients yet. Add the first one.")
                                   : tr("No code contains this text."));
  first_start_->setVisible(clinic_.is_open() && patients.empty());
  refresh();
}

void StartPage::fill_recent() {
  if (!clinic_.is_open()) return;
  constexpr int kMost = 40;
  clinic_.read(
      this, [](SessionStore& store) { return store.recent_sessions(kMost); },
      [this](const Result<std::vector<SessionRecord>>& sessions) {
        if (!sessions) return;
        const QSignalBlocker quiet(recent_);
        recent_->setRowCount(0);
        for (const auto& session : *sessions) {
          const int row = recent_->rowCount();
          recent_->insertRow(row);
          QString code;
          for (const auto& patient : clinic_.patients())
            if (patient.id == session.patient_id) code = QString::fromStdString(patient.code);
          const auto hand = session.hand == Hand::left ? tr("left") : tr("right");
          auto what = QString::fromStdString(session.protocol_name);
          if (what.isEmpty()) what = tr("Tasks one by one");
          if (session.simulated) what = tr("%1, simulated").arg(what);
          const std::array<QString, 4> texts{local_time(session.started_utc), code, hand, what};
          for (int column = 0; column < 4; ++column)
            recent_->setItem(row, column,
                             new QTableWidgetItem(texts[static_cast<std::size_t>(column)]));
        }
        no_recent_->setVisible(recent_->rowCount() == 0);
        recent_->setVisible(recent_->rowCount() > 0);
      });
}

void StartPage::refresh() {
  const auto& view = presenter_.view();
  const bool chosen = !presenter_.patient().empty();
  list_->setEnabled(view.may_change_patient);
  recent_->setEnabled(view.may_change_patient);
  add_->setEnabled(view.may_change_patient);
  begin_->setEnabled(chosen);
  open_->setEnabled(chosen);
  const bool next = view.next() == Step::patient && view.may_change_patient;
  mark_next(*add_, next && clinic_.patients().empty());
  mark_next(*list_, next && !clinic_.patients().empty());
  mark_next(*begin_, chosen && view.may_change_patient);
  const auto code = QString::fromStdString(presenter_.patient());
  const auto shown = list_->currentItem() == nullptr ? QString() : list_->currentItem()->text();
  if (code != shown) {
    const QSignalBlocker quiet(list_);
    for (int row = 0; row < list_->count(); ++row)
      if (list_->item(row)->text() == code) list_->setCurrentRow(row);
  }
}

}  // namespace isograsp

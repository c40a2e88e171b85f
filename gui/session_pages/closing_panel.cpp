// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/closing_panel.hpp"

#include <QHBoxLayout>
#include <QHeaderView>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/look.hpp"
#include "gui/look/value_table.hpp"
#include "gui/session_pages/other_hand_button.hpp"
#include "gui/words/language.hpp"
#include "gui/words/texts.hpp"
#include "reports/findings/progress_report.hpp"

namespace isograsp::gui {

namespace {

constexpr int kClosingRow_px = 34;

QLabel* make_line(const char* name) {
  auto* line = new QLabel;
  line->setObjectName(QLatin1String(name));
  line->setWordWrap(true);
  return line;
}

QString felt_words(const Rating& rating) {
  if (!rating.last) return ClosingPanel::tr("Effort and pain: not asked yet.");
  const auto words = ClosingPanel::tr("Effort %1 of 10, pain %2 of 10.")
                         .arg(rating.last->effort)
                         .arg(rating.last->pain);
  return rating.stop_reason.empty() ? words
                                    : words + QLatin1Char(' ') + translated(rating.stop_reason);
}

}  // namespace

ClosingPanel::ClosingPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Today"), parent), clinic_(clinic), presenter_(presenter) {
  title_->setProperty("role", "large");
  column_->setSpacing(12);
  printing_ = new PrintJob(this);
  make_table();
  valid_ = make_line("closing_valid");
  felt_ = make_line("closing_felt");
  next_ = make_line("closing_next");
  remark_ = make_line("closing_remark");
  remark_->setProperty("role", "quiet");
  for (QLabel* line : {valid_, felt_, next_}) column_->addWidget(line);
  column_->addStretch(1);
  column_->addWidget(remark_);
  make_buttons();
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ClosingPanel::refresh);
  connect(&clinic_, &Clinic::history_changed, this, [this] {
    if (session_ != 0) read();
  });
  refresh();
}

ClosingPanel::~ClosingPanel() {
  reading_.request_stop();
}

void ClosingPanel::make_table() {
  table_ = make_value_table("closing", {tr("Measure"), tr("Today"), tr("Last time"), tr("Change")},
                            kClosingRow_px);
  describe(*table_, tr("Today against last time"),
           tr("Means of today's trials and of the session before; a verdict of change for the "
              "primary measures (Tab, arrow keys)"));
  for (int column = 1; column < table_->columnCount(); ++column)
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->verticalHeader()->setDefaultSectionSize(scaled(kClosingRow_px));
  table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  column_->addWidget(table_);
}

void ClosingPanel::make_buttons() {
  const auto make = [](const QString& text, const char* name, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setMinimumHeight(scaled(38));
    describe(*button, QString(text).remove(QLatin1Char('&')), tip);
    return button;
  };
  print_ = make(tr("Print for the patient …"), "closing_print",
                tr("The page in large letters that the patient takes home (Tab, then Enter)"));
  report_ = make(tr("Report …"), "closing_report",
                 tr("All of this patient's report, on its page (Ctrl+R)"));
  end_ = make(tr("End and next patient"), "closing_end",
              tr("Ends the session and shows who comes today (F8)"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  auto* other_hand = new OtherHandButton(presenter_, "closing_other_hand");
  other_hand->setMinimumHeight(scaled(38));
  for (QPushButton* button : {print_, report_, static_cast<QPushButton*>(other_hand), end_})
    row->addWidget(button, 1);
  column_->addLayout(row);
  connect(print_, &QPushButton::clicked, this, [this] {
    if (pages_ == nullptr || !pages_->patient_page()) return;
    printing_->ask(pages_, QString::fromStdString(presenter_.state().choices.patient),
                   *pages_->patient_page());
  });
  connect(report_, &QPushButton::clicked, this, &ClosingPanel::report_wanted);
  connect(end_, &QPushButton::clicked, this, &ClosingPanel::end_wanted);
  connect(printing_, &PrintJob::ended, this, [this](const QString& code, bool done) {
    remark_->setText(done ? tr("The page for the patient was sent to the printer.")
                          : tr("The printer takes nothing: is it connected, has it paper?"));
    Q_EMIT sent(code, done);
  });
}

void ClosingPanel::refresh() {
  const FlowView& view = presenter_.flow().view();
  const SessionState& state = presenter_.state();
  const storage::RowId session =
      view.closes ? state.open->session->known().record.id : storage::RowId{0};
  mark_next(*end_, view.press == NextPress::end);
  end_->setEnabled(view.may_disconnect);
  if (session != 0) felt_->setText(felt_words(state.rating()));
  if (session == session_) return;
  session_ = session;
  reading_.request_stop();
  pages_.reset();
  remark_->clear();
  show_closing({});
  if (session_ != 0) {
    hand_ = state.open->session->known().record.hand;
    title_->setText(
        tr("Today: %1, %2").arg(QString::fromStdString(state.choices.patient), hand_words(hand_)));
    read();
  }
  Q_EMIT shown_or_hidden();
}

/// As the report says it. The worker has stored the last trial before. The session may have been
/// closed meanwhile.
void ClosingPanel::read() {
  reading_.request_stop();
  reading_ = {};
  const auto stop = reading_.get_token();
  valid_->setText(tr("Looking at what is stored …"));
  (void)clinic_.read(
      this,
      [code = presenter_.state().choices.patient, stop](storage::SessionStore& store) {
        return reports::gather_progress(
            store, code, [stop](double, const Text&) { return !stop.stop_requested(); });
      },
      [this, stop](Result<reports::ReportContent> content) {
        if (stop.stop_requested()) return;
        if (!content) return valid_->setText(translated(content.error()));
        show_closing(closing_of(*content, hand_));
        pages_ = std::make_shared<const reports::ReportPages>(*std::move(content),
                                                              languages::language(spoken()));
        print_->setEnabled(pages_->patient_page().has_value());
      });
}

void ClosingPanel::show_closing(const Closing& closing) {
  print_->setEnabled(false);
  QFont strong = table_->font();
  strong.setBold(true);
  table_->setRowCount(static_cast<int>(closing.rows.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const ClosingRow& one = closing.rows[static_cast<std::size_t>(row)];
    const QStringList texts{one.measure, one.today,
                            one.before.isEmpty() ? tr("first time") : one.before, one.verdict};
    for (int column = 0; column < texts.size(); ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      item->setToolTip(texts[column]);
      if (column == 1) item->setFont(strong);
      table_->setItem(row, column, item);
    }
  }
  table_->setVisible(table_->rowCount() > 0);
  // As high as its rows: what is said of them stands right below.
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         table_->rowCount() * scaled(kClosingRow_px) + 2 * table_->frameWidth());
  valid_->setText(closing.doubts.isEmpty()
                      ? tr("Valid: nothing that was recorded speaks against today's values.")
                      : tr("To be kept in mind. %1").arg(closing.doubts.join(QLatin1Char(' '))));
  next_->setText(closing.next);
  next_->setVisible(!closing.next.isEmpty());
}

}  // namespace isograsp::gui

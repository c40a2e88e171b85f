// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/report_panel.hpp"

#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QUrl>
#include <QVBoxLayout>

#include "gui/clinic/save_folder.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/language.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr double kZoomStep = 1.25;

template <class Button>
Button* named(Button* button, const char* name, const QString& title, const QString& tooltip) {
  button->setObjectName(QLatin1String(name));
  describe(*button, title, tooltip);
  return button;
}

}  // namespace

ReportPanel::ReportPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), clinic_(clinic), presenter_(presenter) {
  auto* choices = make_choices();
  lay_out_choices(*this, *choices, *make_preview());
  printing_ = new PrintJob(this);
  connect_report();
  connect(&clinic_, &Clinic::history_changed, this, &ReportPanel::look_again);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ReportPanel::refresh);
  refresh();
}

ReportPanel::~ReportPanel() {
  reading_stop_.request_stop();
}

QWidget* ReportPanel::make_choices() {
  auto* card = new Card(tr("Progress report"));
  patient_ = new QLabel;
  patient_->setObjectName("report_patient");
  patient_->setProperty("role", "large");
  span_ = new SessionSpan(tr("&From session"), tr("&To session"), "report");
  format_ = named(new ChoiceBox, "report_format", tr("Format"),
                  tr("What is written (Alt+O, then arrow keys)"));
  format_->addItem(tr("PDF"), "pdf");
  format_->addItem(tr("Web page (HTML)"), "html");
  auto* format_label = new QLabel(tr("F&ormat"));
  format_label->setBuddy(format_);
  format_remark_ = new QLabel(
      tr("The web page has the same plots and numbers, with a table beside every plot."));
  format_remark_->setProperty("role", "quiet");
  format_remark_->setWordWrap(true);
  report_ = named(new QPushButton(tr("&Save as …")), "report", tr("Save the report"),
                  tr("Write the patient's progress report (Ctrl+R, Alt+S)"));
  print_ = named(new QPushButton(tr("&Print …")), "report_print", tr("Print the report"),
                 tr("The pages that are shown, on paper; not during a trial (Alt+P)"));
  writing_ = new WorkProgress("report", tr("Progress of the report"));
  writing_->cancel().setText(tr("Cancel"));
  describe(writing_->cancel(), tr("Cancel the report"),
           tr("Write no report; a file that was there stays as it is (Escape)"));
  writing_->cancel().setShortcut(Qt::Key_Escape);
  remark_ = new QLabel;
  remark_->setObjectName("report_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  remark_->setTextInteractionFlags(Qt::LinksAccessibleByMouse);
  auto& column = card->column();
  column.addWidget(patient_);
  column.addWidget(span_);
  column.addWidget(format_label);
  column.addWidget(format_);
  column.addWidget(format_remark_);
  column.addSpacing(6);
  column.addWidget(report_);
  column.addWidget(print_);
  column.addWidget(writing_);
  column.addWidget(remark_);
  column.addStretch(1);
  connect(span_, &SessionSpan::changed, this, &ReportPanel::load_pages);
  connect(format_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ReportPanel::refresh);
  connect(report_, &QPushButton::clicked, this, &ReportPanel::ask_where);
  connect(print_, &QPushButton::clicked, this, &ReportPanel::ask_printer);
  return card;
}

QWidget* ReportPanel::make_preview() {
  auto* card = new Card({});
  where_ = card->findChild<QLabel*>();
  where_->setObjectName("report_where");
  smaller_ = named(new QPushButton(tr("S&maller")), "report_smaller", tr("Smaller"),
                   tr("Smaller pages (Alt+M, Ctrl and the wheel)"));
  larger_ = named(new QPushButton(tr("&Larger")), "report_larger", tr("Larger"),
                  tr("Larger pages (Alt+L, Ctrl and the wheel)"));
  fit_ = named(new QPushButton(tr("Fit wi&dth")), "report_fit", tr("Fit width"),
               tr("A page as wide as the view (Alt+D)"));
  auto* head = new QHBoxLayout;
  head->setSpacing(6);
  card->column().removeWidget(where_);
  head->addWidget(where_, 1);
  for (auto* button : {smaller_, larger_, fit_}) head->addWidget(button);
  view_ = named(new PageView, "report_pages", tr("Preview of the report"),
                tr("The pages that will be written (arrow keys, Page Up, Page Down, Home, End)"));
  nothing_ = new QLabel;
  nothing_->setObjectName("report_nothing");
  nothing_->setProperty("role", "quiet");
  card->column().addLayout(head);
  card->column().addWidget(nothing_);
  card->column().addWidget(view_, 1);
  connect(smaller_, &QPushButton::clicked, this, [this] { view_->zoom(1.0 / kZoomStep); });
  connect(larger_, &QPushButton::clicked, this, [this] { view_->zoom(kZoomStep); });
  connect(fit_, &QPushButton::clicked, view_, &PageView::fit_width);
  connect(view_, &PageView::moved, this, &ReportPanel::refresh);
  return card;
}

void ReportPanel::connect_report() {
  ReportWork& report = clinic_.report();
  connect(&writing_->cancel(), &QPushButton::clicked, &report, &ReportWork::cancel);
  connect(&report, &ReportWork::progress, this, [this](double fraction, const QString& words) {
    writing_->show_fraction(fraction);
    at_ = words;
    refresh();
  });
  const auto tell = [this](const QString& what) {
    remark_->setText(what);
    refresh();
  };
  connect(&report, &ReportWork::written, this, [tell](const QString& path) {
    tell(tr("Report written: <a href=\"%1\">%2</a>")
             .arg(QUrl::fromLocalFile(path).toString(), path.toHtmlEscaped()));
  });
  connect(&report, &ReportWork::failed, this, [tell](const QString& why) {
    tell(tr("No report was written: %1").arg(why.toHtmlEscaped()));
  });
  connect(&report, &ReportWork::cancelled, this,
          [tell] { tell(tr("Cancelled: no report was written.")); });
  connect(printing_, &PrintJob::progress, this, [tell](int page, int pages) {
    tell(tr("Printing page %1 of %2 …").arg(page).arg(pages));
  });
  connect(printing_, &PrintJob::ended, this, [this, tell](const QString& code, bool done) {
    Q_EMIT sent(code, done);
    Q_EMIT printed();
    tell(done ? tr("The report was sent to the printer.")
              : tr("The printer takes nothing: is it connected, has it paper?"));
  });
  connect(remark_, &QLabel::linkActivated, this,
          [](const QString& link) { QDesktopServices::openUrl(QUrl(link)); });
}

void ReportPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_ || code_ != presenter_.state().choices.patient) load_sessions();
}

void ReportPanel::forget() {
  reading_stop_.request_stop();
  reading_ = false;
  pages_.reset();
  view_->show_pages(nullptr);
  span_->show_sessions({}, false);
  code_.clear();
  refresh();
}

/// Another patient, or something new is stored of this one.
void ReportPanel::look_again() {
  stale_ = true;
  if (isVisible()) load_sessions();
  refresh();
}

void ReportPanel::load_sessions() {
  const auto code = presenter_.state().choices.patient;
  const bool same = code == code_;
  if (!same) forget();
  code_ = code;
  stale_ = false;
  if (code.empty()) return refresh();
  using Sessions = Result<std::vector<storage::SessionRecord>>;
  const bool asked = clinic_.read(
      this,
      [code](storage::SessionStore& store) -> Sessions {
        const auto patient = store.find_patient(code);
        if (!patient) return patient.error();
        if (!*patient) return std::vector<storage::SessionRecord>{};
        return store.sessions((*patient)->id);
      },
      [this, code, same](const Sessions& sessions) {
        if (code != code_) return;
        if (!sessions) return refresh();
        span_->show_sessions(*sessions, same);
        load_pages();
      });
  if (!asked) stale_ = true;
  refresh();
}

void ReportPanel::load_pages() {
  if (code_.empty()) return;
  reading_stop_.request_stop();  // what was asked before is of no use any more
  reading_stop_ = {};
  reading_ = clinic_.read(
      this,
      [code = code_, scope = scope(),
       stop = reading_stop_.get_token()](storage::SessionStore& store) {
        return reports::gather_progress(
            store, code, [stop](double, const Text&) { return !stop.stop_requested(); }, scope);
      },
      [this, stop = reading_stop_.get_token()](Result<reports::ReportContent> content) {
        if (!stop.stop_requested()) show_pages(std::move(content));
      });
  refresh();
}

void ReportPanel::show_pages(Result<reports::ReportContent> content) {
  reading_ = false;
  if (content) {
    pages_ = std::make_shared<const reports::ReportPages>(*std::move(content),
                                                          languages::language(spoken()));
    view_->show_pages(pages_);
  } else {
    pages_.reset();
    view_->show_pages(nullptr);
    remark_->setText(translated(content.error()).toHtmlEscaped());
  }
  refresh();
}

void ReportPanel::ask_where() {
  const auto folder = proposed_folder(clinic_.database());
  const auto code = presenter_.state().choices.patient;
  const bool html = format_->currentData() == "html";
  const auto suffix = html ? QStringLiteral("html") : QStringLiteral("pdf");
  const auto name = QString::fromStdString(code) + QStringLiteral(".") + suffix;
  auto* dialog = new QFileDialog(this, tr("Write the report"), folder,
                                 html ? tr("Web page (*.html)") : tr("Portable document (*.pdf)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(suffix);
  dialog->selectFile(QDir(folder).filePath(name));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, code, scope = scope()](const QString& path) {
            remark_->clear();
            clinic_.report().start(code, path.toStdString(), scope);
          });
  dialog->open();
}

void ReportPanel::ask_printer() {
  if (presenter_.flow().view().may_stop) return;
  printing_->ask(pages_, QString::fromStdString(code_));
}

void ReportPanel::refresh() {
  ReportWork& report = clinic_.report();
  // A trial needs its even picture: the pages wait for its end.
  const bool waits = presenter_.flow().view().may_stop;
  report.hold(waits);
  view_->hold(waits);
  printing_->hold(waits);
  const bool chosen = !presenter_.state().choices.patient.empty();
  patient_->setText(chosen ? QString::fromStdString(presenter_.state().choices.patient)
                           : tr("No patient is chosen."));
  report_->setEnabled(chosen && !report.running());
  print_->setEnabled(pages_ != nullptr && !printing() && !waits);
  format_->setEnabled(chosen);
  format_remark_->setVisible(format_->currentData() == "html");
  writing_->setVisible(report.running());
  writing_->cancel().setEnabled(report.may_cancel());
  if (report.running())
    writing_->say(waits ? tr("Report of %1: waits for the end of the trial")
                              .arg(QString::fromStdString(report.code()))
                        : tr("Report of %1: %2").arg(QString::fromStdString(report.code()), at_));
  remark_->setVisible(!remark_->text().isEmpty() && !report.running());
  const bool shown = view_->pages() > 0;
  for (auto* button : {smaller_, larger_, fit_}) button->setEnabled(shown);
  where_->setText(shown ? tr("Page %1 of %2, %3 %")
                              .arg(view_->page())
                              .arg(view_->pages())
                              .arg(100.0 * view_->scale(), 0, 'f', 0)
                        : tr("Preview"));
  view_->setVisible(shown);
  nothing_->setVisible(!shown);
  nothing_->setText(!chosen    ? tr("Choose a patient on the start page to see the report.")
                    : reading_ ? tr("Reading what is stored …")
                               : tr("Nothing can be shown."));
}

}  // namespace isograsp::gui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/export_panel.hpp"

#include <QDesktopServices>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QUrl>
#include <QVBoxLayout>

#include "gui/clinic/save_folder.hpp"
#include "gui/look/card.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kMostListed = 2000;  // a list is read by people

QLabel* label_for(QWidget& field, const QString& words) {
  auto* label = new QLabel(words);
  label->setBuddy(&field);
  return label;
}

}  // namespace

ExportPanel::ExportPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), clinic_(clinic), presenter_(presenter) {
  auto* choices = make_choices();
  lay_out_choices(*this, *choices, *make_list());
  connect(&clinic_, &Clinic::history_changed, this, &ExportPanel::look_again);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ExportPanel::refresh);
  ExportWork& work = clinic_.research_export();
  connect(&work, &ExportWork::progress, this, [this](double fraction, const QString& code) {
    writing_->show_fraction(fraction);
    writing_->say(code.isEmpty() ? tr("Exporting …") : tr("Exporting %1 …").arg(code));
    refresh();
  });
  const auto tell = [this](const QString& what) {
    remark_->setText(what);
    refresh();
  };
  connect(&work, &ExportWork::written, this, [tell](int trials, const QString& folder) {
    tell(tr("%n trial(s) written to <a href=\"%1\">%2</a>", "", trials)
             .arg(QUrl::fromLocalFile(folder).toString(), folder.toHtmlEscaped()));
  });
  connect(&work, &ExportWork::failed, this, [tell](const QString& why) {
    tell(tr("Nothing was written: %1").arg(why.toHtmlEscaped()));
  });
  connect(&work, &ExportWork::cancelled, this,
          [tell] { tell(tr("Cancelled: nothing was written.")); });
  refresh();
}

QWidget* ExportPanel::make_choices() {
  auto* card = new Card(tr("Research export"));
  whose_ = new ChoiceBox;
  whose_->setObjectName("export_whose");
  describe(*whose_, tr("Whose data"), tr("The chosen patient or all (Alt+W, then arrow keys)"));
  whose_->addItem(tr("The chosen patient"));
  whose_->addItem(tr("All patients"));
  span_ = new SessionSpan(tr("F&irst session"), tr("L&ast session"), "export");
  format_ = new ChoiceBox;
  format_->setObjectName("export_format");
  describe(*format_, tr("Format of the export"),
           tr("How signals and measures are written (Alt+N, then arrow keys)"));
  for (const auto& [format, words] :
       {std::pair{exports::ExportFormat::csv, tr("Tables: CSV and JSON")},
        {exports::ExportFormat::hdf5, tr("One file: HDF5")},
        {exports::ExportFormat::bids, tr("Data set: Motion-BIDS")},
        {exports::ExportFormat::fhir, tr("Health record: HL7 FHIR")}})
    format_->addItem(words, static_cast<int>(format));
  auto* privacy =
      new QLabel(tr("Codes only: no names, dates, notes or addresses of devices are written."));
  privacy->setProperty("role", "quiet");
  privacy->setWordWrap(true);
  export_ = new QPushButton(tr("&Export …"));
  export_->setObjectName("export");
  describe(*export_, tr("Export"),
           tr("Into a new folder; nothing is overwritten, not during a trial (Alt+E)"));
  writing_ = new WorkProgress("export", tr("Progress of the export"));
  writing_->cancel().setText(tr("&Cancel"));
  describe(writing_->cancel(), tr("Cancel the export"), tr("Nothing of it is kept (Alt+C)"));
  remark_ = new QLabel;
  remark_->setObjectName("export_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  remark_->setTextInteractionFlags(Qt::LinksAccessibleByMouse);
  auto& column = card->column();
  column.addWidget(label_for(*whose_, tr("&Whose data")));
  column.addWidget(whose_);
  column.addWidget(span_);
  column.addWidget(label_for(*format_, tr("Form of the &numbers")));
  column.addWidget(format_);
  column.addWidget(privacy);
  column.addSpacing(6);
  column.addWidget(export_);
  column.addWidget(writing_);
  column.addWidget(remark_);
  column.addStretch(1);
  connect(whose_, QOverload<int>::of(&QComboBox::activated), this, &ExportPanel::list_files);
  connect(span_, &SessionSpan::changed, this, &ExportPanel::list_files);
  connect(format_, QOverload<int>::of(&QComboBox::activated), this, &ExportPanel::list_files);
  connect(export_, &QPushButton::clicked, this, &ExportPanel::ask_where);
  connect(&writing_->cancel(), &QPushButton::clicked, &clinic_.research_export(),
          &ExportWork::cancel);
  connect(remark_, &QLabel::linkActivated, this,
          [](const QString& link) { QDesktopServices::openUrl(QUrl(link)); });
  return card;
}

QWidget* ExportPanel::make_list() {
  auto* card = new Card(tr("What will be written"));
  count_ = new QLabel;
  count_->setObjectName("export_count");
  count_->setProperty("role", "quiet");
  count_->setWordWrap(true);
  files_ = new QListWidget;
  files_->setObjectName("export_files");
  files_->setSelectionMode(QAbstractItemView::NoSelection);
  describe(*files_, tr("Files that will be written"), tr("Numbers only (Tab, arrow keys)"));
  take_rest(*files_, 120);
  card->column().addWidget(count_);
  card->column().addWidget(files_, 1);
  return card;
}

exports::ExportRequest ExportPanel::request() const {
  if (whose_->currentIndex() == 1) return {};
  return {presenter_.state().choices.patient, span_->first(), span_->last()};
}

exports::ExportFormat ExportPanel::format() const {
  return static_cast<exports::ExportFormat>(format_->currentData().toInt());
}

void ExportPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_ || code_ != presenter_.state().choices.patient) load_sessions();
}

void ExportPanel::look_again() {
  stale_ = true;
  if (isVisible()) load_sessions();
}

void ExportPanel::load_sessions() {
  const auto code = presenter_.state().choices.patient;
  const bool same = code == code_;
  if (!same) {
    span_->show_sessions({}, false);
    files_->clear();
  }
  code_ = code;
  stale_ = false;
  using Sessions = std::vector<storage::SessionRecord>;
  const bool asked = clinic_.read(
      this,
      [code](storage::SessionStore& store) -> Sessions {
        const auto patient = store.find_patient(code);
        if (!patient || !*patient) return {};
        auto sessions = store.sessions((*patient)->id);
        return sessions ? *std::move(sessions) : Sessions{};
      },
      [this, code, same](const Sessions& sessions) {
        if (code != code_) return;
        span_->show_sessions(sessions, same);
        list_files();
      });
  if (!asked) stale_ = true;
  refresh();
}

void ExportPanel::list_files() {
  files_->clear();
  problem_.clear();
  const auto wanted = request();
  if (whose_->currentIndex() == 0 && wanted.patient.empty()) return refresh();
  struct Listed {
    std::vector<std::string> files;
    std::size_t not_released = 0;
  };
  using Files = Result<Listed>;
  clinic_.read(
      this,
      [wanted, form = format()](storage::SessionStore& store) -> Files {
        auto files = exports::list_export(store, wanted, form);
        if (!files) return files.error();
        const auto not_released = exports::count_not_released(store, wanted);
        if (!not_released) return not_released.error();
        return Listed{*std::move(files), *not_released};
      },
      [this, number = ++lists_](const Files& files) {
        if (number != lists_) return;
        if (!files) {
          problem_ = translated(files.error());
          return refresh();
        }
        int listed = 0;
        for (const auto& file : files->files)
          if (++listed <= kMostListed) files_->addItem(QString::fromStdString(file));
        count_->setProperty("files", static_cast<int>(files->files.size()));
        count_->setProperty("not_released", static_cast<int>(files->not_released));
        refresh();
      });
  refresh();
}

void ExportPanel::ask_where() {
  auto* dialog =
      new QFileDialog(this, tr("A folder for the export"), proposed_folder(clinic_.database()));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this, &ExportPanel::write_into);
  dialog->open();
}

void ExportPanel::write_into(const QString& folder) {
  remark_->clear();
  clinic_.research_export().start(request(), format(), free_export_folder(folder.toStdString()));
  refresh();
}

void ExportPanel::refresh() {
  const bool one = whose_->currentIndex() == 0;
  const bool any = files_->count() > 0;
  span_->setVisible(one);
  const int files = any ? count_->property("files").toInt() : 0;
  count_->setText(one && presenter_.state().choices.patient.empty()
                      ? tr("Choose a patient on the start page, or all.")
                  : !problem_.isEmpty() ? problem_
                  : any                 ? tr("%n file(s), below a new folder:", "", files)
                                        : tr("Nothing is stored yet."));
  const int not_released = one ? 0 : count_->property("not_released").toInt();
  if (not_released > 0 && problem_.isEmpty())
    count_->setText(count_->text() + " " +
                    tr("%n patient(s) left out: not released for research.", "", not_released));
  // Reading whole trials and writing them disturbs the disk: a trial has it for itself.
  ExportWork& work = clinic_.research_export();
  const bool waits = presenter_.flow().view().may_stop;
  work.hold(waits);
  export_->setEnabled(any && !work.running() && !waits);
  writing_->setVisible(work.running());
  if (work.running() && waits) writing_->say(tr("Waits for the end of the trial"));
  remark_->setVisible(!remark_->text().isEmpty() && !work.running());
}

}  // namespace isograsp::gui

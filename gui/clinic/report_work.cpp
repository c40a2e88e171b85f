// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/report_work.hpp"

#include "core/files.hpp"
#include "gui/clinic/save_folder.hpp"
#include "gui/words/language.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {
constexpr double kGathered = 0.4;  // share of the time, roughly
}

ReportWork::ReportWork(std::shared_ptr<std::unique_ptr<storage::SessionStore>> store,
                       Background& worker)
    : store_(std::move(store)), worker_(worker) {
  between_events_.setInterval(0);
  connect(&between_events_, &QTimer::timeout, this, &ReportWork::paint_next);
}

ReportWork::~ReportWork() {
  stop_.request_stop();
}

void ReportWork::start(const std::string& code, const std::string& path,
                       const reports::ReportScope& scope) {
  if (running()) return;
  stage_ = Stage::gathering;
  code_ = code;
  path_ = path;
  stop_ = {};
  const auto stop = stop_.get_token();
  // Called on the worker: what it says is passed on to this thread.
  const auto watch = [this, stop](double fraction, const Text& words) {
    QMetaObject::invokeMethod(
        this,
        [this, stop, fraction, words] {
          if (!stop.stop_requested()) Q_EMIT progress(kGathered * fraction, translated(words));
        },
        Qt::QueuedConnection);
    return !stop.stop_requested();
  };
  using Gathered = Result<reports::ReportContent>;
  worker_.run(
      [store = store_, code, path, watch, scope]() -> Gathered {
        if (auto folder = check_folder_of(path); !folder) return folder.error();
        return reports::gather_progress(**store, code, watch, scope);
      },
      [this, stop](Gathered content) {
        if (stop.stop_requested()) return;
        if (!content) {
          end();
          Q_EMIT failed(translated(content.error()));
          return;
        }
        stage_ = Stage::painting;
        writer_ =
            reports::make_report_writer(*std::move(content), path_, languages::language(spoken()));
        if (!held_) between_events_.start();
      });
  Q_EMIT progress(0.0, tr("reading"));
}

void ReportWork::paint_next() {
  if (writer_->complete()) return save();
  const double painted = static_cast<double>(writer_->steps_done()) / writer_->steps();
  Q_EMIT progress(kGathered + (1.0 - kGathered) * painted, translated(writer_->words()));
  // Whoever listens may have cancelled.
  if (writer_ != nullptr) writer_->paint_next();
}

void ReportWork::save() {
  stage_ = Stage::saving;
  between_events_.stop();
  Q_EMIT progress(1.0, tr("saving"));
  worker_.run([file = writer_->take(), path = path_] { return write_text(path, file); },
              [this, path = path_](const Result<void>& saved) {
                end();
                if (saved)
                  Q_EMIT written(QString::fromStdString(path));
                else
                  Q_EMIT failed(translated(saved.error()));
              });
}

void ReportWork::cancel() {
  if (!may_cancel()) return;
  stop_.request_stop();
  end();
  Q_EMIT cancelled();
}

void ReportWork::hold(bool wait) {
  held_ = wait;
  if (stage_ != Stage::painting) return;
  if (held_)
    between_events_.stop();
  else
    between_events_.start();
}

void ReportWork::end() {
  stage_ = Stage::idle;
  between_events_.stop();
  writer_.reset();
}

}  // namespace isograsp::gui

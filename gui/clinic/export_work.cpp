// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/export_work.hpp"

#include <filesystem>

#include "gui/words/language.hpp"
#include "gui/words/texts.hpp"
#include "languages/languages.hpp"
#include "storage/access/open_store.hpp"

namespace isograsp::gui {

ExportWork::ExportWork(std::string database) : database_(std::move(database)) {}

ExportWork::~ExportWork() {
  cancel();
  hold(false);
}

void ExportWork::start(const exports::ExportRequest& request, exports::ExportFormat format,
                       const std::string& folder) {
  if (running_) return;
  running_ = true;
  patient_ = request.patient;
  stop_ = {};
  const auto stop = stop_.get_token();
  // Called on the worker: what it says is passed on to this thread.
  const auto watch = [this, stop](double fraction, const Text& code) {
    QMetaObject::invokeMethod(
        this,
        [this, stop, fraction, code] {
          if (!stop.stop_requested()) Q_EMIT progress(fraction, translated(code));
        },
        Qt::QueuedConnection);
    if (!stop.stop_requested()) held_.wait(true);
    return !stop.stop_requested();
  };
  using Written = Result<std::size_t>;
  worker_.run(
      [database = database_, request, format, folder, watch,
       language = &languages::language(spoken())]() -> Written {
        const auto store = storage::open_store(database, storage::OpenMode::read_only);
        if (!store) return store.error();
        return exports::write_export(**store, request, format, folder, watch, *language);
      },
      [this, stop, folder](const Written& written) {
        running_ = false;
        if (written)
          Q_EMIT this->written(static_cast<int>(*written), QString::fromStdString(folder));
        else if (stop.stop_requested())
          Q_EMIT cancelled();
        else
          Q_EMIT failed(translated(written.error()));
      });
  Q_EMIT progress(0.0, "");
}

void ExportWork::cancel() {
  if (!running_) return;
  stop_.request_stop();
  hold(false);
}

void ExportWork::hold(bool wait) {
  held_ = wait && !stop_.stop_requested();
  held_.notify_all();
}

std::string free_export_folder(const std::string& in) {
  namespace fs = std::filesystem;
  fs::path folder = fs::path(in) / "isograsp-export";
  std::error_code ignored;
  for (int n = 2; fs::exists(folder, ignored); ++n)
    folder = fs::path(in) / ("isograsp-export-" + std::to_string(n));
  return folder;
}

}  // namespace isograsp::gui

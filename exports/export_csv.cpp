// SPDX-License-Identifier: GPL-3.0-or-later
// A table for each trial, with a JSON sidecar that says what everything in it is.
#include <cmath>
#include <limits>

#include "core/csv.hpp"
#include "exports/export_writer.hpp"

namespace isograsp::exports {

namespace {

namespace fs = std::filesystem;

/// CSV has no infinity: such values are left empty and counted.
std::pair<Signals, std::int64_t> without_infinity(const Signals& signals) {
  Signals finite;
  std::int64_t count = 0;
  for (std::size_t c = 0; c < signals.names().size(); ++c) {
    const auto column = signals.column(c);
    std::vector<double> values(column.begin(), column.end());
    for (double& value : values)
      if (std::isinf(value)) {
        value = std::numeric_limits<double>::quiet_NaN();
        ++count;
      }
    finite.add_column(signals.names()[c], std::move(values));
  }
  return {std::move(finite), count};
}

std::string file_stem(const ExportPlace& place) {
  return "patient_" + std::to_string(place.patient) + "/session_" + std::to_string(place.session) +
         "/trial_" + std::to_string(place.trial);
}

class CsvExport final : public ExportWriter {
 public:
  CsvExport(fs::path folder, const Language& language)
      : folder_(std::move(folder)), language_(language) {}

  std::vector<std::string> files_of(const ExportPlace& place) const override {
    const std::string stem = file_stem(place);
    std::vector<std::string> files{stem + "_signals.csv", stem + ".json", stem + "_task.toml"};
    if (place.has_scene) files.push_back(stem + "_scene.toml");
    return files;
  }

  Result<void> write(const ExportTrial& trial) override {
    const std::string stem = (folder_ / file_stem(trial.place)).string();
    const auto [signals, infinite] = without_infinity(trial.signals);
    if (const auto done = write_below(stem + ".json", trial_as_json(trial, infinite, language_));
        !done)
      return done;
    if (const auto done = write_signals(signals, stem + "_signals.csv"); !done) return done;
    if (const auto done = write_text(stem + "_task.toml", trial.trial.task_text); !done)
      return done;
    if (!trial.place.has_scene) return {};
    return write_text(stem + "_scene.toml", trial.trial.scene_text);
  }

  Result<void> finish() override { return {}; }

 private:
  fs::path folder_;
  const Language& language_;
};

}  // namespace

std::unique_ptr<ExportWriter> make_csv_writer(fs::path folder, const Language& language) {
  return std::make_unique<CsvExport>(std::move(folder), language);
}

}  // namespace isograsp::exports

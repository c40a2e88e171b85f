// SPDX-License-Identifier: GPL-3.0-or-later
// One HDF5 file for a whole export: /patients/CODE/session-NN/trial-NN.
#include <cstdio>
#include <utility>

#include "core/column.hpp"
#include "exports/export_writer.hpp"
#include "exports/hdf5_file.hpp"
#include "tasks/facts/column_facts.hpp"

namespace isograsp::exports {

namespace {

namespace fs = std::filesystem;
constexpr const char* kFile = "isograsp.h5";

/// "session-07": in the order of the alphabet up to 99.
std::string numbered(const char* word, int number) {
  char text[32];
  std::snprintf(text, sizeof text, "%s-%02d", word, number);
  return text;
}

void write_signals(Hdf5Node& group, const ExportTrial& trial, const Language& language) {
  std::size_t next = 0;
  for (const auto& stored : trial.trial.groups) {
    std::vector<std::span<const double>> columns;
    std::vector<std::string> units;
    std::vector<std::string> axes;
    std::vector<std::string> descriptions;
    for (const auto& name : stored.columns) {
      columns.push_back(trial.signals.column(next++));
      const auto facts = tasks::describe_column(name, stored.name);
      units.push_back(facts.unit);
      axes.push_back(facts.axes);
      descriptions.push_back(translated(facts.description, language));
    }
    auto data = group.write_columns(stored.name, columns);
    data.set("columns", stored.columns);
    data.set("units", units);
    data.set("axes", axes);
    data.set("descriptions", descriptions);
  }
}

/// Three rows, thumb index middle, of Fx Fy Fz Tx Ty Tz.
void write_wrenches(Hdf5Node& group, const std::string& name,
                    const std::array<Vec6, kFingerCount>& wrenches) {
  std::vector<std::vector<double>> values(6);
  for (Eigen::Index axis = 0; axis < 6; ++axis)
    for (const auto& wrench : wrenches)
      values[static_cast<std::size_t>(axis)].push_back(wrench[axis]);
  const std::vector<std::span<const double>> columns(values.begin(), values.end());
  auto data = group.write_columns(name, columns);
  data.set("rows", {kFingerNames.begin(), kFingerNames.end()});
  data.set("columns", {"fx", "fy", "fz", "tx", "ty", "tz"});
  data.set("units", {"N", "N", "N", "N m", "N m", "N m"});
}

void write_zero_and_rest(Hdf5Node& group, const ExportTrial& trial) {
  if (const auto& zero = trial.zero) {
    auto node = group.make_group("instrument_zero");
    node.set("session_time_s", zero->session_time_s);
    const auto mean = platform::two_six_axes_of(zero->columns, zero->mean);
    const auto sd = platform::two_six_axes_of(zero->columns, zero->sd);
    if (mean && sd) {
      for (const Hand hand : kBothHands) {
        auto side = node.make_group(std::string(name_of(hand)));
        write_wrenches(side, "mean", (*mean)[hand]);
        write_wrenches(side, "sd", (*sd)[hand]);
      }
    } else {
      write_wrenches(node, "mean", wrenches_of(*zero, zero->mean));
      write_wrenches(node, "sd", wrenches_of(*zero, zero->sd));
    }
  }
  if (const auto& rest = trial.rest) {
    auto node = group.make_group("resting_force");
    node.set("duration_s",
             storage::value_of(rest->references, platform::kDuration_s).value_or(0.0));
    if (const auto since_s = storage::value_of(rest->references, platform::kSinceStrapping_s))
      node.set("since_strapping_s", *since_s);
    node.set("samples", rest->samples.value_or(0));
    write_wrenches(node, "mean", wrenches_of(*rest, rest->mean));
    write_wrenches(node, "sd", wrenches_of(*rest, rest->sd));
  }
}

class Hdf5Export final : public ExportWriter {
 public:
  Hdf5Export(fs::path folder, const Language& language)
      : folder_(std::move(folder)), language_(language) {}

  std::vector<std::string> files_of(const ExportPlace&) const override { return {kFile}; }

  Result<void> write(const ExportTrial& trial) override {
    return guarded([&] { add(trial); });
  }

  Result<void> finish() override {
    return guarded([&] {
      session_ = {};
      patient_ = {};
      patients_ = {};
      if (file_.open()) file_.close_file();
    });
  }

 private:
  template <class Work>
  Result<void> guarded(Work&& work) {
    try {
      if (const auto made = make_folder(folder_); !made) return made;
      work();
      return {};
    } catch (const Hdf5Error& why) {
      return failed(Known{why.what()}, "check the disk"_text).at(folder_ / kFile);
    }
  }

  void add(const ExportTrial& trial) {
    if (!file_.open()) begin();
    const ExportPlace& place = trial.place;
    if (place.patient != patient_number_) {
      session_ = {};
      session_number_ = 0;
      patient_ = patients_.make_group(trial.patient_code);
      patient_.set(patient_facts(trial));
      patient_number_ = place.patient;
    }
    if (place.session != session_number_) {
      session_ = patient_.make_group(numbered("session", place.session));
      session_.set(session_facts(trial));
      session_number_ = place.session;
    }
    if (place.tracked && !std::exchange(cameras_explained_, true)) explain_axes(true);
    auto group = session_.make_group(numbered("trial", place.trial));
    group.set(trial_facts(trial));
    auto signals = group.make_group("signals");
    write_signals(signals, trial, language_);
    group.write_measures("measures", trial.measures);
    group.write_events("events", trial.events);
    write_zero_and_rest(group, trial);
    group.write_text("task", trial.trial.task_text);
    if (place.has_scene) group.write_text("scene", trial.trial.scene_text);
    group.write_text("health", trial.trial.health_json);
    group.write_text("timing", trial.trial.timing_json);
  }

  /// In the head of the file; those of cameras with the first trial that has them.
  void explain_axes(bool of_cameras) {
    for (const auto& [axes, description] : kColumnAxes)
      if (are_of_cameras(axes) == of_cameras)
        file_.set("axes_" + std::string(axes), translated(description, language_));
  }

  void begin() {
    file_ = Hdf5Node::create_file(folder_ / kFile);
    file_.set("format", std::string("isograsp-hdf5-1"));
    file_.set("written_by", std::string("IsoGrasp " ISOGRASP_VERSION));
    explain_axes(false);
    patients_ = file_.make_group("patients");
  }

  fs::path folder_;
  const Language& language_;
  // Closed from the last to the first.
  Hdf5Node file_;
  Hdf5Node patients_;
  Hdf5Node patient_;
  Hdf5Node session_;
  int patient_number_ = 0;
  int session_number_ = 0;
  bool cameras_explained_ = false;
};

}  // namespace

std::unique_ptr<ExportWriter> make_hdf5_writer(fs::path folder, const Language& language) {
  return std::make_unique<Hdf5Export>(std::move(folder), language);
}

}  // namespace isograsp::exports

// SPDX-License-Identifier: GPL-3.0-or-later
// A second apparatus, as small as can be: one handle with one scalar sensor, played from a file
// (columns t_s and force_N, one line a frame; an empty force: the handle is out of sight). Nothing
// of the platform is in it. Its tasks: free handling without an object; what they measure: the peak
// force. "?live=1": it is simulated, not recorded; "?zero=1": it asks for a zero, which is
// subtracted.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/latest.hpp"
#include "hand/columns.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/open_apparatus.hpp"

namespace isograsp::test {

class Dynamometer final : public session::Apparatus {
 public:
  static constexpr std::string_view kKind = "dynamometer";
  static constexpr double kPeriod_s = 0.01;

  /// What it shows: whoever knows it reads it beside the moment.
  struct Shown : session::Moment {
    double force_N = 0.0;
  };

  explicit Dynamometer(std::vector<double> force_N, bool live = false, bool asks_zero = false)
      : force_N_(std::move(force_N)), asks_zero_(asks_zero) {
    info_.kind = kKind;
    info_.description = "A handle, recorded"_text;
    info_.recorded = !live;
    info_.simulated = live;
    info_.period_s = kPeriod_s;
    info_.provenance = {"a recorded handle"};
  }
  static Result<std::unique_ptr<Apparatus>> open(const session::ApparatusRequest& request) {
    const auto text = read_text(request.uri.target);
    if (!text) return text.error();
    std::vector<double> force_N;
    bool head = true;
    for (std::size_t at = 0; at < text->size();) {
      const auto end = std::min(text->find('\n', at), text->size());
      const std::string line = text->substr(at, end - at);
      at = end + 1;
      if (std::exchange(head, false)) continue;
      const std::string value = line.substr(line.find(',') + 1);
      force_N.push_back(value.empty() ? std::nan("") : std::stod(value));
    }
    return std::unique_ptr<Apparatus>(
        std::make_unique<Dynamometer>(std::move(force_N), request.uri.parameters.contains("live"),
                                      request.uri.parameters.contains("zero")));
  }

  [[nodiscard]] const session::ApparatusInfo& info() const noexcept override { return info_; }
  [[nodiscard]] std::span<const session::PreparationStep> steps() const noexcept override {
    static constexpr std::array kSteps{session::PreparationStep::zero};
    return asks_zero_ ? std::span<const session::PreparationStep>(kSteps)
                      : std::span<const session::PreparationStep>();
  }
  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    return {};
  }
  void stop() noexcept override {}
  void describe(storage::SessionRecord& session) const override { session.calibration = ""; }
  [[nodiscard]] Result<void> ready() override { return {}; }
  [[nodiscard]] Result<std::unique_ptr<session::Preparation>> make_preparation(
      const session::ZeroRequest&) override {
    if (!asks_zero_) return refused("a handle has no zero"_text, "leave the step out"_text);
    return std::unique_ptr<session::Preparation>(std::make_unique<Still>());
  }
  [[nodiscard]] Result<std::unique_ptr<session::TrialSetup>> make_trial(
      const tasks::TaskSpec& spec, const tasks::TaskContext& context) override {
    auto task = tasks::make_task(spec, context);
    if (!task) return task.error();
    auto trial = std::make_unique<Trial>();
    trial->spec = spec;
    trial->task = *std::move(task);
    trial->record.task_name = spec.name;
    trial->record.task_version = spec.version;
    trial->record.task_text = spec.text;
    trial->record.seed = context.seed;
    return std::unique_ptr<session::TrialSetup>(std::move(trial));
  }
  [[nodiscard]] const session::Moment& newest() noexcept override { return shown_.read(); }

  [[nodiscard]] bool next() noexcept override {
    if (frame_ == force_N_.size()) return false;
    now_.session_time_s = static_cast<double>(frame_) * kPeriod_s;
    clock_->wait_until(start_ + from_seconds(now_.session_time_s));
    now_.force_N = force_N_[frame_++] - zero_N_;
    return true;
  }
  [[nodiscard]] bool measure(session::Preparation& preparation) noexcept override {
    auto& still = static_cast<Still&>(preparation);
    if (std::isnan(now_.force_N)) return false;
    still.sum_N += now_.force_N;
    if (++still.frames < Still::kFrames) return false;
    zero_N_ += still.mean_N();
    now_.zeroed = true;
    return true;
  }
  [[nodiscard]] session::Reception receive() noexcept override {
    const bool seen = !std::isnan(now_.force_N);
    return {!seen, seen ? session::Reception::Sight::clear : session::Reception::Sight::occluded};
  }
  void step() noexcept override { now_.task = trial_->task->step({}); }
  void write(const session::RowFrame& frame, session::TrialRow& row) noexcept override {
    put_all(session::ColumnValues{row}, frame, now_.force_N);
  }
  void move() noexcept override {}
  void publish() noexcept override { shown_.publish(now_); }
  void show() noexcept override {}

  void begin(session::Preparation&) noexcept override {}
  void begin(session::TrialSetup& trial) noexcept override { trial_ = &trial; }
  void end(session::TrialSetup&) noexcept override { trial_ = nullptr; }

  [[nodiscard]] session::Moment& now() noexcept override { return now_; }
  [[nodiscard]] session::ApparatusFault fault() const noexcept override { return {}; }
  [[nodiscard]] double lateness_s() const noexcept override {
    return to_seconds(clock_->now() - start_) - now_.session_time_s;
  }
  [[nodiscard]] std::optional<double> latency_s() const noexcept override { return std::nullopt; }

 private:
  /// The mean force of some frames in which nobody holds the handle.
  struct Still final : session::Preparation {
    static constexpr int kFrames = 20;
    [[nodiscard]] double mean_N() const { return sum_N / frames; }
    [[nodiscard]] session::PreparationOutcome outcome() const override {
      session::PreparationOutcome outcome;
      outcome.name = "still handle";
      outcome.accepted = true;
      outcome.record.kind = "still_handle";
      outcome.record.samples = frames;
      outcome.record.columns = {"force_N"};
      outcome.record.mean = {mean_N()};
      outcome.record.sd = {0.0};
      return outcome;
    }
    double sum_N = 0.0;
    int frames = 0;
  };
  struct Trial final : session::TrialSetup {
    [[nodiscard]] std::vector<storage::SignalGroup> columns() const override {
      std::vector<storage::SignalGroup> groups;
      put_all(session::ColumnNames{groups}, {}, 0.0);
      return groups;
    }
    [[nodiscard]] std::string health_json() const override { return "{}"; }
  };
  template <class Sink>
  static void put_all(Sink sink, const session::RowFrame& frame, double force_N) {
    put_progress(sink, frame);
    sink.put(columns::actual_force_N, force_N);
    put_timing(sink, frame);
  }

  std::vector<double> force_N_;
  bool asks_zero_;
  double zero_N_ = 0.0;
  session::ApparatusInfo info_;
  Clock* clock_ = nullptr;
  Timestamp start_{0};
  std::size_t frame_ = 0;
  session::TrialSetup* trial_ = nullptr;
  Shown now_;
  Latest<Shown> shown_;
};

/// The table of a program that knows it: handle:// beside all others.
inline const std::vector<session::ApparatusRow>& apparatuses_with_handle() {
  static const std::vector<session::ApparatusRow> kRows = [] {
    std::vector<session::ApparatusRow> rows{{"handle", "", "", Dynamometer::open}};
    for (const auto& row : session::all_apparatuses()) rows.push_back(row);
    return rows;
  }();
  return kRows;
}

}  // namespace isograsp::test

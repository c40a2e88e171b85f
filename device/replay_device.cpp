// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/replay_device.hpp"

#include <algorithm>
#include <vector>

#include "core/finger_forces.hpp"

namespace isograsp {

namespace {

constexpr double kFallbackFramePeriod_s = 0.01;
constexpr double kShortestFramePeriod_s = 0.001;
constexpr double kLongestFramePeriod_s = 0.02;
constexpr double kRounding = 1e-9;  ///< relative: 1.01 s - 1.00 s is not exactly 10 ms

struct Recording {
  std::vector<FingerForcesRow> rows;
  std::vector<Timestamp> stamps;  ///< since the start
};

class ReplayDevice final : public ForceDevice {
 public:
  ReplayDevice(DeviceInfo info, Recording recording, double speed)
      : info_(std::move(info)), recording_(std::move(recording)), speed_(speed) {
    health_.state = DeviceState::configured;
  }

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] DeviceHealth health() const noexcept override { return health_; }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    reached_ = start_;
    row_ = 0;
    next_finger_ = 0;
    health_ = DeviceHealth{};
    health_.state = DeviceState::streaming;
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    if (row_ == recording_.rows.size()) {
      health_.state = DeviceState::finished;
      return ReadStatus::finished;
    }
    const Timestamp stamp = start_ + recording_.stamps[row_];
    wait_until(std::min(stamp, deadline));
    if (stamp > deadline) return ReadStatus::timeout;

    const FingerForcesRow& row = recording_.rows[row_];
    const std::size_t f = next_finger_;
    out = SensorSample{};
    out.finger = kFingers[f];
    out.stamp = stamp;
    out.wrench_C = row.wrench_C[f];
    out.valid = row.present[f];
    ++(out.valid ? health_.sensors[f].good : health_.sensors[f].invalid);
    next_finger_ = (next_finger_ + 1) % kFingerCount;
    if (next_finger_ == 0) ++row_;
    return ReadStatus::sample;
  }

  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    if (speed_ == 0.0) return reached_;
    return start_ + scaled(clock.now() - start_, speed_);
  }

  void stop() noexcept override {
    clock_ = nullptr;
    health_.state = DeviceState::configured;
  }

 private:
  /// Exact at speed 1.
  [[nodiscard]] static Timestamp scaled(Timestamp span, double factor) noexcept {
    if (factor == 1.0) return span;
    return Timestamp{std::llround(static_cast<double>(span.count()) * factor)};
  }

  /// Waits for recorded time `t`.
  void wait_until(Timestamp t) noexcept {
    reached_ = std::max(reached_, t);
    if (speed_ > 0.0) clock_->wait_until(start_ + scaled(t - start_, 1.0 / speed_));
  }

  DeviceInfo info_;
  Recording recording_;
  double speed_;
  DeviceHealth health_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  Timestamp reached_{0};  ///< recorded time that was waited for
  std::size_t row_ = 0;
  std::size_t next_finger_ = 0;
};

/// Whether the grid of the file can be the grid of the frames.
bool fits_frames(const TimeGrid& grid) noexcept {
  return grid.regular && grid.hold_s >= kShortestFramePeriod_s * (1.0 - kRounding) &&
         grid.hold_s <= kLongestFramePeriod_s * (1.0 + kRounding);
}

double median_step_s(const std::vector<FingerForcesRow>& rows) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < rows.size(); ++k) steps.push_back(rows[k].t_s - rows[k - 1].t_s);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

Result<std::unique_ptr<ForceDevice>> open_replay_device(const Uri& uri) {
  if (auto known = uri.require_known({"speed"}); !known) return known.error();
  if (uri.target.empty()) return uri.error("file", "no file is named", "write replay://FILE.csv");
  auto speed = uri.number_or("speed", 1.0, 0.0, 1000.0);
  if (!speed) return speed.error();
  if (*speed > 0.0 && *speed < 0.01)
    return uri.error("speed", "is too slow", "give 0 (never wait) or 0.01 to 1000");
  const auto grid = read_time_grid(uri.target);
  if (!grid) return grid.error();
  auto reader = FingerForcesReader::open(uri.target);
  if (!reader) return reader.error();
  if (std::none_of(kFingers.begin(), kFingers.end(),
                   [&](Finger finger) { return reader->has(finger); }))
    return Error{Error::Code::bad_input,
                 "holds no finger's forces",
                 "add columns such as thumb_fx_N, thumb_fy_N, thumb_fz_N",
                 uri.target,
                 0,
                 ""};

  const bool on_grid = fits_frames(*grid);
  Recording recording;
  FingerForcesRow row;
  for (;;) {
    const auto more = reader->next(row);
    if (!more) return more.error();
    if (!*more) break;
    recording.rows.push_back(row);
    const auto k = static_cast<double>(recording.stamps.size());
    recording.stamps.push_back(
        from_seconds(on_grid ? k * grid->hold_s : row.t_s - recording.rows.front().t_s));
  }

  DeviceInfo info;
  info.uri = uri.text;
  info.description = "Recorded forces, " + uri.target;
  info.recorded = true;
  info.on_grid = on_grid;
  info.sample_period_s = on_grid ? grid->hold_s : median_step_s(recording.rows);
  info.frame_period_s = on_grid ? grid->hold_s : kFallbackFramePeriod_s;
  info.units_per_count.fill(Vec6::Zero());
  info.range.fill(Vec6::Zero());
  info.provenance = reader->comments();
  info.simulated =
      std::any_of(info.provenance.begin(), info.provenance.end(),
                  [](const std::string& line) { return line.starts_with("simulated"); });
  return std::unique_ptr<ForceDevice>(
      std::make_unique<ReplayDevice>(std::move(info), std::move(recording), *speed));
}

}  // namespace isograsp

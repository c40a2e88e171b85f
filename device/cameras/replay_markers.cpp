// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "device/cameras/marker_schemes.hpp"
#include "device/cameras/picture_watch.hpp"
#include "device/markers/marker_period.hpp"
#include "device/markers/marker_reader.hpp"
#include "device/sensors/replay_clock.hpp"

namespace isograsp {

namespace {

/// All rows of a file.
struct MarkerRecording {
  MarkerDeviceInfo info;
  std::vector<double> t_s;           ///< since the first row
  std::vector<std::int64_t> number;  ///< place in the grid
  std::vector<Vec3> p_W;             ///< row by row
};

Result<MarkerRecording> read_recording(const std::string& path) {
  constexpr std::size_t kMostPositions = 50'000'000;  // 1.2 GB
  auto reader = open_markers(path);
  if (!reader) return reader.error();
  MarkerRecording recording;
  MarkerDeviceInfo& info = recording.info;
  info.labels = (*reader)->markers();
  const std::size_t markers = info.labels.size();
  double t_s = 0.0;
  for (;;) {
    const std::size_t end = recording.p_W.size();
    if (end + markers > kMostPositions)
      return refused("holds more rows than can be replayed"_text, "cut it into parts"_text)
          .at(path);
    recording.p_W.resize(end + markers);
    const auto more = (*reader)->next(t_s, std::span(recording.p_W).subspan(end));
    if (!more) return more.error();
    if (!*more) break;
    recording.t_s.push_back(t_s);
  }
  if (recording.t_s.size() < 2)
    return refused("holds fewer than two rows"_text, "record some seconds"_text).at(path);
  const double first_s = recording.t_s.front();
  for (double& time_s : recording.t_s) time_s -= first_s;
  info.period_s = period_of(recording.t_s);
  for (const double time_s : recording.t_s) {
    const auto place = std::llround(time_s / info.period_s);
    recording.number.push_back(recording.number.empty()
                                   ? place
                                   : std::max<std::int64_t>(place, recording.number.back() + 1));
  }
  info.description = "Recorded markers, %1"_text(path);
  info.recorded = true;
  info.simulated = (*reader)->simulated();
  info.provenance = {"recorded markers"};
  return recording;
}

class MarkerReplay final : public MarkerDevice {
 public:
  MarkerReplay(MarkerRecording recording, double speed)
      : recording_(std::move(recording)), clock_(speed) {}

  [[nodiscard]] const MarkerDeviceInfo& info() const noexcept override { return recording_.info; }
  [[nodiscard]] MarkerHealth health() const noexcept override {
    MarkerHealth health;
    health.counters = counters_;
    health.state = finished_ ? DeviceState::finished : DeviceState::configured;
    if (clock_.runs() && !finished_) PictureWatch::set(health, watch_.fault(clock_.now()));
    return health;
  }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_.start(clock);
    next_ = 0;
    finished_ = false;
    counters_ = {};
    watch_.begin(clock_.at(Timestamp{0}), recording_.info.period_s);
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, MarkerSample& out) noexcept override {
    if (!clock_.runs()) return ReadStatus::finished;
    if (next_ == recording_.number.size()) {
      finished_ = true;
      return ReadStatus::finished;
    }
    const Timestamp stamp = clock_.at(from_seconds(recording_.t_s[next_]));
    if (!clock_.wait_for(stamp, deadline)) return ReadStatus::timeout;
    const std::size_t markers = recording_.info.labels.size();
    out.stamp = stamp;
    out.number = recording_.number[next_];
    out.p_W = std::span(recording_.p_W).subspan(next_ * markers, markers);
    const auto lost =
        next_ == 0 ? 0 : static_cast<std::uint64_t>(out.number - recording_.number[next_ - 1] - 1);
    ++counters_.good;
    counters_.lost += lost;
    watch_.picture(stamp, lost);
    ++next_;
    return ReadStatus::sample;
  }

  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    return clock_.now(clock);
  }

  void stop() noexcept override { clock_.stop(); }

 private:
  MarkerRecording recording_;
  ReplayClock clock_;
  PictureWatch watch_;
  MarkerCounters counters_;
  std::size_t next_ = 0;  ///< row
  bool finished_ = false;
};

}  // namespace

Result<std::unique_ptr<MarkerDevice>> open_marker_replay(const Uri& uri, MarkerSource*) {
  if (auto known = uri.require_known({"rig", "speed"}); !known) return known.error();
  const auto speed = replay_speed(uri);
  if (!speed) return speed.error();
  auto recording = read_recording(uri.target);
  if (!recording) return recording.error();
  recording->info.uri = uri.text;
  return std::unique_ptr<MarkerDevice>(
      std::make_unique<MarkerReplay>(*std::move(recording), *speed));
}

}  // namespace isograsp

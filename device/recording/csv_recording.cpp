// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "device/recording/recording.hpp"
#include "hand/finger_forces.hpp"

namespace isograsp {

namespace {

constexpr double kFallbackFramePeriod_s = 0.01;
constexpr double kShortestFramePeriod_s = 0.001;
constexpr double kLongestFramePeriod_s = 0.02;
constexpr double kRounding = 1e-9;  ///< relative: 1.01 s - 1.00 s is not exactly 10 ms

/// Whether the grid of the file can be the grid of the frames.
bool fits_frames(const TimeGrid& grid) noexcept {
  return grid.regular && grid.hold_s >= kShortestFramePeriod_s * (1.0 - kRounding) &&
         grid.hold_s <= kLongestFramePeriod_s * (1.0 + kRounding);
}

double median_step_s(const std::vector<double>& t_s) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < t_s.size(); ++k) steps.push_back(t_s[k] - t_s[k - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

Result<Recording> read_csv_recording(const std::string& path) {
  const auto grid = read_time_grid(path);
  if (!grid) return grid.error();
  auto reader = FingerForcesReader::open(path);
  if (!reader) return reader.error();
  if (std::none_of(kFingers.begin(), kFingers.end(),
                   [&](Finger finger) { return reader->has(finger); }))
    return refused("holds no finger's forces"_text,
                   "add columns such as thumb_fx_N, thumb_fy_N, thumb_fz_N"_text)
        .at(path);

  const bool on_grid = fits_frames(*grid);
  Recording recording;
  std::vector<double> t_s;
  FingerForcesRow row;
  for (;;) {
    const auto more = reader->next(row);
    if (!more) return more.error();
    if (!*more) break;
    const auto k = static_cast<double>(t_s.size());
    t_s.push_back(row.t_s);
    SensorSample sample;
    sample.stamp = from_seconds(on_grid ? k * grid->hold_s : row.t_s - t_s.front());
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      sample.finger = kFingers[f];
      sample.wrench_C = row.wrench_C[f];
      sample.valid = row.present[f];
      recording.samples.push_back(sample);
    }
  }

  DeviceInfo& info = recording.info;
  info.description = "Recorded forces, %1"_text(path);
  info.on_grid = on_grid;
  info.sample_period_s = on_grid ? grid->hold_s : median_step_s(t_s);
  info.frame_period_s = on_grid ? grid->hold_s : kFallbackFramePeriod_s;
  info.provenance = reader->comments();
  info.simulated =
      std::any_of(info.provenance.begin(), info.provenance.end(),
                  [](const std::string& line) { return line.starts_with("simulated"); });
  return recording;
}

}  // namespace isograsp

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "device/config/family_facts.hpp"
#include "device/recording/log_samples.hpp"
#include "device/recording/recording.hpp"

namespace isograsp {

Result<Recording> read_log_recording(const std::string& path, const DeviceConfig& config,
                                     bool addresses_known) {
  Recording recording;
  const auto take = [&](const std::string&, Timestamp wall_time, const DecodedSample& decoded) {
    const SensorConfig& sensor = config.sensors[decoded.finger];
    SensorSample sample;
    sample.finger = kFingers[decoded.finger];
    sample.stamp = wall_time;
    sample.raw_counts = decoded.raw_counts;
    sample.valid = decoded.valid;
    if (decoded.saturated) sample.flags |= bit(SampleFlag::saturated);
    if (decoded.overload) sample.flags |= bit(SampleFlag::overload);
    if (decoded.valid)
      sample.wrench_C = sensor.mounting.to_contact(sensor.corrected(decoded.wrench_S));
    recording.samples.push_back(sample);
  };
  const auto read = read_log(path, config, addresses_known, take);
  if (!read) return read.error();
  if (recording.samples.empty())
    return refused("holds no sample of these sensors"_text,
                   "check protocol and addresses of the device file"_text)
        .at(path);
  // A log may hold a record that came late: the order of the times is the order of the play.
  auto& samples = recording.samples;
  std::stable_sort(samples.begin(), samples.end(),
                   [](const SensorSample& a, const SensorSample& b) { return a.stamp < b.stamp; });
  const Timestamp first = samples.front().stamp;
  for (auto& sample : samples) sample.stamp -= first;

  DeviceInfo& info = recording.info;
  info.description = "Recorded frames of %1, %2"_text(config.family->title, path);
  info.sample_period_s = 1.0 / config.rate_Hz;
  info.hand = config.hand;
  info.platform = config.platform;
  info.provenance = {"raw log " + path};
  return recording;
}

}  // namespace isograsp

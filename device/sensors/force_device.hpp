// SPDX-License-Identifier: GPL-3.0-or-later
// A device of three six-axis force sensors, named by a URI. Wrenches leave it calibrated, in the
// contact frames of the fingers (z into the object, pressing +z), SI units, before instrument zero.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/bus.hpp"
#include "device/config/platform.hpp"
#include "hand/finger.hpp"
#include "hand/stimulus.hpp"

namespace isograsp {

struct BusTap;

/// One sample of one sensor.
struct SensorSample {
  Finger finger = Finger::thumb;
  Timestamp stamp{0};  ///< when it was measured, on the clock given to start()
  Wrench wrench_C;     ///< contact frame [N, N m]
  RawCounts raw_counts{};
  bool valid = true;       ///< false: the device says that there is no value
  std::uint8_t flags = 0;  ///< SampleFlag::saturated, SampleFlag::overload
};

/// Counters of one sensor since start(); they never decrease.
struct SensorCounters {
  std::uint64_t good = 0;           ///< valid samples
  std::uint64_t invalid = 0;        ///< samples that came but mean nothing, whatever the reason
  std::uint64_t torn = 0;           ///< half samples
  std::uint64_t duplicate = 0;      ///< frames that came twice
  std::uint64_t late = 0;           ///< answers that came too late
  std::uint64_t lost = 0;           ///< samples missing by count or by time
  std::uint64_t stale = 0;          ///< samples that repeat one value for too long
  std::uint64_t saturated = 0;      ///< samples at the end of the range
  std::uint64_t overload = 0;       ///< samples with the sensor's own overload sign
  std::uint64_t status_errors = 0;  ///< samples that the sensor itself called wrong
  std::uint64_t restarts = 0;       ///< times that the sensor had to be set up again
};

enum class DeviceState : std::uint8_t {
  absent,
  identified,
  configured,
  streaming,
  degraded,
  faulted,
  finished
};
[[nodiscard]] std::string_view name_of(DeviceState state) noexcept;

/// Why a device is degraded or faulted; words for both screens come from words_of().
/// In the order of their weight, the gravest first.
enum class DeviceFault : std::uint8_t {
  none,
  interface_gone,
  interface_down,
  bus_off,
  silence,         ///< a sensor sends nothing
  wrong_sensor,    ///< a sensor came back as another one, or refuses its settings
  frozen,          ///< a sensor repeats one value: it does not measure
  status,          ///< a sensor says that it is broken
  overload,        ///< a sensor is overloaded or at the end of its range
  restarted,       ///< a sensor forgot its state: the zero must be checked
  bus_overflow,    ///< the bus adapter, or this computer, loses frames
  bus_warning,     ///< the bus counts many errors
  damaged_samples  ///< samples arrive torn or are lost
};
inline constexpr std::size_t kDeviceFaultCount = 13;
/// Whether forces are missing because of it: the device is faulted, not only degraded.
[[nodiscard]] constexpr bool stops_forces(DeviceFault fault) noexcept {
  return fault != DeviceFault::none && fault <= DeviceFault::status;
}
/// One word for machines: "silence", "bus_off".
[[nodiscard]] std::string_view name_of(DeviceFault fault) noexcept;
/// One plain sentence for the therapist, with what to do. Real-time safe.
[[nodiscard]] Words words_of(DeviceFault fault,
                             std::optional<Finger> finger = std::nullopt) noexcept;

struct DeviceHealth {
  DeviceState state = DeviceState::absent;
  DeviceFault fault = DeviceFault::none;
  std::optional<Finger> finger;  ///< whose sensor has the fault; none: the bus
  std::array<SensorCounters, kFingerCount> sensors{};
  std::uint64_t foreign_frames = 0;  ///< frames on the bus that are not ours
  BusCounters bus;
};

/// What the device is. Real sensors tell serial numbers and units at start(); the rest is fixed.
struct DeviceInfo {
  std::string uri;
  Text description;               ///< one line for people, e.g. "Robotous RFT on can0"
  bool simulated = false;         ///< forces come from software: reports carry a watermark
  bool recorded = false;          ///< forces come from a file
  bool on_grid = false;           ///< samples lie exactly on the frame grid: never interpolate
  double sample_period_s = 0.01;  ///< nominal, of each sensor
  double frame_period_s = 0.01;   ///< of the grid that the frame clock should make
  double delay_s = 0.0;           ///< known delay from force to stamp (filter)
  std::optional<Hand> hand;       ///< the platform is mounted for this hand only
  std::array<std::string, kFingerCount> serial_numbers;
  std::array<Vec6, kFingerCount> units_per_count;  ///< [N, N m] per raw count; 0: no counts
  /// The clinic's: name of the file, date, matrix row by row; empty: none.
  std::array<std::string, kFingerCount> calibration;
  std::array<Vec6, kFingerCount> range;  ///< largest force and torque [N, N m]
  Platform platform;                     ///< where the supports stand
  std::vector<std::string> provenance;   ///< where recorded data come from, what was overridden
};

enum class ReadStatus : std::uint8_t {
  sample,   ///< `out` holds one
  timeout,  ///< the deadline has passed
  finished  ///< there will be no more samples (end of a recording)
};

/// Life: open_device() -> start() -> read()… -> stop(). All calls from one thread.
class ForceDevice {
 public:
  virtual ~ForceDevice() = default;

  [[nodiscard]] virtual const DeviceInfo& info() const noexcept = 0;
  [[nodiscard]] virtual DeviceHealth health() const noexcept = 0;

  /// Begins to stream; stamps are on `clock`, the first not before its present time. The clock must
  /// outlive the device.
  [[nodiscard]] virtual Result<void> start(Clock& clock) = 0;
  /// Waits for the next sample at most until `deadline`. Real-time safe. Samples of one sensor come
  /// in the order of their stamps.
  [[nodiscard]] virtual ReadStatus read(Timestamp deadline, SensorSample& out) noexcept = 0;
  /// The present on the axis of the stamps and deadlines: what FrameClock::pop() must be given.
  /// That of the clock, except for a replay that runs slower or faster than it was recorded.
  /// Real-time safe.
  [[nodiscard]] virtual Timestamp now(const Clock& clock) const noexcept { return clock.now(); }
  virtual void stop() noexcept = 0;
};

struct DeviceOptions {
  FingerSource* source = nullptr;  ///< presses sim://, which needs it; must outlive the device
  std::shared_ptr<BusTap> tap;     ///< gets every frame of a bus; devices without one refuse it
};

/// Opens sim://…, replay://FILE?speed=…, can://IFACE?protocol=…&config=…, udp://…, serial://….
/// Errors name the scheme, parameter or interface and what would be needed.
[[nodiscard]] Result<std::unique_ptr<ForceDevice>> open_device(const std::string& uri,
                                                               const DeviceOptions& options = {});

}  // namespace isograsp

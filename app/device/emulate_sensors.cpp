// SPDX-License-Identifier: GPL-3.0-or-later
// Three emulated sensors on a bus.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/device/emulate.hpp"
#include "app/device/live_device.hpp"
#include "app/language.hpp"
#include "device/bus/bus.hpp"
#include "device/config/family_facts.hpp"
#include "device/emulator/emulator.hpp"
#include "device/emulator/slcan_adapter.hpp"
#include "device/family/buses.hpp"
#include "hand/finger_forces.hpp"
#include "tasks/task.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::app {

namespace {

/// A minute of a virtual patient who presses, holds and releases, repeated for ever.
FingerPlay patient_play(const virtual_patient::PatientTraits& traits, std::uint64_t seed) {
  constexpr double kRound_s = 60.0;
  constexpr int kRate_Hz = 1000;
  constexpr int kStepsPerPicture = 10;
  virtual_patient::VirtualPatient person(traits, seed);
  FingerPlay play;
  play.repeat = true;
  play.duration_s = kRound_s;
  FingerWrenches wrenches{};
  for (int k = 0; k < static_cast<int>(kRound_s) * kRate_Hz; ++k) {
    const double t_s = static_cast<double>(k) / kRate_Hz;
    if (k % kStepsPerPicture == 0) person.see(press_hold_release(t_s, force_of(wrenches, {})));
    wrenches = person.press(t_s);
    play.t_s.push_back(t_s);
    play.wrench_C.push_back(wrenches);
  }
  return play;
}

/// A finger without a value in a row of the file keeps the one before.
Result<FingerPlay> file_play(const std::string& path) {
  auto reader = FingerForcesReader::open(path);
  if (!reader) return reader.error();
  FingerPlay play;
  FingerForcesRow row;
  FingerWrenches wrenches{};
  double first_t_s = 0.0;
  while (true) {
    const auto more = reader->next(row);
    if (!more) return more.error();
    if (!*more) break;
    if (play.t_s.empty()) first_t_s = row.t_s;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      if (row.present[f]) wrenches[f] = row.wrench_C[f];
    play.t_s.push_back(row.t_s - first_t_s);
    play.wrench_C.push_back(wrenches);
  }
  if (play.t_s.empty())
    return refused("the file has no rows"_text, "give at least one"_text).at(path);
  return play;
}

Result<FingerPlay> make_play(const EmulateOptions& options, EmulatorOptions& emulator) {
  if (const auto traits = virtual_patient::patient_traits(options.play)) {
    constexpr int kSensorNoise = 3;  // counts, as real sensors show at rest
    emulator.noise_counts = kSensorNoise;
    emulator.filtered = true;
    return patient_play(*traits, options.seed);
  }
  if (!options.play.ends_with(".csv"))
    return refused("'%1' is neither a person nor a file"_text(options.play),
                   "use healthy, paretic or a finger-forces file FILE.csv"_text)
        .about("--play");
  return file_play(options.play);
}

void print_counters(const Emulator& emulator, bool json) {
  nlohmann::ordered_json document{{"sensors", nlohmann::ordered_json::array()}};
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& c = emulator.counters()[f];
    document["sensors"].push_back({{"finger", kFingerNames[f]},
                                   {"samples", c.samples},
                                   {"lost_samples", c.lost_samples},
                                   {"lost_tx1", c.lost_first},
                                   {"lost_tx2", c.lost_second},
                                   {"swapped", c.swapped},
                                   {"duplicated", c.duplicated},
                                   {"delayed", c.delayed},
                                   {"frozen", c.frozen},
                                   {"foreign_frames", c.foreign},
                                   {"cut_frames", c.cut},
                                   {"unasked_answers", c.answers},
                                   {"burst_frames", c.burst},
                                   {"restarts", c.restarts}});
    if (!json)
      print("%-7s %s\n", std::string(kFingerNames[f]).c_str(),
            spoken("%1 samples, %2 lost on purpose"_text(c.samples, c.lost_samples)).c_str());
  }
  if (json) print_json(document);
}

/// Faults of the bus, played by the adapter at their times.
class AdapterFaults {
 public:
  AdapterFaults(const std::vector<Fault>& faults, SlcanAdapter& adapter) : adapter_(adapter) {
    for (const auto& fault : faults) {
      if (!fault.of_bus()) continue;
      add(fault.at_s, begin_of(fault.kind));
      if (fault.kind == Fault::Kind::stall)
        add(fault.at_s + fault.duration_s, AdapterFault::resume);
      if (fault.kind == Fault::Kind::unplug)
        add(fault.at_s + fault.duration_s, AdapterFault::plug_in);
    }
    std::stable_sort(events_.begin(), events_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  void strike(double play_time_s) {
    for (; next_ < events_.size() && events_[next_].first <= play_time_s; ++next_)
      adapter_.inject(events_[next_].second);
  }

 private:
  void add(double at_s, AdapterFault fault) { events_.emplace_back(at_s, fault); }
  static AdapterFault begin_of(Fault::Kind kind) {
    switch (kind) {
      case Fault::Kind::warning: return AdapterFault::error_warning;
      case Fault::Kind::passive: return AdapterFault::error_passive;
      case Fault::Kind::overflow: return AdapterFault::receive_overflow;
      case Fault::Kind::stall: return AdapterFault::stall;
      case Fault::Kind::unplug: return AdapterFault::unplug;
      default: return AdapterFault::bus_off;
    }
  }

  SlcanAdapter& adapter_;
  std::vector<std::pair<double, AdapterFault>> events_;
  std::size_t next_ = 0;
};

/// Plays until time is up or Ctrl-C; `every_look` is called at least ten times a second.
void play_on(Bus& bus, Clock& clock, Emulator& emulator, double duration_s,
             const std::function<void(double)>& every_look) {
  constexpr Timestamp kLook = std::chrono::milliseconds(100);
  const Timestamp end =
      duration_s > 0.0 ? clock.now() + from_seconds(duration_s) : Timestamp::max();
  ReceivedFrame in;
  BusFrame out;
  while (!interrupted()) {
    const Timestamp now = clock.now();
    if (now >= end) break;
    every_look(emulator.play_time_s(now));
    while (emulator.take(now, out)) bus.send(out);
    const BusEvent event = bus.receive(std::min({emulator.next(), now + kLook, end}), in);
    if (event == BusEvent::frame) emulator.receive(in.frame, in.stamp);
  }
  emulator.finish(clock.now());  // what was measured is still sent
  while (emulator.take(Timestamp::max(), out)) bus.send(out);
}

Result<EmulatorOptions> emulator_options(const EmulateOptions& options) {
  auto config = family_config(options.protocol, options.config);
  if (!config) return config.error();
  EmulatorOptions emulator;
  emulator.config = *std::move(config);
  emulator.seed = options.seed;
  for (const auto& text : options.faults) {
    const auto fault = Fault::parse(text);
    if (!fault) return fault.error();
    emulator.faults.push_back(*fault);
  }
  return emulator;
}

}  // namespace

Result<void> emulate_sensors(const EmulateOptions& options) {
  auto emulated = emulator_options(options);
  if (!emulated) return emulated.error();
  auto play = make_play(options, *emulated);
  if (!play) return play.error();
  const std::vector<Fault> faults = emulated->faults;
  const DeviceConfig config = emulated->config;
  const bool of_bus =
      std::any_of(faults.begin(), faults.end(), [](const Fault& f) { return f.of_bus(); });

  SteadyClock clock;
  std::unique_ptr<Bus> bus;
  std::optional<AdapterFaults> adapter_faults;
  std::string where = options.on;
  constexpr std::string_view kAdapter = "slcan:";
  const bool adapter = options.on.starts_with(kAdapter);
  if (of_bus && !adapter)
    return refused("faults of the bus need an emulated adapter"_text, "use --on slcan:can0"_text)
        .about("--fault");
  if (config.family->open_emulated != nullptr) {
    auto opened = config.family->open_emulated(options.on, config, where);
    if (!opened) return opened.error();
    bus = *std::move(opened);
  } else if (adapter) {
    auto opened = SlcanAdapter::open(options.on.substr(kAdapter.size()));
    if (!opened) return opened.error();
    adapter_faults.emplace(faults, **opened);
    bus = *std::move(opened);
  } else {
    auto opened = open_socketcan(options.on, can_ids(config).heard);
    if (!opened) return opened.error();
    bus = *std::move(opened);
  }
  if (auto started = bus->start(clock); !started) return started;

  watch_for_interrupt();
  Emulator emulator(*std::move(emulated), *std::move(play));
  if (!options.json) print_note("three %1 sensors play on %2"_text(config.family->title, where));
  play_on(*bus, clock, emulator, options.duration_s, [&](double play_time_s) {
    if (adapter_faults) adapter_faults->strike(play_time_s);
  });
  print_counters(emulator, options.json);
  return {};
}

}  // namespace isograsp::app

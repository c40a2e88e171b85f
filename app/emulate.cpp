// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp emulate: three sensors in software on a real bus, for everybody without the hardware.
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/live_device.hpp"
#include "core/finger_forces.hpp"
#include "device/can_bus.hpp"
#include "device/rft_emulator.hpp"
#include "tasks/task.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp {

namespace {

struct EmulateOptions {
  std::string protocol;
  std::string interface;
  std::string play = "healthy";
  std::uint64_t seed = 1;
  std::vector<std::string> faults;
  double duration_s = 0.0;
  bool json = false;
};

/// A minute of a virtual patient who presses, holds and releases, repeated for ever.
FingerPlay patient_play(const PatientTraits& traits, std::uint64_t seed) {
  constexpr double kRound_s = 60.0;
  constexpr int kRate_Hz = 1000;
  constexpr int kStepsPerPicture = 10;
  VirtualPatient person(traits, seed);
  FingerPlay play;
  play.repeat = true;
  play.duration_s = kRound_s;
  FingerWrenches wrenches{};
  for (int k = 0; k < static_cast<int>(kRound_s) * kRate_Hz; ++k) {
    const double t_s = static_cast<double>(k) / kRate_Hz;
    if (k % kStepsPerPicture == 0) person.see(press_hold_release(t_s, grip_force(wrenches)));
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
    return Error{Error::Code::bad_input, "the file has no rows", "give at least one", path, 0, ""};
  return play;
}

Result<FingerPlay> make_play(const EmulateOptions& options, RftEmulatorOptions& emulator) {
  if (const auto traits = patient_traits(options.play)) {
    constexpr int kSensorNoise = 3;  // counts, as real sensors show at rest
    emulator.noise_counts = kSensorNoise;
    emulator.filtered = true;
    return patient_play(*traits, options.seed);
  }
  if (!options.play.ends_with(".csv"))
    return Error{Error::Code::bad_input,
                 "'" + options.play + "' is neither a person nor a file",
                 "use healthy, paretic or a finger-forces file FILE.csv",
                 "",
                 0,
                 "--play"};
  return file_play(options.play);
}

void print_counters(const RftEmulator& emulator, bool json) {
  nlohmann::ordered_json document{{"sensors", nlohmann::ordered_json::array()}};
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& c = emulator.counters()[f];
    document["sensors"].push_back({{"finger", kFingerNames[f]},
                                   {"samples", c.samples},
                                   {"lost_samples", c.lost_samples},
                                   {"lost_tx1", c.lost_first},
                                   {"lost_tx2", c.lost_second}});
    if (!json)
      std::printf("%-7s %llu samples, %llu lost on purpose\n", std::string(kFingerNames[f]).c_str(),
                  static_cast<unsigned long long>(c.samples),
                  static_cast<unsigned long long>(c.lost_samples));
  }
  if (json) std::puts(document.dump(2).c_str());
}

Result<void> run_emulate(const EmulateOptions& options) {
  if (options.protocol != "rft")
    return Error{Error::Code::bad_input,
                 "no emulator is called '" + options.protocol + "'",
                 "use rft",
                 "",
                 0,
                 "--protocol"};
  RftEmulatorOptions emulator_options;
  emulator_options.seed = options.seed;
  for (const auto& text : options.faults) {
    const auto fault = RftFault::parse(text);
    if (!fault) return fault.error();
    emulator_options.faults.push_back(*fault);
  }
  auto play = make_play(options, emulator_options);
  if (!play) return play.error();
  std::vector<std::uint32_t> ids;
  for (const auto& sensor : emulator_options.config.sensors) ids.push_back(sensor.ids.command);
  auto bus = open_socketcan(options.interface, ids);
  if (!bus) return bus.error();
  SteadyClock clock;
  if (auto started = (*bus)->start(clock); !started) return started;

  watch_for_interrupt();
  RftEmulator emulator(std::move(emulator_options), *std::move(play));
  if (!options.json) print_note("three RFT sensors play on " + options.interface);
  constexpr Timestamp kLook = std::chrono::milliseconds(100);  // for Ctrl-C
  const Timestamp end =
      options.duration_s > 0.0 ? clock.now() + from_seconds(options.duration_s) : Timestamp::max();
  ReceivedFrame in;
  CanFrame out;
  while (!interrupted()) {
    const Timestamp now = clock.now();
    if (now >= end) break;
    while (emulator.take(now, out)) (*bus)->send(out);
    const BusEvent event = (*bus)->receive(std::min({emulator.next(), now + kLook, end}), in);
    if (event == BusEvent::frame) emulator.receive(in.frame, in.stamp);
  }
  for (const auto& sensor : kRftIds)  // what was measured still leaves
    emulator.receive(encode_command(sensor, RftCommand::stop), clock.now());
  while (emulator.take(Timestamp::max(), out)) (*bus)->send(out);
  print_counters(emulator, options.json);
  return {};
}

}  // namespace

void add_emulate(CLI::App& app, Action& action) {
  auto options = std::make_shared<EmulateOptions>();
  CLI::App* command = app.add_subcommand("emulate", "Three sensors in software on a real bus");
  command->add_option("--protocol", options->protocol, "rft")->required();
  command->add_option("--on", options->interface, "CAN interface, e.g. vcan0")->required();
  command->add_option("--play", options->play, "healthy, paretic or FILE.csv")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of person, clocks and faults")
      ->capture_default_str();
  command->add_option("--fault", options->faults,
                      "lose=FINGER:tx1|tx2:PROBABILITY, silence=FINGER@5s, dip=FINGER@5s");
  command->add_option("--duration", options->duration_s, "Seconds; without it until Ctrl-C")
      ->check(CLI::Range(0.001, 1e6));
  command->add_flag("--json", options->json, "Print what was sent as one JSON document");
  command->footer(
      "Example:\n  isograsp emulate --protocol rft --on vcan0 --play paretic --seed 7 "
      "--fault lose=index:tx2:0.01");
  command->callback([options, &action] {
    action = [options] { return run_emulate(*options); }; });
}

}  // namespace isograsp

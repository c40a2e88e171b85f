// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/tools/read_waveform.hpp"

#include "core/csv.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kLeast_Hz = 0.001;
constexpr double kMost_Hz = 5.0;  ///< beyond what a hand can follow

void read_csv_data(TomlReader& reader, Waveform& waveform) {
  waveform.csv = reader.text("csv");
  if (!reader.has("csv_data")) return;  // put there when the task is loaded
  TomlReader data = reader.table("csv_data");
  constexpr std::size_t kMostPoints = 100'000;
  waveform.t_s = data.numbers("t_s", 2, kMostPoints);
  waveform.values = data.numbers("target", 2, kMostPoints);
  if (waveform.t_s.size() != waveform.values.size())
    return data.fail("target", "has another length than t_s"_text, "write one value per time"_text);
  for (std::size_t k = 1; k < waveform.t_s.size(); ++k)
    if (!(waveform.t_s[k] > waveform.t_s[k - 1]))
      return data.fail("t_s", "does not increase"_text, "sort the times"_text);
  for (const double value : waveform.values)
    if (!(value >= 0.0 && value <= 1.0))
      return data.fail("target", "%1 is out of range"_text(shortest(value)),
                       "scale the target to 0 … 1"_text);
}

}  // namespace

Waveform read_waveform(TomlReader& reader, double duration_s) {
  using Wave = Waveform::Shape;
  Waveform waveform;
  waveform.shape =
      static_cast<Wave>(reader.choice("waveform",
                                      {"constant", "ramp", "trapezoid", "triangle", "sine",
                                       "swept_sine", "rectangle", "multi_sine", "random", "csv"},
                                      static_cast<std::size_t>(Wave::sine)));
  switch (waveform.shape) {
    case Wave::constant: break;
    case Wave::trapezoid:
      waveform.hold_s = read_wait(reader, "hold_s", waveform.hold_s);
      waveform.fall_s = read_duration(reader, "fall_s", waveform.fall_s);
      [[fallthrough]];
    case Wave::ramp: waveform.rise_s = read_duration(reader, "rise_s", waveform.rise_s); break;
    case Wave::swept_sine:
      waveform.last_frequency_Hz =
          read_within(reader, "last_frequency_Hz", kLeast_Hz, kMost_Hz, waveform.last_frequency_Hz);
      [[fallthrough]];
    case Wave::triangle:
    case Wave::sine:
    case Wave::rectangle:
      waveform.frequency_Hz =
          read_within(reader, "frequency_Hz", kLeast_Hz, kMost_Hz, waveform.frequency_Hz);
      break;
    case Wave::multi_sine:
      waveform.frequencies = reader.numbers("frequencies_Hz", 1, 20);
      for (const double frequency : waveform.frequencies)
        if (!(frequency >= kLeast_Hz && frequency <= kMost_Hz))
          reader.fail("frequencies_Hz", "%1 is out of range"_text(shortest(frequency)),
                      "write frequencies up to 5 Hz"_text);
      break;
    case Wave::random:
      waveform.bandwidth_Hz =
          read_within(reader, "bandwidth_Hz", kLeast_Hz, kMost_Hz, waveform.bandwidth_Hz);
      if (waveform.bandwidth_Hz * duration_s > kMostSines)
        reader.fail("bandwidth_Hz", "gives too many lines for this duration"_text,
                    "keep bandwidth times duration below %1"_text(shortest(kMostSines)));
      if (waveform.bandwidth_Hz * duration_s < 1.0)
        reader.fail("bandwidth_Hz", "is below one cycle in this duration"_text,
                    "raise it, or make the target longer"_text);
      break;
    case Wave::csv: read_csv_data(reader, waveform); break;
  }
  const bool seeded = waveform.shape == Wave::multi_sine || waveform.shape == Wave::random;
  if (seeded && reader.has("seed")) {
    const auto seed = reader.integer("seed");
    if (seed < 0) reader.fail("seed", "is negative"_text, "write 0 or more"_text);
    waveform.seed = static_cast<std::uint64_t>(seed);
  }
  return waveform;
}

}  // namespace isograsp::tasks

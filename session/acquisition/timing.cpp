// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/timing.hpp"

#include "core/csv.hpp"

namespace isograsp::session {

namespace {

void append(std::string& json, const char* name, const Histogram& histogram) {
  const Quantiles q = quantiles_of(histogram);
  const auto add = [&json](const char* key, double value) {
    json += std::string(", \"") + key + "\": " + format_number(value);
  };
  json += std::string(json.size() > 1 ? ", \"" : "\"") + name +
          "\": {\"count\": " + std::to_string(histogram.count());
  add("median_s", q.median_s);
  add("p99_s", q.most_of_100_s);
  add("p999_s", q.most_of_1000_s);
  add("max_s", q.largest_s);
  json += ", \"bins\": [";
  bool first = true;
  for (std::size_t bin = 0; bin < Histogram::kBins; ++bin) {
    if (histogram.count(bin) == 0) continue;
    json += std::string(first ? "[" : ", [") + std::to_string(Histogram::lower_edge_ns(bin)) +
            ", " + std::to_string(histogram.count(bin)) + "]";
    first = false;
  }
  json += "]}";
}

}  // namespace

Quantiles quantiles_of(const Histogram& histogram) noexcept {
  return {histogram.quantile_s(0.5), histogram.quantile_s(0.99), histogram.quantile_s(0.999),
          histogram.largest_s()};
}

TimingSummary summary_of(const Timing& timing) noexcept {
  return {quantiles_of(timing.period), quantiles_of(timing.lateness), quantiles_of(timing.compute),
          quantiles_of(timing.latency)};
}

std::string as_json(const Timing& timing) {
  std::string json = "{";
  append(json, "period", timing.period);
  append(json, "lateness", timing.lateness);
  append(json, "compute", timing.compute);
  append(json, "latency", timing.latency);
  return json + "}";
}

}  // namespace isograsp::session

// SPDX-License-Identifier: GPL-3.0-or-later
// Small builders shared by the tests of tasks/.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure.hpp"
#include "core/signals.hpp"
#include "statistics/samples.hpp"

namespace isograsp::test {

/// `count` times k / rate.
inline std::vector<double> times(std::size_t count, double rate_Hz = 100.0, double start_s = 0.0) {
  std::vector<double> t(count);
  for (std::size_t k = 0; k < count; ++k) t[k] = start_s + static_cast<double>(k) / rate_Hz;
  return t;
}

template <class Function>
std::vector<double> sampled(const std::vector<double>& t_s, Function&& f) {
  std::vector<double> x;
  x.reserve(t_s.size());
  for (const double t : t_s) x.push_back(f(t));
  return x;
}

/// The measure of that name (and channel, if given), or null.
inline const Measure* find(const std::vector<Measure>& measures, std::string_view name,
                           std::string_view channel = "") {
  for (const Measure& measure : measures)
    if (measure.name == name && (channel.empty() || measure.channel == channel)) return &measure;
  return nullptr;
}

/// Its value; NaN if there is no such measure or no value.
inline double value_of(const std::vector<Measure>& measures, std::string_view name,
                       std::string_view channel = "") {
  const Measure* measure = find(measures, name, channel);
  return measure != nullptr && measure->value ? *measure->value : std::nan("");
}

/// The same signals with rows changed; a row made empty is left out.
inline Signals edited(const Signals& signals,
                      const std::function<void(std::size_t, std::vector<double>&)>& edit) {
  Signals copy(signals.names());
  for (std::size_t k = 0; k < signals.rows(); ++k) {
    std::vector<double> row;
    for (std::size_t c = 0; c < signals.names().size(); ++c) row.push_back(signals.column(c)[k]);
    edit(k, row);
    if (!row.empty()) copy.append_row(row);
  }
  return copy;
}

}  // namespace isograsp::test

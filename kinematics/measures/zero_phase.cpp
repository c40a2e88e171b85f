// SPDX-License-Identifier: GPL-3.0-or-later
// Two passes of a Butterworth low-pass of order 2 with corner Wc on the axis W = tan(pi f / rate)
// have the gain 1 / (1 + (W / Wc)^4); it is 1 / sqrt 2 at W(cutoff) if
//   Wc = W(cutoff) / (sqrt 2 - 1)^(1/4)
// Attitudes: the four components of the quaternions are filtered and the result is made a unit
// quaternion. Products with a constant quaternion are linear in the components, so the result does
// not depend on the frames on either side; a turn at constant rate has components cos and sin of
// one frequency, which lose the same share, so it stays. Continuation: q_0 q_k^-1 q_0 is the point
// reflection of q_k at q_0, and the one that a turn at constant rate has.
#include "kinematics/measures/zero_phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/butterworth.hpp"

namespace isograsp {

namespace {

constexpr double kRateSlack = 0.01;

template <class Value>
std::vector<MotionRun> runs_of(std::span<const double> t_s, std::span<const Value> values) {
  std::vector<MotionRun> runs;
  const auto step_s = usual_step_s(t_s);
  bool open = false;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (is_missing(values[row])) {
      open = false;
      continue;
    }
    if (open && t_s[row] - t_s[row - 1] > kLongestMotionStep * *step_s) open = false;
    if (!open) runs.push_back({row, row});
    runs.back().end = row + 1;
    open = true;
  }
  return runs;
}

double mean_step_s(std::span<const double> t_s, const MotionRun& run) {
  return (t_s[run.end - 1] - t_s[run.first]) / static_cast<double>(run.end - run.first - 1);
}

/// The low-pass of a run and how many samples it remembers.
struct RunFilter {
  LowPass2 filter;
  std::size_t memory = 0;
};
RunFilter filter_for(double rate_Hz, double cutoff_Hz) {
  constexpr double kForgotten = 1e-12;  // of the start: below the rounding of positions in a room
  const double correction = std::sqrt(std::sqrt(std::numbers::sqrt2 - 1.0));
  const double corner = std::tan(std::numbers::pi * cutoff_Hz / rate_Hz) / correction;
  const double corner_Hz = rate_Hz / std::numbers::pi * std::atan(corner);
  // The poles lie at 45 degrees: what is left of a start is exp(-2 pi corner t / sqrt 2).
  const double memory_s =
      -std::log(kForgotten) / (std::numbers::sqrt2 * std::numbers::pi * corner_Hz);
  return {butterworth2(rate_Hz, corner_Hz),
          static_cast<std::size_t>(std::ceil(memory_s * rate_Hz)) + 1};
}

/// The values with `margin` more on both sides: odd about both ends, as often as it takes.
template <class Value, class Reflect>
std::vector<Value> continued_beyond(std::span<const Value> x, std::size_t margin,
                                    const Reflect& reflect) {
  std::vector<Value> y(x.size() + 2 * margin, x.front());
  std::copy(x.begin(), x.end(), y.begin() + static_cast<std::ptrdiff_t>(margin));
  std::size_t first = margin;
  std::size_t last = margin + x.size() - 1;
  while (first > 0 && last > first) {
    const std::size_t count = std::min(first, last - first);
    for (std::size_t k = 1; k <= count; ++k) {
      y[first - k] = reflect(y[first], y[first + k]);
      y[last + k] = reflect(y[last], y[last - k]);
    }
    first -= count;
    last += count;
  }
  return y;
}

/// Component by component, `get` and `set` of a value; only the rows of the run.
template <class Value, class Get, class Set>
void filter_components(const RunFilter& pass, const std::vector<Value>& continued_x,
                       std::size_t margin, int components, std::span<Value> out, const Get& get,
                       const Set& set) {
  std::vector<double> channel(continued_x.size());
  for (int c = 0; c < components; ++c) {
    for (std::size_t k = 0; k < channel.size(); ++k) channel[k] = get(continued_x[k], c);
    const auto smooth = filtered_zero_phase(pass.filter, channel);
    for (std::size_t k = 0; k < out.size(); ++k) set(out[k], c, smooth[margin + k]);
  }
}

void filter_run(const RunFilter& pass, std::span<const Vec3> in, std::span<Vec3> out) {
  const auto all = continued_beyond(
      in, pass.memory, [](const Vec3& end, const Vec3& inner) { return Vec3(2.0 * end - inner); });
  filter_components(
      pass, all, pass.memory, 3, out, [](const Vec3& p, int c) { return p[c]; },
      [](Vec3& p, int c, double value) { p[c] = value; });
}

void filter_run(const RunFilter& pass, std::span<const Quat> in, std::span<Quat> out) {
  std::vector<Quat> signs(in.begin(), in.end());
  for (std::size_t k = 1; k < signs.size(); ++k) signs[k] = continued(signs[k], signs[k - 1]);
  const auto all = continued_beyond(
      std::span<const Quat>(signs), pass.memory, [](const Quat& end, const Quat& inner) {
        return Quat((end * inner.conjugate() * end).coeffs().normalized());
      });
  filter_components(
      pass, all, pass.memory, 4, out, [](const Quat& q, int c) { return q.coeffs()[c]; },
      [](Quat& q, int c, double value) { q.coeffs()[c] = value; });
  for (Quat& q : out) q = unit_quaternion(q.w(), q.x(), q.y(), q.z()).value_or(missing_pose().q);
}

template <class Value>
std::vector<Value> filtered_series(std::span<const double> t_s, std::span<const Value> values,
                                   double cutoff_Hz, const Value& missing) {
  std::vector<Value> out(values.size(), missing);
  if (!objection_to_rate(t_s).empty()) return out;
  for (const MotionRun& run : runs_of(t_s, values)) {
    const std::size_t count = run.end - run.first;
    const auto in = values.subspan(run.first, count);
    const auto to = std::span(out).subspan(run.first, count);
    if (count == 1)
      to[0] = in[0];
    else
      filter_run(filter_for(1.0 / mean_step_s(t_s, run), cutoff_Hz), in, to);
  }
  return out;
}

/// `change(a, b)` is what leads from value a to b; its share of a second is the velocity.
template <class Value, class Change>
std::vector<Vec3> rates_of(std::span<const double> t_s, std::span<const Value> values,
                           const Change& change) {
  std::vector<Vec3> rates(values.size(), Vec3::Constant(kMissing));
  for (const MotionRun& run : runs_of(t_s, values)) {
    if (run.end - run.first < 2) continue;
    const double step_s = mean_step_s(t_s, run);
    for (std::size_t row = run.first; row < run.end; ++row) {
      const std::size_t before = std::max(row, run.first + 1) - 1;
      const std::size_t after = std::min(row + 1, run.end - 1);
      rates[row] =
          change(values[before], values[after]) / (static_cast<double>(after - before) * step_s);
    }
  }
  return rates;
}

}  // namespace

std::optional<double> usual_step_s(std::span<const double> t_s) {
  if (t_s.size() < 2) return std::nullopt;
  std::vector<double> steps(t_s.size() - 1);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = t_s[k + 1] - t_s[k];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double longest_s = kLongestMotionStep * *middle;
  double sum_s = 0.0;
  std::size_t count = 0;
  for (const double step_s : steps)
    if (step_s <= longest_s) {
      sum_s += step_s;
      ++count;
    }
  return sum_s / static_cast<double>(count);
}

Text objection_to_rate(std::span<const double> t_s) {
  const auto step_s = usual_step_s(t_s);
  if (!step_s) return "fewer than two samples"_text;
  const double rate_Hz = 1.0 / *step_s;
  if (rate_Hz < kLeastMotionRate_Hz * (1.0 - kRateSlack) ||
      rate_Hz > kMostMotionRate_Hz * (1.0 + kRateSlack))
    return "the rate is not 50 to 500 Hz"_text;
  return {};
}

std::vector<MotionRun> motion_runs(std::span<const double> t_s, std::span<const Vec3> p) {
  return runs_of(t_s, p);
}

std::vector<MotionRun> motion_runs(std::span<const double> t_s, std::span<const Quat> q) {
  return runs_of(t_s, q);
}

std::vector<Vec3> zero_phase(std::span<const double> t_s, std::span<const Vec3> p,
                             double cutoff_Hz) {
  return filtered_series(t_s, p, cutoff_Hz, missing_pose().p);
}

std::vector<Quat> zero_phase(std::span<const double> t_s, std::span<const Quat> q,
                             double cutoff_Hz) {
  return filtered_series(t_s, q, cutoff_Hz, missing_pose().q);
}

std::vector<Pose> zero_phase(std::span<const double> t_s, std::span<const Pose> X,
                             double cutoff_Hz) {
  std::vector<Vec3> p;
  std::vector<Quat> q;
  for (const Pose& pose : X) {
    p.push_back(pose.p);
    q.push_back(pose.q);
  }
  p = zero_phase(t_s, p, cutoff_Hz);
  q = zero_phase(t_s, q, cutoff_Hz);
  std::vector<Pose> poses;
  for (std::size_t row = 0; row < X.size(); ++row) poses.push_back({p[row], q[row]});
  return poses;
}

std::vector<Vec3> velocities(std::span<const double> t_s, std::span<const Vec3> p) {
  return rates_of(t_s, p, [](const Vec3& from, const Vec3& to) { return Vec3(to - from); });
}

std::vector<Vec3> angular_velocities(std::span<const double> t_s, std::span<const Quat> q) {
  return rates_of(t_s, q, [](const Quat& from, const Quat& to) {
    return rotation_vector(to * from.conjugate());
  });
}

std::vector<double> lengths(std::span<const Vec3> v) {
  std::vector<double> all;
  all.reserve(v.size());
  for (const Vec3& one : v) all.push_back(is_missing(one) ? kMissing : one.norm());
  return all;
}

}  // namespace isograsp

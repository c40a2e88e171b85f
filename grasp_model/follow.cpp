// SPDX-License-Identifier: GPL-3.0-or-later
// An axis under a force F(t) over a panel of length h, g the motion after a unit impulse:
//   end = (step under F(h)) + sum_n weight_n h g(h (1 - time_n)) (F(time_n h) - F(h))
#include "grasp_model/follow.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_model/dormand_prince.hpp"
#include "grasp_model/low_orders.hpp"

namespace isograsp {

namespace {

template <std::size_t size>
constexpr Quadrature weighted(const std::array<double, size>& time,
                              const std::array<double, size>& weight,
                              const std::array<std::size_t, size>& stage) {
  Quadrature nodes;
  nodes.size = size;
  for (std::size_t n = 0; n < size; ++n) {
    nodes.time[n] = time[n];
    nodes.weight[n] = weight[n];
    nodes.stage[n] = stage[n];
  }
  return nodes;
}

}  // namespace

double fastest_rate(const Oscillator& o) noexcept {
  return o.m == 0.0 ? o.k / o.c : std::sqrt(o.k / o.m) + o.c / o.m;
}

const Quadrature& gauss5() noexcept {
  static constexpr Quadrature kGauss{
      5,
      {0.046910077030668004, 0.23076534494715845, 0.5, 0.76923465505284155, 0.953089922969332},
      {0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
       0.11846344252809454},
      {}};
  return kGauss;
}

const Quadrature& stage_nodes(so3::Order order) noexcept {
  static constexpr std::array<Quadrature, 3> kStages{
      weighted(bogacki_shampine::kTime, bogacki_shampine::kWeight, bogacki_shampine::kWeighted),
      weighted(cash_karp::kTime, cash_karp::kWeight, cash_karp::kWeighted),
      weighted(dormand_prince::kTime, dormand_prince::kWeight, dormand_prince::kWeighted)};
  return kStages[static_cast<std::size_t>(order)];
}

double FreeAxes::fastest_rate() const noexcept {
  double rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (free[i]) rate = std::max(rate, isograsp::fastest_rate(oscillator[i]));
  return rate;
}

QuadraturePanel::QuadraturePanel(const FreeAxes& axes, const Quadrature& nodes,
                                 double length_s) noexcept
    : nodes_(nodes.size), length_s_(length_s) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!axes.free[i]) continue;
    whole_[i] = LinearStep(axes.oscillator[i], length_s);
    for (std::size_t n = 0; n < nodes.size; ++n) {
      const Motion unit = impulse_response(axes.oscillator[i], length_s * (1.0 - nodes.time[n]));
      const double impulse = nodes.weight[n] * length_s;
      push_[i][n] = {impulse * unit.x, impulse * unit.v};
    }
  }
}

Motion QuadraturePanel::advance(Eigen::Index axis, const Motion& start,
                                const PanelForces& forces) const noexcept {
  const auto i = static_cast<std::size_t>(axis);
  // A stiff axis depends on the force near the end of the panel only, where the difference
  // vanishes.
  Motion end = whole_[i].advance(start, forces.end[axis]);
  for (std::size_t n = 0; n < nodes_; ++n) {
    const double difference = forces.node[n][axis] - forces.end[axis];
    end.x += push_[i][n].x * difference;
    end.v += push_[i][n].v * difference;
  }
  return end;
}

Follower::Follower(const FreeAxes& axes, const Quadrature& nodes, double hold_s, int finest)
    : axes_(axes), nodes_(&nodes), hold_s_(hold_s) {
  for (int level = 0; level <= finest; ++level)
    levels_.emplace_back(axes, nodes, std::ldexp(hold_s, -level));
}

}  // namespace isograsp

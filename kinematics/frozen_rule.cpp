// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/frozen_rule.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

FrozenRule::FrozenRule(const Rig& rig, std::span<const std::string> names)
    : markers_(names.size()) {
  for (const RigFrame& frame : rig.frames) {
    if (const auto* cluster = std::get_if<ClusterFrame>(&frame.method)) {
      add(true, cluster->markers, names);
    } else if (const auto* points = std::get_if<PointsFrame>(&frame.method)) {
      std::vector<std::string> members;
      for (const RigPoint* point : {&points->origin, &points->primary.from, &points->primary.to,
                                    &points->secondary.from, &points->secondary.to})
        for (const std::string& name : *point)
          if (std::find(members.begin(), members.end(), name) == members.end())
            members.push_back(name);
      add(false, members, names);
    }
  }
}

void FrozenRule::add(bool rigid, const std::vector<std::string>& members,
                     std::span<const std::string> names) {
  Body body;
  body.rigid = rigid;
  for (const std::string& member : members) {
    const auto at = std::find(names.begin(), names.end(), member);
    if (at != names.end()) body.members.push_back(static_cast<std::size_t>(at - names.begin()));
  }
  if (body.members.size() < 2) return;
  body.began.assign(body.members.size() * body.members.size(), Vec3::Constant(kMissing));
  bodies_.push_back(std::move(body));
}

void FrozenRule::apply(std::span<Vec3> p_W) noexcept {
  for (std::size_t k = 0; k < markers_.size(); ++k) {
    Marker& marker = markers_[k];
    const bool still = p_W[k] == marker.last;  // false for a missing one
    marker.rows = still ? std::min(marker.rows + 1, kRows) : is_missing(p_W[k]) ? 0 : 1;
    if (!still) marker.frozen = false;
    marker.last = p_W[k];
  }
  constexpr int kBegins = 2;  // most markers never stand still: nothing is remembered of them
  for (Body& body : bodies_)
    for (std::size_t m = 0; m < body.members.size(); ++m) {
      Marker& marker = markers_[body.members[m]];
      if (marker.rows < kBegins || marker.frozen) continue;
      if (marker.rows == kBegins) remember(body, m, p_W);
      if (marker.rows >= kRows && moved_m(body, m, p_W) > kMoved_m) marker.frozen = true;
    }
  for (std::size_t k = 0; k < markers_.size(); ++k)
    if (markers_[k].frozen) p_W[k] = Vec3::Constant(kMissing);
}

void FrozenRule::remember(Body& body, std::size_t member, std::span<const Vec3> p_W) noexcept {
  for (std::size_t other = 0; other < body.members.size(); ++other)
    body.began[member * body.members.size() + other] = p_W[body.members[other]];
}

double FrozenRule::moved_m(const Body& body, std::size_t member,
                           std::span<const Vec3> p_W) const noexcept {
  const Vec3& p = p_W[body.members[member]];
  double sum_m = 0.0;
  int count = 0;
  for (std::size_t other = 0; other < body.members.size(); ++other) {
    const Vec3& before = body.began[member * body.members.size() + other];
    const Vec3& now = p_W[body.members[other]];
    if (other == member || is_missing(before) || is_missing(now)) continue;
    sum_m += body.rigid ? (now - before).norm() : std::abs((now - p).norm() - (before - p).norm());
    ++count;
  }
  return count == 0 ? 0.0 : sum_m / count;
}

}  // namespace isograsp

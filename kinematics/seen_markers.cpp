// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/seen_markers.hpp"

#include <algorithm>
#include <utility>

namespace isograsp {

Result<SeenMarkers> SeenMarkers::compile(const Rig& rig, std::span<const std::string> labels) {
  auto names = aliased(rig, labels);
  if (!names) return names.error();
  const auto has = [&](const std::string& name) {
    return std::find(names->begin(), names->end(), name) != names->end();
  };
  const std::vector<std::string> markers = markers_of(rig);
  std::vector<std::size_t> cloud;
  for (std::size_t c = 0; c < names->size(); ++c)
    if (std::find(markers.begin(), markers.end(), (*names)[c]) == markers.end()) cloud.push_back(c);
  std::vector<Unlabelled> unlabelled;
  for (const RigFrame& frame : rig.frames) {
    const auto* cluster = std::get_if<ClusterFrame>(&frame.method);
    if (cluster == nullptr || !cluster->unlabelled ||
        std::any_of(cluster->markers.begin(), cluster->markers.end(), has))
      continue;
    const std::size_t first = names->size();
    names->insert(names->end(), cluster->markers.begin(), cluster->markers.end());
    unlabelled.push_back({CloudMatch(cluster->template_m), first,
                          std::vector<std::size_t>(cluster->markers.size())});
  }
  return SeenMarkers(rig, *std::move(names), std::move(cloud), std::move(unlabelled));
}

SeenMarkers::SeenMarkers(const Rig& rig, std::vector<std::string> names,
                         std::vector<std::size_t> cloud, std::vector<Unlabelled> unlabelled)
    : names_(std::move(names)),
      cloud_columns_(std::move(cloud)),
      unlabelled_(std::move(unlabelled)),
      frozen_(rig, names_),
      cloud_(cloud_columns_.size()),
      seen_(names_.size()) {}

std::span<const Vec3> SeenMarkers::see(std::span<const Vec3> p_W) noexcept {
  std::copy_n(p_W.begin(), std::min(p_W.size(), seen_.size()), seen_.begin());
  if (!unlabelled_.empty())
    for (std::size_t c = 0; c < cloud_.size(); ++c) cloud_[c] = p_W[cloud_columns_[c]];
  for (Unlabelled& body : unlabelled_) {
    const bool found = body.match.find(cloud_, body.places);
    for (std::size_t k = 0; k < body.places.size(); ++k)
      seen_[body.first + k] = found ? cloud_[body.places[k]] : Vec3::Constant(kMissing);
  }
  frozen_.apply(seen_);
  return seen_;
}

}  // namespace isograsp

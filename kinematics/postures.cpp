// SPDX-License-Identifier: GPL-3.0-or-later
// With reference subject 0 (posture 0 initial), patient i, posture j, links L along the chain:
//   M_L^j  = (X_L^00)^-1 X_L^0j               change of posture, from the reference subject
//   Xh_L   = (p_L^i0, R_L^00)                 the patient's lengths, the reference's attitude
//   X_WO^ij = X_WE^i prod_L Xh_L M_L^j
// Scale length: translation of M_L times |p_L^i0| / |p_L^00|, 1 where that is 0.
// The p are in frames of the patient, the R in those of the reference: both need the same recipe.
#include "kinematics/postures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/toml_reader.hpp"
#include "kinematics/read_attitude.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kMostLinks = StartPostureMean::kMostFrames - 1;

Posture read_posture(TomlReader& table, std::size_t links) {
  Posture posture;
  posture.name = table.text("name");
  for (TomlReader& link : table.tables("links")) posture.X_L.push_back(read_pose(link));
  if (posture.X_L.size() != links)
    table.fail("links", "are %1 links, the chain has %2"_text(posture.X_L.size(), links),
               "give one for each pair of neighbours in the chain"_text);
  return posture;
}

}  // namespace

Result<Postures> parse_postures(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-postures-1");
  if (!root) return root.error();
  Postures library;
  library.name = root->text("name", "");
  library.hand = root->choice("hand", {"right", "left"}, 0) == 0 ? Hand::right : Hand::left;
  library.chain = root->texts("chain");
  if (library.chain.size() < 2 || library.chain.size() > kMostLinks + 1)
    root->fail("chain", "are %1 frames"_text(library.chain.size()),
               "give 2 to %1"_text(kMostLinks + 1));
  for (TomlReader& table : root->tables("posture")) {
    Posture posture =
        read_posture(table, library.chain.size() - std::min<std::size_t>(library.chain.size(), 1));
    for (const Posture& other : library.postures)
      if (other.name == posture.name)
        table.fail("name", "'%1' appears twice"_text(posture.name), "keep one of them"_text);
    library.postures.push_back(std::move(posture));
  }
  if (library.postures.empty())
    root->fail("posture", "is missing"_text, "describe each posture in [[posture]]"_text);
  if (auto done = root->finish(); !done) return done.error();
  return library;
}

std::string postures_text(const Postures& library) {
  std::string chain;
  for (const std::string& frame : library.chain)
    chain += (chain.empty() ? "" : ", ") + toml_text(frame);
  std::string text = "format = \"isograsp-postures-1\"\nname = " + toml_text(library.name) +
                     "\nhand = \"" + std::string(name_of(library.hand)) + "\"\nchain = [" + chain +
                     "]\n";
  for (const Posture& posture : library.postures) {
    text += "\n[[posture]]\nname = " + toml_text(posture.name) + "\nlinks = [";
    for (std::size_t l = 0; l < posture.X_L.size(); ++l)
      text += std::string(l == 0 ? "" : ", ") + "{ position_m = " + toml_numbers(posture.X_L[l].p) +
              ", quaternion_wxyz = " + toml_numbers(posture.X_L[l].q) + " }";
    text += "]\n";
  }
  return text;
}

void StartPostureMean::add(std::span<const Pose> X_W) noexcept {
  for (const Pose& pose : X_W)
    if (is_missing(pose)) return;
  for (std::size_t k = 0; k < frames_; ++k) {
    const Pose X = k == 0 ? X_W[0] : compose(inverse(X_W[k - 1]), X_W[k]);
    Sum& sum = sums_[k];
    if (rows_ == 0) sum.first = X.p;
    sum.p += X.p;
    sum.square += (X.p - sum.first).cwiseAbs2();
    sum.attitude.add(X.q);
  }
  ++rows_;
}

double StartPostureMean::largest_sd_m() const noexcept {
  if (rows_ < 2) return kMissing;
  const auto n = static_cast<double>(rows_);
  double largest = 0.0;
  for (std::size_t k = 0; k < frames_; ++k) {
    const Vec3 away = sums_[k].p / n - sums_[k].first;
    const double variance = (sums_[k].square - n * away.cwiseAbs2()).sum() / (n - 1.0);
    largest = std::max(largest, std::sqrt(std::max(0.0, variance)));
  }
  return largest;
}

StartPosture StartPostureMean::mean() const {
  const auto n = static_cast<double>(rows_);
  StartPosture start;
  start.rows = rows_;
  start.X_W = {sums_[0].p / n, sums_[0].attitude.mean()};
  for (std::size_t k = 1; k < frames_; ++k)
    start.X_L.push_back({sums_[k].p / n, sums_[k].attitude.mean()});
  return start;
}

Result<StartPosture> start_posture(const PoseSeries& series,
                                   const std::vector<std::string>& chain) {
  std::vector<std::size_t> frames;
  for (const std::string& name : chain) {
    const auto at = frame_of(series, name);
    if (!at) return at.error();
    frames.push_back(*at);
  }
  StartPostureMean mean(frames.size());
  std::vector<Pose> X_W(frames.size());
  for (std::size_t row = 0; row < series.t_s.size(); ++row) {
    for (std::size_t k = 0; k < frames.size(); ++k) X_W[k] = series.X_W[frames[k]][row];
    mean.add(X_W);
  }
  if (mean.rows() == 0)
    return refused("has no row in which the whole chain is seen"_text,
                   "record again with all markers in view"_text)
        .at(series.source);
  return mean.mean();
}

std::vector<std::string> chain_of(const Rig& rig) {
  std::vector<std::string> chain;
  for (const RigLink& link : rig.links) {
    if (chain.empty() && link.parent != kWorld) chain = {link.parent};
    if (!chain.empty() && link.parent == chain.back() &&
        std::find(chain.begin(), chain.end(), link.child) == chain.end())
      chain.push_back(link.child);
  }
  return chain;
}

Posture part_of_the_way(const Posture& initial, Posture posture, double way) {
  for (std::size_t l = 0; l < posture.X_L.size(); ++l) {
    const Pose change = compose(inverse(initial.X_L[l]), posture.X_L[l]);
    const Vec3 turn = way * rotation_vector(change.q);
    const double angle_rad = turn.norm();
    const Quat q =
        angle_rad > 0.0 ? Quat(Eigen::AngleAxisd(angle_rad, turn / angle_rad)) : Quat::Identity();
    posture.X_L[l] = compose(initial.X_L[l], {way * change.p, q});
    posture.X_L[l].q.normalize();
  }
  return posture;
}

Postures part_of_the_way(Postures library, double way) {
  const Posture initial = library.postures.front();
  for (Posture& posture : library.postures)
    posture = part_of_the_way(initial, std::move(posture), way);
  return library;
}

Postures own_range_postures(const StartPosture& start, const std::vector<std::string>& chain,
                            std::size_t l, const RigLink& link, const OwnRange& range) {
  Postures own;
  own.name = "own range";
  own.chain = chain;
  own.postures.push_back({std::string(kStartOfRange), start.X_L});
  const auto add = [&](std::string_view name, double angle_rad) {
    Posture posture{std::string(name), start.X_L};
    Vec3 angles_rad = link_angles(start.X_L[l].q, link);
    angles_rad[range.angle] = angle_rad;
    const Quat from_zero_q = attitude_of(angles_rad, link.sequence);
    posture.X_L[l].q = link.zero ? (from_zero_q * *link.zero).normalized() : from_zero_q;
    own.postures.push_back(std::move(posture));
  };
  add(kLeastOfRange, range.min_rad);
  add(kLargestOfRange, range.max_rad);
  return own;
}

Pose change_of_link(const Postures& library, std::size_t index, std::size_t l,
                    const StartPosture& start, SizeScale scale) {
  const Pose& X_00 = library.postures.front().X_L[l];
  Pose change = compose(inverse(X_00), library.postures[index].X_L[l]);
  const double length_m = X_00.p.norm();
  if (scale == SizeScale::length && length_m > 0.0) change.p *= start.X_L[l].p.norm() / length_m;
  return change;
}

Pose adapted(const Postures& library, std::size_t index, const StartPosture& start,
             SizeScale scale) {
  Pose X_WO = start.X_W;
  const Posture& initial = library.postures.front();
  for (std::size_t l = 0; l < initial.X_L.size(); ++l)
    X_WO = compose(compose(X_WO, {start.X_L[l].p, initial.X_L[l].q}),
                   change_of_link(library, index, l, start, scale));
  X_WO.q.normalize();
  return X_WO;
}

}  // namespace isograsp

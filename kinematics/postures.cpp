// SPDX-License-Identifier: GPL-3.0-or-later
// With reference subject 0 (posture 0 initial), patient i, posture j, links L along the chain:
//   M_L^j  = (X_L^00)^-1 X_L^0j               change of posture, from the reference subject
//   Xh_L   = (p_L^i0, R_L^00)                 the patient's lengths, the reference's attitude
//   X_WO^ij = X_WE^i prod_L Xh_L M_L^j
// Scale length: translation of M_L times |p_L^i0| / |p_L^00|, 1 where that is 0.
// The p are in frames of the patient, the R in those of the reference: both need the same recipe.
#include "kinematics/postures.hpp"

#include <algorithm>
#include <utility>

#include "core/toml_reader.hpp"
#include "kinematics/read_attitude.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kMostLinks = 16;

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

Result<StartPosture> start_posture(const PoseSeries& series,
                                   const std::vector<std::string>& chain) {
  std::vector<std::size_t> frames;
  for (const std::string& name : chain) {
    const auto at = frame_of(series, name);
    if (!at) return at.error();
    frames.push_back(*at);
  }
  StartPosture start;
  const std::size_t links = chain.size() - 1;
  std::vector<Vec3> sums(links, Vec3::Zero());
  std::vector<MeanAttitude> attitudes(links);
  Vec3 sum = Vec3::Zero();
  MeanAttitude attitude;
  for (std::size_t row = 0; row < series.t_s.size(); ++row) {
    const auto pose = [&](std::size_t k) -> const Pose& { return series.X_W[frames[k]][row]; };
    bool complete = true;
    for (std::size_t k = 0; k < frames.size(); ++k) complete = complete && !is_missing(pose(k));
    if (!complete) continue;
    ++start.rows;
    sum += pose(0).p;
    attitude.add(pose(0).q);
    for (std::size_t l = 0; l < links; ++l) {
      const Pose X_L = compose(inverse(pose(l)), pose(l + 1));
      sums[l] += X_L.p;
      attitudes[l].add(X_L.q);
    }
  }
  if (start.rows == 0)
    return refused("has no row in which the whole chain is seen"_text,
                   "record again with all markers in view"_text)
        .at(series.source);
  const auto rows = static_cast<double>(start.rows);
  start.X_W = {sum / rows, attitude.mean()};
  for (std::size_t l = 0; l < links; ++l)
    start.X_L.push_back({sums[l] / rows, attitudes[l].mean()});
  return start;
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

Pose adapted(const Postures& library, std::size_t index, const StartPosture& start,
             SizeScale scale) {
  Pose X_WO = start.X_W;
  const Posture& initial = library.postures.front();
  for (std::size_t l = 0; l < initial.X_L.size(); ++l) {
    const Pose& X_00 = initial.X_L[l];
    Pose change = compose(inverse(X_00), library.postures[index].X_L[l]);
    const double length_m = X_00.p.norm();
    if (scale == SizeScale::length && length_m > 0.0) change.p *= start.X_L[l].p.norm() / length_m;
    X_WO = compose(compose(X_WO, {start.X_L[l].p, X_00.q}), change);
  }
  X_WO.q.normalize();
  return X_WO;
}

}  // namespace isograsp

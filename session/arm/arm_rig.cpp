// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/arm_rig.hpp"

#include <algorithm>
#include <filesystem>
#include <variant>

#include "core/files.hpp"
#include "kinematics/postures.hpp"
#include "session/library/library.hpp"

namespace isograsp::session {

Result<ArmRig> ArmRig::load(const std::string& name, const std::string& library, Hand hand,
                            const std::string& uri) {
  if (name.empty())
    return refused("names no rig"_text,
                   "add ?rig=NAME of a rig in the library, or ?rig=FILE.toml"_text)
        .at(uri)
        .about("rig");
  std::string path = name;
  if (!std::filesystem::is_regular_file(name)) {
    const auto found = find_in_library(library, "rigs", name);
    if (!found) return found.error();
    path = *found;
  }
  return read(path, hand);
}

Result<ArmRig> ArmRig::read(const std::string& path, Hand hand) {
  auto text = read_text(path);
  if (!text) return text.error();
  return parse(*std::move(text), path, hand);
}

Result<ArmRig> ArmRig::parse(std::string text, const std::string& path, Hand hand) {
  auto rig = parse_rig(text, path);
  if (!rig) return rig.error();
  ArmRig arm;
  arm.hand = hand;
  arm.text = std::move(text);
  arm.chain = chain_of(*rig);
  if (rig->frames.empty()) {
    arm.rig = *std::move(rig);
    return arm;
  }
  if (arm.chain.size() != kArmChain.size())
    return refused("has no chain of elbow, forearm, back of the hand and object"_text,
                   "give it three [[link]] from the elbow to the object"_text)
        .at(path)
        .about("link");
  if (!rig->score || rig->score->object != arm.chain.back())
    return refused("does not say that its chain ends with the object"_text,
                   "write object = \"%1\" in [score]"_text(arm.chain.back()))
        .at(path)
        .about("score");
  arm.rig = hand == Hand::left ? mirrored(*std::move(rig)) : *std::move(rig);
  for (std::size_t k = 0; k < kArmChain.size(); ++k)
    arm.frame_of[index_of(kArmChain[k])] = arm.rig.frame(arm.chain[k]);
  for (std::size_t k = 0; k < kArmLinkCount; ++k)
    arm.links[k] =
        *std::find_if(arm.rig.links.begin(), arm.rig.links.end(), [&](const RigLink& link) {
          return link.parent == arm.chain[k] && link.child == arm.chain[k + 1];
        });
  // One elbow marker has the attitude of the brace.
  const RigFrame& elbow = arm.rig.frames[*arm.frame_of[index_of(ArmSegment::elbow)]];
  if (const auto* point = std::get_if<PointFrame>(&elbow.method))
    arm.frame_of[index_of(ArmSegment::brace)] = arm.rig.frame(point->orientation);
  arm.frame_of[index_of(ArmSegment::trunk)] =
      arm.rig.frame(kArmSegmentNames[index_of(ArmSegment::trunk)]);
  return arm;
}

Result<std::vector<RecordedMarker>> recorded_markers(const Rig& rig,
                                                     std::span<const std::string> labels) {
  const auto names = aliased(rig, labels);
  if (!names) return names.error();
  const auto named = markers_of(rig);
  std::vector<RecordedMarker> recorded;
  for (std::size_t i = 0; i < names->size(); ++i) {
    const std::string& name = (*names)[i];
    if (std::find(named.begin(), named.end(), name) == named.end()) continue;
    if (name.size() > columns::kLongestMarkerName)
      return refused("the name of marker '%1' is longer than %2 letters"_text(
                         name, columns::kLongestMarkerName),
                     "give it a shorter name in the system of the cameras"_text);
    recorded.push_back({i, name});
  }
  if (recorded.size() > ArmRig::kMostMarkers)
    return refused("a session records at most %1 markers, the rig names %2"_text(
                       ArmRig::kMostMarkers, recorded.size()),
                   "use a rig with fewer markers"_text);
  return recorded;
}

}  // namespace isograsp::session

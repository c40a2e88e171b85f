// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/posture_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "session/arm/arm_rig.hpp"
#include "virtual_patient/arm/reference_postures.hpp"

namespace isograsp::gui {

namespace {

namespace fs = std::filesystem;

std::optional<session::ArmRig> rig_with(const std::vector<std::string>& chain,
                                        const std::string& library) {
  std::vector<std::string> paths;
  std::error_code unreadable;
  for (const auto& file : fs::directory_iterator(fs::path(library) / "rigs", unreadable))
    if (file.path().extension() == ".toml") paths.push_back(file.path());
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths)
    if (auto rig = session::ArmRig::read(path, Hand::right); rig && rig->chain == chain)
      return *std::move(rig);
  return std::nullopt;
}

/// Of the first segment of the chain on an arm of average size; nothing: its markers are others.
std::optional<Pose> first_segment_W(const session::ArmRig& rig) {
  const auto body = virtual_patient::average_arm();
  const auto frames = virtual_patient::measured_frames(rig.rig, body, body.rest);
  if (!frames) return std::nullopt;
  const Pose& X_WE = (*frames)[*rig.rig.frame(rig.chain.front())];
  return is_missing(X_WE) ? std::nullopt : std::optional(X_WE);
}

FramePose seen_at(const Pose& X_W) {
  FramePose pose;
  pose.state = FrameState::ok;
  pose.X_W = X_W;
  return pose;
}

}  // namespace

PostureScene::PostureScene(const std::string& library, std::vector<std::string> chain)
    : chain_(std::move(chain)) {
  session::ArmSetup setup;
  if (const auto rig = rig_with(chain_, library)) {
    setup = session::setup_of(*rig, {});
    X_WE_ = first_segment_W(*rig).value_or(Pose{});
  }
  space_ = std::make_shared<ArmSpace>(setup, Hand::right);
}

std::vector<Pose> PostureScene::segments_W(const Posture& posture) const {
  std::vector<Pose> X_W{X_WE_};
  for (const Pose& X_L : posture.X_L) X_W.push_back(compose(X_W.back(), X_L));
  return X_W;
}

session::ArmSnapshot PostureScene::arm_in(const Postures& postures, std::size_t index) const {
  session::ArmSnapshot arm;
  arm.stage = session::Stage::trial;
  const auto X_W = segments_W(postures.postures[index]);
  // The object is the last of the chain, however many there are.
  for (std::size_t k = 0; k + 1 < std::min(X_W.size(), session::kArmChain.size()); ++k)
    arm.segments[index_of(session::kArmChain[k])] = seen_at(X_W[k]);
  arm.segments[index_of(ArmSegment::object)] = seen_at(X_W.back());
  const Pose X_WR = segments_W(postures.postures.front()).back();
  arm.start_p_WO = X_WR.p;
  arm.last_X_WO = X_W.back();
  auto& task = arm.special.special.emplace<tasks::ArmView>();
  task.reference_shown = index > 0;
  task.X_WR = X_WR;
  return arm;
}

PatientPicture PostureScene::picture_of(const Postures& postures, std::size_t index) const {
  const Pose X_WO = segments_W(postures.postures.front()).back();
  PatientPicture picture;
  picture.page = PatientPicture::Page::object;
  picture.in_space = true;
  picture.scene = space_->box();
  picture.object_shown = true;
  picture.X_WO = space_->box_at(X_WO, X_WO.p);
  picture.target_shown = index > 0;
  picture.X_WT = space_->box_at(segments_W(postures.postures[index]).back(), X_WO.p);
  return picture;
}

}  // namespace isograsp::gui

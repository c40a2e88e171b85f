// SPDX-License-Identifier: GPL-3.0-or-later
// An arm seen by markers as an apparatus: markers -> frames of a rig -> object -> task.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/latest.hpp"
#include "device/cameras/marker_device.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/arm/arm_rig.hpp"
#include "session/arm/arm_sight.hpp"
#include "session/arm/arm_snapshot.hpp"
#include "session/arm/arm_trial.hpp"
#include "session/arm/held_object.hpp"
#include "session/arm/picture_reader.hpp"
#include "session/arm/start_posture.hpp"

namespace isograsp::session {

class MarkerArm final : public Apparatus {
 public:
  static constexpr std::string_view kKind = "arm";

  /// `library` is a folder with postures/. `person` moves a simulated arm and watches the screen;
  /// null: nobody is simulated. The device shows what it does.
  MarkerArm(std::unique_ptr<MarkerDevice> device, ArmRig rig, std::string library,
            std::unique_ptr<MarkerSource> person = nullptr);

  [[nodiscard]] const MarkerDeviceInfo& device() const noexcept { return device_->info(); }
  Latest<ArmSnapshot>& snapshots() noexcept { return snapshots_; }  ///< acquisition -> owner
  [[nodiscard]] ArmSetup setup() const;  ///< once it is started; the owner's

  // The other functions of Apparatus are called through a pointer to it.
  [[nodiscard]] const ApparatusInfo& info() const noexcept override { return info_; }
  /// Errors also: the cameras know no marker of the rig.
  [[nodiscard]] Result<void> start(Clock& clock) override;
  void stop() noexcept override;

 private:
  [[nodiscard]] std::span<const PreparationStep> steps() const noexcept override;
  void describe(storage::SessionRecord& session) const override;
  [[nodiscard]] Result<void> ready() override { return {}; }
  [[nodiscard]] Result<std::unique_ptr<Preparation>> make_preparation(
      const ZeroRequest& request) override;
  /// Refused without a start posture, or with postures of another chain, or if the
  /// screening does not allow it.
  [[nodiscard]] Result<std::unique_ptr<TrialSetup>> make_trial(
      const tasks::TaskSpec& spec, const tasks::TaskContext& context) override;
  [[nodiscard]] const Moment& newest() noexcept override { return snapshots_.read(); }

  [[nodiscard]] bool next() noexcept override;
  [[nodiscard]] bool measure(Preparation& preparation) noexcept override;
  [[nodiscard]] Reception receive() noexcept override;
  void step() noexcept override;
  void write(const RowFrame& frame, TrialRow& row) noexcept override;
  void move() noexcept override {}
  void publish() noexcept override { snapshots_.publish(now_); }
  void show() noexcept override;

  void begin(Preparation& preparation) noexcept override;
  void begin(TrialSetup& trial) noexcept override;
  void end(TrialSetup& trial) noexcept override;

  [[nodiscard]] Moment& now() noexcept override { return now_; }
  [[nodiscard]] ApparatusFault fault() const noexcept override;
  [[nodiscard]] double lateness_s() const noexcept override;
  [[nodiscard]] std::optional<double> latency_s() const noexcept override;

  /// Errors: the task needs frames or markers that rig or cameras do not have.
  [[nodiscard]] Result<void> fits(const tasks::TaskSpec& spec) const;
  /// The running trial waits until the object is seen again.
  [[nodiscard]] bool sight_matters() const noexcept;
  /// Those that the task names, and the start posture of this arm; nothing: it names none. Errors:
  /// its own range is asked for and was not measured in this session.
  [[nodiscard]] Result<std::optional<tasks::ArmPostures>> postures(
      const tasks::TaskSpec& spec, const std::vector<OwnRange>& ranges) const;

  std::unique_ptr<MarkerSource> person_;
  std::unique_ptr<MarkerDevice> device_;  ///< shows the person
  ArmRig rig_;
  std::string library_;
  ApparatusInfo info_;
  const Clock* clock_ = nullptr;
  bool streaming_ = false;

  // Once it is started.
  std::optional<ArmSight> sight_;
  std::optional<PictureReader> pictures_;
  double last_picture_s_ = 0.0;
  double last_seen_s_ = 0.0;     ///< the object
  std::int64_t trial_rows_ = 0;  ///< of the running trial

  Latest<ArmSnapshot> snapshots_;
  ArmSnapshot now_;                        ///< the state that is published
  HeldObject held_;                        ///< in the running trial
  std::optional<StartPostureMean> start_;  ///< nothing: not measured yet
  ArmTrial* trial_ = nullptr;
};

}  // namespace isograsp::session

// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked hand as an apparatus: rows of a tracker -> one hand on the grid of the session -> its
// angles, and a virtual hand that grasps an object -> task.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/latest.hpp"
#include "device/hand/hand_device.hpp"
#include "hand/hand_source.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/tracked_hand/entry_capture.hpp"
#include "session/tracked_hand/hand_reader.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "session/tracked_hand/hand_trial.hpp"

namespace isograsp::session {

/// What is fixed of a session with a tracked hand.
struct HandSetup {
  Hand side = Hand::right;        ///< of the session: rows of the other label are not used
  virtual_hand::HandModel model;  ///< of usual size; axes and limits are those of every hand
  /// The hand cannot open: its size is that of the other one, mirrored (?size=other).
  bool size_of_other = false;
};

class TrackedHand final : public Apparatus {
 public:
  static constexpr std::string_view kKind = "tracked_hand";
  static constexpr double kPeriod_s = 0.01;  ///< of the frames, whatever the rate of the tracker

  /// `person` moves a simulated hand and watches the screen; null: nobody is simulated. The device
  /// shows what it does.
  TrackedHand(std::unique_ptr<HandDevice> device, HandSetup setup,
              std::unique_ptr<HandSource> person = nullptr);

  [[nodiscard]] const HandDeviceInfo& device() const noexcept { return device_->info(); }
  Latest<HandSnapshot>& snapshots() noexcept { return snapshots_; }  ///< acquisition -> owner
  [[nodiscard]] Hand side() const noexcept { return setup_.side; }
  /// The owner's, before the threads begin: the size of the other hand as it was stored last, and
  /// whether joints may be kept (consent to research stands). Errors: that size cannot be read.
  [[nodiscard]] Result<void> know_person(
      const std::optional<storage::PreparationRecord>& other_hand, bool keeps_joints);

  /// Begun in the sessions that are resumed. Before the first trial of this one.
  void set_placements(int begun) noexcept { placements_begun_ = begun; }

  // The other functions of Apparatus are called through a pointer to it.
  [[nodiscard]] const ApparatusInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Result<void> start(Clock& clock) override;
  void stop() noexcept override;

 private:
  [[nodiscard]] std::span<const PreparationStep> steps() const noexcept override;
  void describe(storage::SessionRecord& session) const override;
  [[nodiscard]] Result<void> ready() override { return {}; }
  [[nodiscard]] Result<std::unique_ptr<Preparation>> make_preparation(
      const ZeroRequest& request) override;
  /// Refused for a hand that the entry test bars, and for an object that is wider than it may be.
  [[nodiscard]] Result<std::unique_ptr<TrialSetup>> make_trial(
      const tasks::TaskSpec& spec, const tasks::TaskContext& context) override;
  [[nodiscard]] const Moment& newest() noexcept override { return snapshots_.read(); }

  [[nodiscard]] bool next() noexcept override;
  [[nodiscard]] bool measure(Preparation& preparation) noexcept override;
  [[nodiscard]] Reception receive() noexcept override;
  void step() noexcept override;
  void write(const RowFrame& frame, TrialRow& row) noexcept override;
  void move() noexcept override;
  void publish() noexcept override { snapshots_.publish(now_); }
  void show() noexcept override;

  void begin(Preparation& preparation) noexcept override;
  void begin(TrialSetup& trial) noexcept override;
  void end(TrialSetup& trial) noexcept override;
  [[nodiscard]] bool let_go() noexcept override;

  [[nodiscard]] Moment& now() noexcept override { return now_; }
  [[nodiscard]] ApparatusFault fault() const noexcept override;
  [[nodiscard]] double lateness_s() const noexcept override;
  /// Frames come by time.
  [[nodiscard]] std::optional<double> latency_s() const noexcept override { return std::nullopt; }

  /// From now on what is shown has that size.
  void show_hand_of(const virtual_hand::HandModel& model) noexcept;
  /// No trial, no object.
  void forget_grasp() noexcept;
  [[nodiscard]] bool is_live() const noexcept;
  /// Errors: the entry test has not been passed, or the object is too wide for the opening.
  [[nodiscard]] Result<void> fits(const tasks::TaskSpec& spec) const;

  std::unique_ptr<HandSource> person_;
  std::unique_ptr<HandDevice> device_;  ///< shows the person
  HandSetup setup_;
  ApparatusInfo info_;
  std::optional<virtual_hand::HandModel> other_hand_;  ///< its size, for this side
  bool keeps_joints_ = false;
  int placements_begun_ = 0;  ///< in this session and those that it resumes

  // Once it is started.
  const Clock* clock_ = nullptr;
  Timestamp start_{0};
  std::optional<HandReader> reader_;
  bool streaming_ = false;

  Latest<HandSnapshot> snapshots_;
  HandSnapshot now_;                     ///< the state that is published
  virtual_hand::HandModel shown_model_;  ///< whose angles are shown
  const EntryCapture* entry_ = nullptr;  ///< the newest that has ended
  HandTrial* trial_ = nullptr;
  bool let_go_ = false;      ///< asked for in this placement
  std::int64_t frames_ = 0;  ///< of the trial: those in which the hand was asked for …
  std::int64_t lost_ = 0;    ///< … and not seen
};

/// What decides how a hand is measured, beside its task: tracker, version of its service, mounting,
/// delay. Stored as the calibration of the session.
[[nodiscard]] std::string tracker_text(const HandDeviceInfo& device);
inline constexpr std::string_view kTrackerFormat = "isograsp-tracker-1";

}  // namespace isograsp::session

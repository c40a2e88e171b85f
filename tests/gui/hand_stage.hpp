// SPDX-License-Identifier: GPL-3.0-or-later
// A session's clockwork before a simulated tracker, in virtual time: frames of a tracked hand that
// does what the screen asks.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "device/hand/hand_device.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/library/library.hpp"
#include "session/tracked_hand/tracked_hand.hpp"
#include "tests/support/must.hpp"
#include "tests/support/scripted_hand.hpp"
#include "virtual_patient/hand/virtual_grasper.hpp"

namespace isograsp::gui::test {

/// Hides the hand of somebody from the tracker while it is asked to.
class HiddenHand final : public HandSource {
 public:
  explicit HiddenHand(std::unique_ptr<HandSource> of) : of_(std::move(of)) {}
  void see(const Stimulus& stimulus) noexcept override { of_->see(stimulus); }
  [[nodiscard]] HandFrame at(double t_s) noexcept override {
    HandFrame frame = of_->at(t_s);
    if (hidden) {
      frame.tracked = false;
      frame.joints.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
    return frame;
  }
  bool hidden = false;

 private:
  std::unique_ptr<HandSource> of_;
};

class HandStage {
 public:
  using Wanted = std::function<bool(const session::HandSnapshot&)>;

  /// A hand that the tracker sees without gaps, so that a state stands as long as it
  /// stands.
  explicit HandStage(Hand side = Hand::right) {
    using isograsp::test::must;
    const auto model = isograsp::test::usual_hand(side);
    auto traits = virtual_patient::grasp_traits("healthy");
    EXPECT_TRUE(traits.has_value());
    traits->lost_share = 0.0;
    auto person = std::make_unique<HiddenHand>(
        std::make_unique<virtual_patient::VirtualGrasper>(model, *traits, 1, side));
    person_ = person.get();
    auto device =
        must(open_hand_device(must(Uri::parse("sim://hand?user=healthy")), side, person_));
    hand_ = std::make_unique<session::TrackedHand>(
        std::move(device), session::HandSetup{side, model, false}, std::move(person));
    must(hand_->start(clock_));
    acquisition_.emplace(*hand_, clock_);
    run(0.1);
  }

  [[nodiscard]] const session::HandSnapshot& now() { return hand_->snapshots().read(); }
  void hide(bool hidden) { person_->hidden = hidden; }
  void run(double duration_s) {
    for (int k = 0; k < std::lround(duration_s / session::TrackedHand::kPeriod_s); ++k) tick();
  }
  /// Up to the first frame that is wanted; fails after a minute.
  void run_to(const Wanted& wanted) {
    constexpr double kLongest_s = 60.0;
    for (int k = 0; k < std::lround(kLongest_s / session::TrackedHand::kPeriod_s); ++k) {
      tick();
      if (wanted(now())) return;
    }
    FAIL() << "never seen";
  }
  void begin_entry() {
    preparation_ = isograsp::test::must(apparatus().make_preparation({}));
    EXPECT_TRUE(acquisition_->commands().push(
        {.kind = session::Command::Kind::prepare, .preparation = preparation_.get()}));
    run(0.02);
  }
  void pass_entry() {
    begin_entry();
    run_to([](const auto& now) { return now.stage == session::Stage::idle; });
    EXPECT_TRUE(preparation_->outcome().accepted);
  }
  void begin(const tasks::TaskSpec& spec) {
    trial_ = isograsp::test::must(apparatus().make_trial(spec, {}));
    EXPECT_TRUE(acquisition_->commands().push(
        {.kind = session::Command::Kind::begin, .setup = trial_.get()}));
    run(0.02);
  }
  /// The therapist's key.
  void let_go() {
    EXPECT_TRUE(acquisition_->commands().push({.kind = session::Command::Kind::let_go}));
  }
  /// Of the trial that has begun.
  [[nodiscard]] const virtual_hand::HandModel& hand() const {
    return static_cast<const session::HandTrial&>(*trial_).model;
  }
  /// A frame of the trial, and the row that was recorded of it.
  struct Kept {
    session::HandSnapshot shown;
    std::vector<double> row;
  };
  [[nodiscard]] const std::vector<Kept>& kept() const noexcept { return kept_; }
  /// Their rows, as they are stored.
  [[nodiscard]] Signals signals() const {
    std::vector<std::string> names;
    for (const auto& group : trial_->columns())
      names.insert(names.end(), group.columns.begin(), group.columns.end());
    Signals signals(std::move(names));
    for (const Kept& kept : kept_) signals.append_row(kept.row);
    return signals;
  }
  static tasks::TaskSpec task(const std::string& name) {
    return isograsp::test::must(
        session::load_task(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/" + name));
  }

 private:
  session::Apparatus& apparatus() { return *hand_; }
  void tick() {
    EXPECT_TRUE(acquisition_->tick());
    while (acquisition_->records().pop(item_)) {
      if (item_.kind != session::RecordItem::Kind::sample) continue;
      const auto values = item_.row.values();
      kept_.push_back({now(), {values.begin(), values.end()}});
    }
  }

  ManualClock clock_;
  HiddenHand* person_ = nullptr;
  std::unique_ptr<session::TrackedHand> hand_;
  std::unique_ptr<session::Preparation> preparation_;
  std::unique_ptr<session::TrialSetup> trial_;
  std::optional<session::Acquisition> acquisition_;
  session::RecordItem item_;
  std::vector<Kept> kept_;
};

}  // namespace isograsp::gui::test

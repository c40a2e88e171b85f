// SPDX-License-Identifier: GPL-3.0-or-later
// Two platforms for three fingers each, one for each hand, as one apparatus: one clock, one grid, a
// frame is there when both have theirs. What is missing of one is missing of both: a fault of
// either pauses the trial. Each platform has its zero and its health.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/latest.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/platform/platform_reader.hpp"
#include "session/two_platforms/carries_begun.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "session/two_platforms/two_platforms_trial.hpp"
#include "virtual_patient/pair/virtual_pair.hpp"

namespace isograsp::session {

class TwoPlatforms final : public Apparatus {
 public:
  static constexpr std::string_view kKind = "two_platforms";

  using Devices = OfHands<std::unique_ptr<ForceDevice>>;
  /// Refused where they cannot be one: other rates, delays of filters that differ, one of them a
  /// recording or simulated alone.
  [[nodiscard]] static Result<void> check(const Devices& devices);
  /// `pair` presses simulated devices and watches the screen; null: nobody is simulated.
  /// @pre check(devices)
  TwoPlatforms(Devices devices, std::unique_ptr<virtual_patient::VirtualPair> pair,
               std::optional<double> display_delay_s, std::string library = "");

  [[nodiscard]] const DeviceInfo& device(Hand hand) const noexcept { return sides_[hand].info(); }
  [[nodiscard]] std::optional<double> resolution_N(Hand hand) const noexcept {
    return sides_[hand].resolution_N();
  }
  /// Of the same devices in an earlier session. Before the first zeros of this one.
  void set_last_zeros(const OfHands<SixAxes>& mean) noexcept {
    for (const Hand hand : kBothHands) sides_[hand].set_last_zero(mean[hand]);
  }

  /// Of the session that is resumed. Before the first trial of this one.
  void set_carries(const CarriesBegun& carries) noexcept { carries_ = carries; }

  // The other functions of Apparatus are called through a pointer to it.
  [[nodiscard]] const ApparatusInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Result<void> start(Clock& clock) override;
  void stop() noexcept override;

 private:
  [[nodiscard]] Result<void> fits_session(const tasks::HandsCarry& carry,
                                          const tasks::TaskContext& context) const;

  [[nodiscard]] std::span<const PreparationStep> steps() const noexcept override;
  void describe(storage::SessionRecord& session) const override;
  /// An outdated zero of either is refused, as on one platform.
  [[nodiscard]] Result<void> ready() override;
  [[nodiscard]] Result<std::unique_ptr<Preparation>> make_preparation(
      const ZeroRequest& request) override;
  [[nodiscard]] Result<std::unique_ptr<TrialSetup>> make_trial(
      const tasks::TaskSpec& spec, const tasks::TaskContext& context) override;
  [[nodiscard]] const Moment& newest() noexcept override { return snapshots_.read(); }

  [[nodiscard]] bool next() noexcept override;
  [[nodiscard]] bool measure(Preparation& preparation) noexcept override;
  [[nodiscard]] Reception receive() noexcept override;
  void step() noexcept override;
  void write(const RowFrame& frame, TrialRow& row) noexcept override;
  void move() noexcept override;
  void publish() noexcept override;
  void show() noexcept override;

  void begin(Preparation& preparation) noexcept override;
  void begin(TrialSetup& trial) noexcept override;
  void end(TrialSetup& trial) noexcept override;

  [[nodiscard]] Moment& now() noexcept override { return now_; }
  [[nodiscard]] ApparatusFault fault() const noexcept override;
  [[nodiscard]] double lateness_s() const noexcept override;
  [[nodiscard]] std::optional<double> latency_s() const noexcept override;

  std::unique_ptr<virtual_patient::VirtualPair> pair_;
  OfHands<PlatformReader> sides_;  ///< are pressed by the pair
  std::optional<double> display_delay_s_;
  std::string library_;  ///< folder with scenes/
  ApparatusInfo info_;
  Latest<TwoPlatformsSnapshot> snapshots_;
  TwoPlatformsSnapshot now_;  ///< the state that is published
  CarriesBegun carries_;
  TwoPlatformsTrial* trial_ = nullptr;
};

}  // namespace isograsp::session

// SPDX-License-Identifier: GPL-3.0-or-later
// The platform for three fingers as an apparatus: forces -> zero -> wrench -> pose -> task.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/latest.hpp"
#include "core/time.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/platform/platform_reader.hpp"
#include "session/platform/platform_trial.hpp"
#include "session/platform/snapshot.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::session {

struct PlatformOptions {
  Hand hand = Hand::right;
  std::string library;                    ///< folder with scenes/
  std::optional<double> display_delay_s;  ///< of the patient's screen; nothing: not measured
};

class ForcePlatform final : public Apparatus {
 public:
  static constexpr std::string_view kKind = "platform";

  /// `person` presses a simulated device and watches the screen; null: nobody is simulated.
  explicit ForcePlatform(std::unique_ptr<ForceDevice> device,
                         std::unique_ptr<virtual_patient::VirtualPatient> person = nullptr,
                         PlatformOptions options = {});

  [[nodiscard]] const DeviceInfo& device() const noexcept { return platform_.info(); }
  /// Coarsest step of a force component; nothing: the device has no counts.
  [[nodiscard]] std::optional<double> resolution_N() const noexcept {
    return platform_.resolution_N();
  }
  /// Of the same device in an earlier session. Before the first zero of this one.
  void set_last_zero(const SixAxes& mean) noexcept { platform_.set_last_zero(mean); }
  Latest<Snapshot>& snapshots() noexcept { return snapshots_; }  ///< acquisition -> owner

  // The other functions of Apparatus are called through a pointer to it.
  [[nodiscard]] const ApparatusInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Result<void> start(Clock& clock) override;
  void stop() noexcept override { platform_.stop(); }

 private:
  [[nodiscard]] std::span<const PreparationStep> steps() const noexcept override;
  void describe(storage::SessionRecord& session) const override;
  /// An outdated zero would be subtracted from the forces of a sensor that it does not belong to.
  /// Whether a trial may begin without any zero is decided by the owner.
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
  [[nodiscard]] ApparatusFault fault() const noexcept override { return platform_.fault(); }
  [[nodiscard]] double lateness_s() const noexcept override {
    return platform_.lateness_s(now_.forces);
  }
  [[nodiscard]] std::optional<double> latency_s() const noexcept override;

  std::unique_ptr<virtual_patient::VirtualPatient> person_;
  PlatformReader platform_;  ///< is pressed by the person
  PlatformOptions options_;
  ApparatusInfo info_;
  Latest<Snapshot> snapshots_;

  Snapshot now_;  ///< the state that is published
  PlatformTrial* trial_ = nullptr;
};

}  // namespace isograsp::session

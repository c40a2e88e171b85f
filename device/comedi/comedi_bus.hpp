// SPDX-License-Identifier: GPL-3.0-or-later
// A JR3 PCI card as a bus: a question (device/codec/jr3_comedi_codec.hpp) is answered at once by
// reading the card; one that the card does not answer makes no frame.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "device/bus/bus.hpp"
#include "device/codec/jr3_comedi_codec.hpp"
#include "device/comedi/comedi_card.hpp"

namespace isograsp {

class ComediBus final : public Bus {
 public:
  explicit ComediBus(std::unique_ptr<ComediCard> card) noexcept : card_(std::move(card)) {}

  [[nodiscard]] Result<void> start(Clock& clock) override;
  /// Reads the card: six system calls for the samples of one sensor. The stamp of the answer is the
  /// time after them.
  bool send(const BusFrame& frame) noexcept override;
  [[nodiscard]] BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override;
  [[nodiscard]] BusCounters counters() const noexcept override { return counters_; }

 private:
  [[nodiscard]] std::optional<BusFrame> answer(std::uint32_t sensor,
                                               const Jr3ComediQuestion& question) noexcept;
  [[nodiscard]] std::optional<BusFrame> read_samples(std::uint32_t sensor,
                                                     const Jr3ComediQuestion& question) noexcept;
  [[nodiscard]] std::optional<BusFrame> read_identity(std::uint32_t sensor,
                                                      const Jr3ComediQuestion& question) noexcept;

  std::unique_ptr<ComediCard> card_;
  Clock* clock_ = nullptr;
  BusCounters counters_;
  std::array<ReceivedFrame, 8> answers_;  ///< one question of each sensor at a time
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

/// Opens the card and makes sure that these subdevices are JR3 sensors. Errors name the file.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_comedi_bus(const std::string& path,
                                                           std::span<const unsigned> subdevices);
/// The same with a card that is open already; `path` is for people.
[[nodiscard]] Result<std::unique_ptr<Bus>> make_comedi_bus(std::unique_ptr<ComediCard> card,
                                                           std::span<const unsigned> subdevices,
                                                           const std::string& path);

}  // namespace isograsp

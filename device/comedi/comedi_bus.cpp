// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/comedi/comedi_bus.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace isograsp {

Result<void> ComediBus::start(Clock& clock) {
  clock_ = &clock;
  count_ = 0;
  return {};
}

bool ComediBus::send(const BusFrame& frame) noexcept {
  const auto question = jr3_comedi_question(frame);
  if (!question || clock_ == nullptr) return false;
  const auto content = answer(frame.id, *question);
  if (!content) return true;  // sent, but without an answer
  if (count_ == answers_.size()) {
    ++counters_.kernel_drops;
    return true;
  }
  ReceivedFrame& out = answers_[(first_ + count_) % answers_.size()];
  out.frame = *content;
  out.stamp = clock_->now();
  out.wall_time = clock_->is_virtual()
                      ? out.stamp
                      : Timestamp(std::chrono::system_clock::now().time_since_epoch());
  ++count_;
  return true;
}

std::optional<BusFrame> ComediBus::answer(std::uint32_t sensor,
                                          const Jr3ComediQuestion& question) noexcept {
  return question.kind == Jr3ComediQuestion::Kind::samples ? read_samples(sensor, question)
                                                           : read_identity(sensor, question);
}

std::optional<BusFrame> ComediBus::read_samples(std::uint32_t sensor,
                                                const Jr3ComediQuestion& question) noexcept {
  Jr3ComediSamples samples{};
  for (unsigned axis = 0; axis < samples.size(); ++axis) {
    std::uint32_t sample = 0;
    const unsigned channel = jr3_comedi_channel(question.filter, axis);
    if (card_->read(question.subdevice, channel, sample) != ComediCard::Reading::good)
      return std::nullopt;
    samples[axis] = static_cast<std::uint16_t>(std::min(sample, kJr3HighestSample));
  }
  return jr3_comedi_frame(sensor, samples);
}

std::optional<BusFrame> ComediBus::read_identity(std::uint32_t sensor,
                                                 const Jr3ComediQuestion& question) noexcept {
  Jr3ComediIdentity identity;
  // Ranges are valid only after the driver has talked to the sensor, and libcomedi keeps those of
  // the moment at which it opened the card: so it is opened again.
  if (card_->read(question.subdevice, kJr3SerialChannel, identity.serial_number) !=
          ComediCard::Reading::good ||
      !card_->reopen())
    return std::nullopt;
  for (unsigned axis = 0; axis < 6; ++axis) {
    const auto range = card_->range(question.subdevice, jr3_comedi_channel(question.filter, axis));
    if (!range) return std::nullopt;
    identity.full_scale[static_cast<Eigen::Index>(axis)] = jr3_comedi_full_scale(range->most);
  }
  return jr3_comedi_frame(sensor, identity);
}

BusEvent ComediBus::receive(Timestamp deadline, ReceivedFrame& out) noexcept {
  if (count_ > 0) {
    out = answers_[first_];
    first_ = (first_ + 1) % answers_.size();
    --count_;
    return BusEvent::frame;
  }
  clock_->wait_until(deadline);
  return BusEvent::timeout;
}

Result<std::unique_ptr<Bus>> make_comedi_bus(std::unique_ptr<ComediCard> card,
                                             std::span<const unsigned> subdevices,
                                             const std::string& path) {
  for (const unsigned subdevice : subdevices) {
    if (subdevice >= card->subdevices())
      return failed("the card has no subdevice %1"_text(subdevice),
                    "correct subdevice in the configuration: the first sensor is 0"_text)
          .at(path);
    if (card->channels(subdevice) != kJr3ComediChannels ||
        card->highest_sample(subdevice, 0) != kJr3HighestSample)
      return failed("subdevice %1 is no JR3 sensor"_text(subdevice),
                    "name the card that the driver jr3_pci serves"_text)
          .at(path);
  }
  return std::unique_ptr<Bus>(std::make_unique<ComediBus>(std::move(card)));
}

Result<std::unique_ptr<Bus>> open_comedi_bus(const std::string& path,
                                             std::span<const unsigned> subdevices) {
  auto card = open_comedi_card(path);
  if (!card) return card.error();
  return make_comedi_bus(*std::move(card), subdevices, path);
}

}  // namespace isograsp

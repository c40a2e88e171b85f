// SPDX-License-Identifier: GPL-3.0-or-later
// What this program needs of a measuring card that comedi drives. The real one calls libcomedi;
// tests have one of their own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/result.hpp"

namespace isograsp {

class ComediCard {
 public:
  enum class Reading : std::uint8_t {
    good,
    not_ready,  ///< EAGAIN: the driver has no sensor that it trusts
    failed
  };
  /// Physical values of the lowest and the highest sample, in comedi's own scale.
  struct Range {
    double least = 0.0;
    double most = 0.0;
  };

  virtual ~ComediCard() = default;
  /// One sample of one channel, now. One system call.
  [[nodiscard]] virtual Reading read(unsigned subdevice, unsigned channel,
                                     std::uint32_t& sample) noexcept = 0;
  [[nodiscard]] virtual unsigned subdevices() noexcept = 0;
  [[nodiscard]] virtual unsigned channels(unsigned subdevice) noexcept = 0;
  [[nodiscard]] virtual std::uint32_t highest_sample(unsigned subdevice,
                                                     unsigned channel) noexcept = 0;
  /// As it was when the card was opened.
  [[nodiscard]] virtual std::optional<Range> range(unsigned subdevice,
                                                   unsigned channel) noexcept = 0;
  /// Closes and opens it, so that ranges are those of now. False: it is gone.
  [[nodiscard]] virtual bool reopen() noexcept = 0;
};

/// "/dev/comedi0". Errors name the file, or say that this program was built without libcomedi.
[[nodiscard]] Result<std::unique_ptr<ComediCard>> open_comedi_card(const std::string& path);

}  // namespace isograsp

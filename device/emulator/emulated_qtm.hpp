// SPDX-License-Identifier: GPL-3.0-or-later
// Qualisys Track Manager in software, as a client of its real-time stream sees it: bytes in, bytes
// out. No socket and no clock.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device/emulator/marker_play.hpp"

namespace isograsp {

/// One client.
class EmulatedQtmClient {
 public:
  /// What it is greeted with.
  [[nodiscard]] static std::vector<std::uint8_t> greeting();
  /// Takes what the client sends and answers; commands may come in pieces. Nothing: it speaks
  /// another language, and the connection should be closed.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> answer(
      std::span<const std::uint8_t> bytes, const std::vector<std::string>& labels, double rate_Hz);
  /// It has asked for frames.
  [[nodiscard]] bool streaming() const noexcept { return streaming_; }
  /// A picture as a packet for this client.
  [[nodiscard]] std::vector<std::uint8_t> frame(const MarkerPicture& picture) const;

 private:
  [[nodiscard]] std::vector<std::uint8_t> command(std::string_view text,
                                                  const std::vector<std::string>& labels,
                                                  double rate_Hz);

  std::vector<std::uint8_t> waiting_;
  bool streaming_ = false;
  bool with_residual_ = false;
};

}  // namespace isograsp

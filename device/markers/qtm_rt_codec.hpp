// SPDX-License-Identifier: GPL-3.0-or-later
// The real-time stream of Qualisys Track Manager (RT protocol 1.x, little endian): bytes of a TCP
// connection in, as they come, rows of markers out. Pure: no socket and no clock.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

/// What the stream has held so far; counters never decrease.
struct QtmRtCounts {
  std::uint64_t packets = 0;
  std::uint64_t frames = 0;       ///< rows given
  std::uint64_t repeated = 0;     ///< frames whose number is not above that of the last one
  std::uint64_t unlabelled = 0;   ///< frames of markers before their labels, or of another number
  std::uint64_t passed_over = 0;  ///< packets and components of other kinds
};

class QtmRtStream {
 public:
  /// No packet is larger: such a size means that the boundaries of the packets are lost.
  static constexpr std::size_t kLargestPacket = std::size_t{16} << 20;

  struct Row {
    std::int64_t stamp_us = 0;  ///< of the cameras
    std::uint32_t frame = 0;
    std::span<const Vec3> p_W;  ///< [m]; not seen: NaN. Until the next call
  };

  /// Takes bytes; calls `row` for each frame of markers that they complete. An error ends the
  /// stream: no packet begins where one should, broken XML, or other labels than before.
  [[nodiscard]] Result<void> take(std::span<const std::uint8_t> bytes,
                                  const std::function<void(const Row&)>& row);

  /// Empty until the server has told them.
  [[nodiscard]] const std::vector<std::string>& labels() const noexcept { return labels_; }
  [[nodiscard]] const QtmRtCounts& counts() const noexcept { return counts_; }

 private:
  [[nodiscard]] Result<void> packet(std::span<const std::uint8_t> bytes,
                                    const std::function<void(const Row&)>& row);
  [[nodiscard]] Result<void> parameters(std::span<const std::uint8_t> xml);
  void data(std::span<const std::uint8_t> bytes, const std::function<void(const Row&)>& row);
  /// One component 3D or 3D with residuals; false: not as many markers as labels, or cut off.
  [[nodiscard]] bool markers(std::span<const std::uint8_t> component, std::size_t floats);

  std::vector<std::uint8_t> waiting_;  ///< of a packet that is not complete
  std::vector<std::string> labels_;
  std::vector<Vec3> p_W_;
  std::optional<std::uint32_t> last_frame_;
  QtmRtCounts counts_;
};

}  // namespace isograsp

// SPDX-License-Identifier: GPL-3.0-or-later
// The real-time stream of Qualisys Track Manager (RT protocol 1.x, little endian): bytes of a TCP
// connection in, as they come, rows of markers and what else QTM says out. Pure: no socket and no
// clock.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

/// What the stream has held so far; counters never decrease.
struct QtmRtCounts {
  std::uint64_t packets = 0;
  std::uint64_t frames = 0;  ///< rows that take() gave
  std::uint64_t repeated =
      0;  ///< frames that take() left out: their number is not above the last one's
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
  /// What the next packet was.
  enum class Step : std::uint8_t {
    more,          ///< there is none until more bytes come
    row,           ///< a frame of markers
    message,       ///< an answer to a command: message()
    refusal,       ///< a command was refused: message() says why
    labels,        ///< QTM has told its parameters with labels, those that it told before
    other_labels,  ///< with others: no rows until the first ones are told again
    no_labels,     ///< parameters without labels
    lost           ///< no packet begins where one should, or broken XML: problem(); for ever
  };

  /// Takes bytes as they came. Allocates nothing once labels are known, unless a packet is larger
  /// than any before.
  void add(std::span<const std::uint8_t> bytes);
  /// The next packet that means something. A row, a message and problem() stand until the next
  /// call. Rows whose number is not above that of the last one are given, too. Real-time safe for
  /// rows and for parameters that are the same bytes as before.
  [[nodiscard]] Step next(Row& row) noexcept;
  [[nodiscard]] std::string_view message() const noexcept { return message_; }
  /// Why the stream is lost.
  [[nodiscard]] Error problem() const;
  /// For a new connection to the same system: forgets what waits, keeps the labels. Real-time safe.
  void restart() noexcept;

  /// add() and next() in one, for a stream that is a file: calls `row` for each frame whose number
  /// is above that of the last one. An error ends the stream: lost, or other labels than before.
  template <class OnRow>
  [[nodiscard]] Result<void> take(std::span<const std::uint8_t> bytes, OnRow&& row) {
    add(bytes);
    Row one;
    for (;;) switch (next(one)) {
        case Step::more: return {};
        case Step::row:
          if (is_new(one.frame)) row(one);
          break;
        case Step::message:
        case Step::refusal: ++counts_.passed_over; break;
        case Step::labels:
        case Step::no_labels: break;
        case Step::other_labels:
        case Step::lost: return problem();
      }
  }

  /// Empty until the server has told them.
  [[nodiscard]] const std::vector<std::string>& labels() const noexcept { return labels_; }
  /// Pictures a second, if the parameters tell it.
  [[nodiscard]] std::optional<double> rate_Hz() const noexcept { return rate_Hz_; }
  [[nodiscard]] const QtmRtCounts& counts() const noexcept { return counts_; }

 private:
  enum class Trouble : std::uint8_t { none, boundary, xml, labels };

  [[nodiscard]] std::optional<Step> packet(std::span<const std::uint8_t> bytes, Row& row);
  [[nodiscard]] Step parameters(std::span<const std::uint8_t> xml);
  [[nodiscard]] bool data(std::span<const std::uint8_t> bytes, Row& row) noexcept;
  /// One component 3D or 3D with residuals; false: not as many markers as labels, or cut off.
  [[nodiscard]] bool markers(std::span<const std::uint8_t> component, std::size_t floats) noexcept;
  [[nodiscard]] bool is_new(std::uint32_t frame) noexcept;
  Step lose(Trouble trouble) noexcept;

  std::vector<std::uint8_t> waiting_;  ///< from `at_` on: of packets that were not looked at
  std::size_t at_ = 0;
  std::vector<std::string> labels_;
  std::vector<std::uint8_t> told_;  ///< the parameters that told the labels
  bool foreign_ = false;            ///< the newest parameters have other labels
  std::optional<double> rate_Hz_;
  std::vector<Vec3> p_W_;
  std::string_view message_;
  std::optional<std::uint32_t> last_frame_;
  QtmRtCounts counts_;
  Trouble trouble_ = Trouble::none;
  std::size_t wrong_size_ = 0;
  std::string xml_problem_;
};

/// A command of a client as a packet, e.g. "StreamFrames AllFrames 3DRes". Returns how many bytes
/// were written. @pre out.size() >= 9 + command.size()
std::size_t encode_qtm_rt_command(std::string_view command, std::span<std::uint8_t> out) noexcept;

}  // namespace isograsp

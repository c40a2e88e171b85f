// SPDX-License-Identifier: GPL-3.0-or-later
// The NatNet stream of Motive (OptiTrack), versions 2.5 to 4.1: datagrams in, rows of markers out.
// Pure: no socket and no clock. Lists are believed as far as the bytes of the datagram reach, never
// their counts.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "device/markers/natnet_models.hpp"

namespace isograsp {

/// What the stream has held so far; counters never decrease.
struct NatNetCounts {
  std::uint64_t datagrams = 0;
  std::uint64_t frames = 0;       ///< rows given
  std::uint64_t unlabelled = 0;   ///< frames before the server or its labels, or of other markers
  std::uint64_t passed_over = 0;  ///< messages of other kinds
  std::uint64_t damaged = 0;      ///< cut off, or not what its version says
};

class NatNetStream {
 public:
  struct Row {
    std::int32_t frame = 0;
    double stamp_s = 0.0;         ///< of the cameras' computer
    bool models_changed = false;  ///< labels should be asked for again
    std::span<const Vec3> p_W;    ///< [m]; not seen: NaN. Until the next call
  };
  /// What a datagram was.
  enum class Step : std::uint8_t {
    nothing,          ///< it is counted
    server,           ///< the server says who it is: version()
    unknown_version,  ///< the server speaks one whose layout is not known: version()
    labels,           ///< it has told its models with labels, those that it told before
    other_labels,     ///< with others: no rows until the first ones are told again
    rate,             ///< it has told rate_Hz()
    row               ///< a frame of markers
  };

  /// Takes one datagram. Real-time safe for rows and for models that are the same bytes as before.
  [[nodiscard]] Step take(std::span<const std::uint8_t> datagram, Row& row) noexcept;
  /// For a new conversation with the same system: keeps the labels. Real-time safe.
  void restart() noexcept;

  /// Nothing until the server has told it.
  [[nodiscard]] std::optional<NatNetVersion> version() const noexcept { return version_; }
  /// Where frames are sent, if the server tells it (from 3.0 on).
  [[nodiscard]] std::optional<std::uint16_t> data_port() const noexcept { return data_port_; }
  [[nodiscard]] std::optional<std::uint32_t> multicast() const noexcept { return multicast_; }
  [[nodiscard]] std::optional<double> rate_Hz() const noexcept { return rate_Hz_; }
  [[nodiscard]] const std::vector<std::string>& labels() const noexcept { return models_.labels; }
  [[nodiscard]] const NatNetCounts& counts() const noexcept { return counts_; }

 private:
  [[nodiscard]] Step message(std::uint16_t kind, std::span<const std::uint8_t> body, Row& row);
  [[nodiscard]] Step server(std::span<const std::uint8_t> body) noexcept;
  [[nodiscard]] Step models(std::span<const std::uint8_t> body);
  [[nodiscard]] Step response(std::span<const std::uint8_t> body) noexcept;
  [[nodiscard]] Step frame(std::span<const std::uint8_t> body, Row& row) noexcept;
  struct FrameReader;

  std::optional<NatNetVersion> version_;
  std::optional<std::uint16_t> data_port_;
  std::optional<std::uint32_t> multicast_;
  std::optional<double> rate_Hz_;
  NatNetModels models_;
  std::vector<std::uint8_t> told_;  ///< the message that told the models
  bool foreign_ = false;            ///< the newest models have other labels
  std::vector<Vec3> p_W_;
  NatNetCounts counts_;
};

/// A request of a client; `text` may be empty. Returns how many bytes were written.
/// @pre out.size() >= kLongestNatNetRequest, text.size() < 256
std::size_t encode_natnet_request(std::uint16_t kind, std::string_view text,
                                  std::span<std::uint8_t> out) noexcept;
inline constexpr std::size_t kLongestNatNetRequest = 4 + 270;

}  // namespace isograsp

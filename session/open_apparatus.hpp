// SPDX-License-Identifier: GPL-3.0-or-later
// Which apparatus a device URI names.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "device/config/uri.hpp"
#include "hand/finger.hpp"
#include "session/acquisition/apparatus.hpp"

namespace isograsp::session {

struct ApparatusRequest {
  Uri uri;
  Hand hand = Hand::right;                ///< that is measured; of two platforms no matter
  std::string library;                    ///< folder with scenes/, tasks/ and patients/
  std::optional<double> display_delay_s;  ///< of the patient's screen; nothing: not measured
};

/// One row of the table: the first that fits a URI opens it.
struct ApparatusRow {
  std::string_view scheme;     ///< empty: any
  std::string_view target;     ///< "arm" of sim://arm; empty: any
  std::string_view parameter;  ///< that it must have: "rig" of replay://FILE?rig=; empty: none
  Result<std::unique_ptr<Apparatus>> (*open)(const ApparatusRequest& request) = nullptr;
  std::string_view kind = {};  ///< ApparatusInfo::kind of what it opens; empty: not known before
  bool (*fits)(const Uri& uri) = nullptr;  ///< looks at what the URI names; null: no need
};
/// The table: every apparatus that this program knows; the last row takes all that is left.
[[nodiscard]] std::span<const ApparatusRow> all_apparatuses() noexcept;

/// The URI of one device; of two platforms (open_two_platforms.hpp) scheme and text alone.
[[nodiscard]] Result<Uri> parse_address(const std::string& text);

/// @pre one of the rows fits; what it refuses is refused.
[[nodiscard]] Result<std::unique_ptr<Apparatus>> open_apparatus(
    const ApparatusRequest& request, std::span<const ApparatusRow> rows = all_apparatuses());

/// The kind of apparatus that a URI names, before it is opened: by it tasks and protocols are
/// chosen. Empty: not known before, or no URI.
[[nodiscard]] std::string_view kind_of_apparatus(
    const std::string& uri, std::span<const ApparatusRow> rows = all_apparatuses());

/// Refuses a device that is mounted for the other hand, in words for the therapist.
[[nodiscard]] Result<void> check_hand(const std::string& device_uri, std::string_view mounted_for,
                                      Hand hand);

}  // namespace isograsp::session

// SPDX-License-Identifier: GPL-3.0-or-later
// Where a Net F/T box or Ethernet Axia is reached, and what it says about itself on its page
// netftapi2.xml.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "device/bus/endpoint.hpp"
#include "device/codec/net_ft_codec.hpp"

namespace isograsp {

/// Where a box is reached.
struct NetFtAddress {
  Endpoint records;  ///< UDP
  Endpoint pages;    ///< HTTP

  /// "192.168.1.1", "192.168.1.1:49152" or, with the port of its pages, "127.0.0.1:49152:8080".
  [[nodiscard]] static std::optional<NetFtAddress> parse(std::string_view text) noexcept;
};

struct NetFtBoxConfig {
  /// Axia if the product's name says so; every other name, or none, is read as a Net box.
  NetFtProduct product = NetFtProduct::net_box;
  std::string product_name;       ///< prodname; empty: the page does not tell
  std::string serial_number;      ///< cfgcalsn, of the transducer's calibration: "FT27462"
  NetFtScale scale;               ///< cfgcpf, cfgcpt, scfgfu, scfgtu
  std::optional<double> rate_Hz;  ///< comrdtrate, of the records; nothing: the page does not tell
  /// setuserfilter of a Net box [Hz]; 0: no filter; nothing: the page gives it in a form that is
  /// not known here (Axia).
  std::optional<double> filter_Hz;
  /// cfgtfx is not zero: the box shifts or turns the wrench before it sends it.
  bool transformed = false;
  std::optional<Vec6> range;  ///< cfgmr, rating of the calibration [N, N m]

  /// Of the page's text. `where` is what errors name as file.
  [[nodiscard]] static Result<NetFtBoxConfig> parse(std::string_view xml, const std::string& where);
};

/// The page of a box with this configuration, with the elements that parse() reads; units N and Nm
/// only. For emulated boxes.
[[nodiscard]] std::string encode_net_ft_page(const NetFtBoxConfig& config);

/// One unit [N]: "N", "kN", "lbf", "klbf", "kgf", "gf"; nullopt for any other name.
[[nodiscard]] std::optional<double> net_ft_force_unit_N(std::string_view name) noexcept;
/// One unit [N m]: "Nm", "Nmm", "kNm", "lbf-in", "lbf-ft", "kgf-cm", also "N-m" and the like.
[[nodiscard]] std::optional<double> net_ft_torque_unit_Nm(std::string_view name) noexcept;

}  // namespace isograsp

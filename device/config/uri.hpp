// SPDX-License-Identifier: GPL-3.0-or-later
// scheme://target?key=value&key=value
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp {

struct Uri {
  std::string text;
  std::string scheme;
  std::string target;  ///< between "://" and "?"; percent-escapes decoded
  std::map<std::string, std::string> parameters;

  [[nodiscard]] static Result<Uri> parse(std::string_view text);
  /// Fails, naming it, on a parameter that is not in `known`.
  [[nodiscard]] Result<void> require_known(std::initializer_list<std::string_view> known) const;
  [[nodiscard]] std::string text_or(const std::string& key, std::string fallback) const;
  /// A finite number within [least, most].
  [[nodiscard]] Result<double> number_or(const std::string& key, double fallback, double least,
                                         double most) const;
};

}  // namespace isograsp

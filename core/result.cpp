// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result.hpp"

#include "core/printable.hpp"

namespace isograsp {

std::string Error::message() const {
  std::string text;
  if (!file.empty()) {
    text += file;
    if (line > 0) text += ":" + std::to_string(line);
    text += ": ";
  }
  if (!field.empty()) text += field + ": ";
  text += what;
  if (!remedy.empty()) text += "; " + remedy;
  return printable(text);
}

}  // namespace isograsp

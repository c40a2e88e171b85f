// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result.hpp"

#include <utility>

#include "core/printable.hpp"

namespace isograsp {

Error refused(std::string what, std::string remedy) {
  return {Error::Code::bad_input, std::move(what), std::move(remedy)};
}

Error failed(std::string what, std::string remedy) {
  return {Error::Code::failed, std::move(what), std::move(remedy)};
}

Error Error::at(std::string in_file, std::optional<int> in_line, std::string in_field) && {
  file = std::move(in_file);
  line = in_line;
  field = std::move(in_field);
  return std::move(*this);
}

Error Error::about(std::string in_field) && {
  field = std::move(in_field);
  return std::move(*this);
}

std::string Error::message() const {
  std::string text;
  if (!file.empty()) {
    text += file;
    if (line) text += ":" + std::to_string(*line);
    text += ": ";
  }
  if (!field.empty()) text += field + ": ";
  text += what;
  if (!remedy.empty()) text += "; " + remedy;
  return printable(text);
}

}  // namespace isograsp

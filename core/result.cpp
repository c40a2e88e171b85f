// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result.hpp"

#include <utility>

#include "core/printable.hpp"

namespace isograsp {

Error refused(Text what, Text remedy) {
  return {Error::Code::bad_input, std::move(what), std::move(remedy)};
}

Error failed(Text what, Text remedy) {
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
  return translated(*this, Language());
}

Text words_of(const Error& error) {
  std::string place;
  if (!error.file.empty()) {
    place += error.file;
    if (error.line) place += ":" + std::to_string(*error.line);
    place += ": ";
  }
  if (!error.field.empty()) place += error.field + ": ";
  if (error.remedy.empty()) return "%1%2"_text(place, error.what);
  return "%1%2; %3"_text(place, error.what, error.remedy);
}

std::string translated(const Error& error, const Language& language) {
  return printable(translated(words_of(error), language));
}

}  // namespace isograsp

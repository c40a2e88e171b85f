// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/sealed_text.hpp"

namespace isograsp::storage {

std::string place_of(const LoginState& state, const char* column, const std::string& code) {
  std::string place = state.database_id() + "\n" + column + "\n";
  for (const char c : code) place += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return place;
}

Result<void> seal_text(const LoginState& state, std::string& text, const char* column,
                       const std::string& code) {
  if (!state.is_protected() || text.empty()) return {};
  const Login login = state.login();
  if (!login.keys || login.keys->text.empty() || text == kWithheld)
    return refusal_of(state, Right::read_texts, "");
  text = seal(login.keys->text, place_of(state, column, code), text);
  return {};
}

Result<void> open_text(const LoginState& state, std::string& text, const char* column,
                       const std::string& code, const std::string& path) {
  if (!state.is_protected() || text.empty()) return {};
  const Login login = state.login();
  if (!login.user || !login.keys || login.locked) return refusal_of(state, Right::read_texts, path);
  if (!may(login.user->role, Right::read_texts) || login.keys->text.empty()) {
    text = kWithheld;
    return {};
  }
  const auto opened = unseal(login.keys->text, place_of(state, column, code), text);
  if (!opened)
    return failed("%1 of %2 was changed or is damaged"_text(column, code),
                  "restore the last backup"_text)
        .at(path);
  text = opened->text();
  return {};
}

}  // namespace isograsp::storage

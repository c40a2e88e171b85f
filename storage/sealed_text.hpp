// SPDX-License-Identifier: GPL-3.0-or-later
// Free text in its column, bound to the column and to the person. Internal to this folder.
#pragma once

#include <string>

#include "storage/login.hpp"

namespace isograsp {

// In place; nothing is done where the database is not protected, or to an empty text.
[[nodiscard]] Result<void> seal_text(const LoginState& state, std::string& text, const char* column,
                                     const std::string& code);
/// For a role that may not read it the text becomes kWithheld. Errors: locked; changed or damaged.
[[nodiscard]] Result<void> open_text(const LoginState& state, std::string& text, const char* column,
                                     const std::string& code, const std::string& path);
/// What a sealed text of a person is bound to. Capitals of codes do not matter.
[[nodiscard]] std::string place_of(const LoginState& state, const char* column,
                                   const std::string& code);

}  // namespace isograsp

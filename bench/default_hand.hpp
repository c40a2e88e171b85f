// SPDX-License-Identifier: GPL-3.0-or-later
// The hand of the library, for the programs here that move one.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/files.hpp"
#include "virtual_hand/hand_model.hpp"

namespace isograsp::bench {

/// Ends the program where it cannot be read.
inline virtual_hand::HandModel default_hand() {
  const std::string file = std::string(ISOGRASP_SOURCE_DIR) + "/library/hands/default.toml";
  const auto text = read_text(file);
  const auto hand =
      text ? virtual_hand::parse_hand(*text, file) : Result<virtual_hand::HandModel>(text.error());
  if (!hand) {
    std::fprintf(stderr, "%s\n", hand.error().message().c_str());
    std::exit(1);
  }
  return *hand;
}

}  // namespace isograsp::bench

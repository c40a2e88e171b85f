// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/crypto/sodium_start.hpp"

#include <stdexcept>

#include <sodium.h>

namespace isograsp::storage {

void start_sodium() {
  if (sodium_init() < 0) throw std::runtime_error("libsodium does not start");
}

}  // namespace isograsp::storage

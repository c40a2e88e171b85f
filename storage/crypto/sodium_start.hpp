// SPDX-License-Identifier: GPL-3.0-or-later
// libsodium has to be initialised. Inside storage/ only.
#pragma once

namespace isograsp::storage {

/// Call before anything of libsodium is used. Thread-safe, and quick after the first time. Throws
/// on a system without random bytes.
void start_sodium();

}  // namespace isograsp::storage

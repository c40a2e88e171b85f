// SPDX-License-Identifier: GPL-3.0-or-later
// Files that appear whole or not at all.
#pragma once

#include <QByteArray>
#include <string>

#include "core/result.hpp"

namespace isograsp {

/// Temporary file beside `path`, then renamed; an older file stays if anything fails.
[[nodiscard]] Result<void> write_whole_file(const std::string& path, const QByteArray& bytes);

}  // namespace isograsp

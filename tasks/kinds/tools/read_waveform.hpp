// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: the keys of a target over time.
#pragma once

#include "tasks/read_keys.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

/// Problems are reported to the reader.
Waveform read_waveform(TomlReader& reader, double duration_s);

}  // namespace isograsp::tasks

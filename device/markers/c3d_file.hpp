// SPDX-License-Identifier: GPL-3.0-or-later
// A C3D file as a recording of markers, frame by frame, in memory that does not depend on its
// length.
#pragma once

#include <memory>
#include <string>

#include "device/markers/marker_reader.hpp"

namespace isograsp {

/// Times are k / rate. Errors: no C3D file, another processor, a file that ends within its data.
[[nodiscard]] Result<std::unique_ptr<MarkerReader>> open_c3d(const std::string& path);

}  // namespace isograsp

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/log_decoder.hpp"

namespace isograsp {

Error empty_log(const std::string& path, const char* example) {
  return refused("holds no frame"_text, "give a log with lines like %1"_text(example)).at(path);
}

}  // namespace isograsp

// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the place of libcomedi.cpp where the library is not installed.
#include "device/comedi/comedi_card.hpp"

namespace isograsp {

Result<std::unique_ptr<ComediCard>> open_comedi_card(const std::string& path) {
  return failed("this program was built without libcomedi"_text,
                "install libcomedi-dev and build it again"_text)
      .at(path);
}

}  // namespace isograsp

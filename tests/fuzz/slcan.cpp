// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a serial CAN adapter: frames come back, and no line is longer than the protocol has.
#include "device/emulator/slcan_codec.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SlcanLines lines;
  for (const char c : fuzz::as_text(data, size)) {
    const auto line = lines.take(c);
    if (!line) continue;
    const auto command = parse_slcan(*line);
    fuzz::require(!format_slcan_answer(command).view().empty(), "every line is answered");
    if (!command || command->kind != SlcanCommand::Kind::frame) continue;
    const SlcanText text = format_slcan(command->frame);
    const auto written = text.view();
    fuzz::require(written.ends_with('\r') && written.size() == line->size() + 1,
                  "a frame has one spelling, apart from case");
    const auto again = parse_slcan(written.substr(0, written.size() - 1));
    fuzz::require(again && again->frame == command->frame, "a frame comes back");
  }
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The little frames between a JR3 card and its session: what is understood is said the same way.
#include "device/codec/jr3_comedi_codec.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  BusFrame frame;
  frame.id = 1;
  const auto bytes = in.bytes(frame.data.size());
  frame.length = static_cast<std::uint8_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), frame.data.begin());
  if (const auto question = jr3_comedi_question(frame))
    fuzz::require(jr3_comedi_frame(1, *question) == frame, "a question is its frame");
  if (const auto samples = jr3_comedi_samples(frame)) {
    fuzz::require(jr3_comedi_frame(1, *samples) == frame, "samples are their frame");
    const Wrench wrench = wrench_of(*samples, Vec6::Constant(300.0));
    fuzz::require(wrench.force.allFinite() && wrench.torque.allFinite(), "samples are newtons");
  }
  if (const auto identity = jr3_comedi_identity(frame))
    fuzz::require(jr3_comedi_frame(1, *identity) == frame, "an identity is its frame");
  return 0;
}

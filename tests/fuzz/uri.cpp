// SPDX-License-Identifier: GPL-3.0-or-later
// Names of devices.
#include "device/config/uri.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

std::string escaped(std::string_view text) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    out += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto uri = Uri::parse(text);
  if (!uri) {
    fuzz::require_helpful(uri.error(), text);
    return 0;
  }
  std::string written = uri->scheme + "://" + escaped(uri->target);
  char before = '?';
  for (const auto& [key, value] : uri->parameters) {
    written += before + escaped(key) + "=" + escaped(value);
    before = '&';
    const auto number = uri->number_or(key, 0.0, -1.0, 1.0);
    if (number) fuzz::require(*number >= -1.0 && *number <= 1.0, "a number keeps to its limits");
  }
  const auto again = Uri::parse(written);
  fuzz::require(again.ok() && again->scheme == uri->scheme && again->target == uri->target &&
                    again->parameters == uri->parameters,
                "what is written is what was read");
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Sealed texts, wrapped keys and typed recovery keys from a file that somebody has changed: nothing
// but what was sealed can be opened.
#include "storage/access/vault.hpp"
#include "storage/crypto/seal.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const storage::Secret key = storage::derived_key(storage::Secret(storage::kKeySize), 1);
  static const std::string sealed = storage::seal(key, "place", "text");
  const auto text = fuzz::as_text(data, size);
  const auto opened = storage::unseal(key, "place", text);
  fuzz::require(!opened || text == sealed, "nobody without the key makes a sealed text");
  fuzz::require(storage::unseal(key, "place", storage::seal(key, "place", text))->text() == text,
                "every text comes back");
  if (text.find('\0') == std::string_view::npos) {
    const auto digits = storage::read_recovery_key(storage::Secret(text));
    constexpr std::size_t kDigits = 52;
    fuzz::require(!digits || digits->size() == kDigits, "a recovery key has 52 digits");
  }
  storage::SlotOwner owner;
  owner.database_id = "id";
  storage::KeySlot slot;
  slot.salt = std::string(text.substr(0, text.size() / 2));
  slot.cost = storage::kCheapKeyCost;
  slot.wrapped = std::string(text.substr(text.size() / 2));
  fuzz::require(!storage::open_slot(slot, owner, storage::Secret(std::string_view("password"))),
                "nobody without the password makes a slot");
  return 0;
}

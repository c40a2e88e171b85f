// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a protected database and the slots they are wrapped in. One random data key; four
// keys follow from it, one for each purpose. A slot wraps what its owner's role needs and no more,
// under a key made from the owner's password. Inside storage/ only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "storage/access/access.hpp"
#include "storage/crypto/seal.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

/// The keys that a role holds; absent: the role may not have it.
struct Keys {
  Secret data;      ///< administrators: wraps what others need
  Secret audit;     ///< all: the chain of the audit log
  Secret pin;       ///< all but researchers: the checks of PINs
  Secret text;      ///< all but researchers: free text
  Secret identity;  ///< all but researchers
  [[nodiscard]] bool suffice_for(Role role) const noexcept;
};
[[nodiscard]] Keys keys_from(Secret data_key);

enum class SlotKind : std::uint8_t { passphrase, recovery, user };
[[nodiscard]] std::string_view name_of(SlotKind kind) noexcept;

/// Whose slot. All of it is authenticated: a changed role or name opens nothing.
struct SlotOwner {
  std::string database_id;
  SlotKind kind = SlotKind::passphrase;
  User user;  ///< of kind user; else an administrator without an account
};

/// Of the clinic's passphrase or of the recovery key: an administrator without an account.
[[nodiscard]] SlotOwner holder_of(const std::string& database_id, SlotKind kind);

struct KeySlot {
  RowId id = 0;
  std::string salt;
  KeyCost cost;
  std::string wrapped;
  int failed_count = 0;  ///< wrong passwords in a row
  std::int64_t retry_at_unix_s = 0;
};

// In a transaction or guard of the caller; throw as SOCI does.
/// In place of the owner's slot, if there is one.
void write_slot(soci::session& sql, const SlotOwner& owner, const Secret& password,
                const KeyCost& cost, const Keys& keys);
/// A new data key in the slot of the passphrase; the keys that follow from it.
[[nodiscard]] Keys write_first_slot(soci::session& sql, const std::string& database_id,
                                    const Secret& passphrase, const KeyCost& cost);
void write_recovery_slot(soci::session& sql, const std::string& database_id,
                         const Secret& recovery_key, const Keys& keys);
[[nodiscard]] std::optional<KeySlot> read_slot(soci::session& sql, const SlotOwner& owner);

/// Takes the time of Argon2id. Nothing: wrong password, or a changed slot.
[[nodiscard]] std::optional<Keys> open_slot(const KeySlot& slot, const SlotOwner& owner,
                                            const Secret& password);

// The recovery key on paper: 52 digits of Crockford's base 32 and four check digits, in
// groups of four.
[[nodiscard]] Secret make_recovery_key();
/// Its 52 digits; nothing: mistyped.
[[nodiscard]] std::optional<Secret> read_recovery_key(const Secret& typed);

}  // namespace isograsp::storage

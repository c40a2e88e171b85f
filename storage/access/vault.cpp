// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/vault.hpp"

#include <cassert>
#include <cstring>

#include <soci/soci.h>

#include "storage/file/database.hpp"

namespace isograsp::storage {

namespace {

constexpr std::size_t kSaltSize = 16;

/// Numbers are part of the format.
enum KeyNumber : std::uint64_t { kAuditKey = 1, kPinKey = 2, kTextKey = 3, kIdentityKey = 4 };

/// What a slot of this role wraps.
Secret bundle(const Keys& keys, Role role) {
  if (role == Role::administrator) return keys.data.copy();
  if (role == Role::researcher) return keys.audit.copy();
  Secret all(4 * kKeySize);
  std::size_t at = 0;
  for (const Secret* key : {&keys.audit, &keys.pin, &keys.text, &keys.identity}) {
    std::memcpy(all.data() + at, key->data(), kKeySize);
    at += kKeySize;
  }
  return all;
}

std::optional<Keys> keys_in(Secret bundle, Role role) {
  if (bundle.size() != (role == Role::therapist ? 4 * kKeySize : kKeySize)) return std::nullopt;
  if (role == Role::administrator) return keys_from(std::move(bundle));
  Keys keys;
  if (role == Role::researcher) {
    keys.audit = std::move(bundle);
    return keys;
  }
  std::size_t at = 0;
  for (Secret* key : {&keys.audit, &keys.pin, &keys.text, &keys.identity}) {
    *key = bundle.part(at, kKeySize);
    at += kKeySize;
  }
  return keys;
}

std::string place_of(const SlotOwner& owner) {
  const bool account = owner.kind == SlotKind::user;
  return "slot\n" + owner.database_id + "\n" + std::string(name_of(owner.kind)) + "\n" +
         std::to_string(account ? owner.user.id : 0) + "\n" +
         std::string(name_of(owner.user.role)) + "\n" + (account ? owner.user.name : "");
}

constexpr std::string_view kDigits = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";  // Crockford
constexpr std::size_t kRecoveryDigits = 52;                               // 260 bits
constexpr std::size_t kCheckDigits = 4;
constexpr unsigned kBase = 32;

std::string check_digits(std::string_view digits) {
  const std::string hash = Digest().add("recovery key").add(digits).hex();
  std::string check;
  for (std::size_t i = 0; i < kCheckDigits; ++i)
    check +=
        kDigits[static_cast<std::size_t>(std::stoi(hash.substr(2 * i, 2), nullptr, 16)) % kBase];
  return check;
}

}  // namespace

bool Keys::suffice_for(Role role) const noexcept {
  switch (role) {
    case Role::administrator: return !data.empty();
    case Role::therapist: return !text.empty() && !identity.empty();
    case Role::researcher: return !audit.empty();
  }
  return false;
}

Keys keys_from(Secret data_key) {
  Keys keys;
  keys.audit = derived_key(data_key, kAuditKey);
  keys.pin = derived_key(data_key, kPinKey);
  keys.text = derived_key(data_key, kTextKey);
  keys.identity = derived_key(data_key, kIdentityKey);
  keys.data = std::move(data_key);
  return keys;
}

std::string_view name_of(SlotKind kind) noexcept {
  switch (kind) {
    case SlotKind::passphrase: return "passphrase";
    case SlotKind::recovery: return "recovery";
    case SlotKind::user: return "user";
  }
  return "";
}

SlotOwner holder_of(const std::string& database_id, SlotKind kind) {
  const char* const name = kind == SlotKind::passphrase ? "clinic passphrase" : "recovery key";
  return {database_id, kind, {0, name, Role::administrator, false, ""}};
}

Keys write_first_slot(soci::session& sql, const std::string& database_id, const Secret& passphrase,
                      const KeyCost& cost) {
  Keys keys = keys_from(Secret::random(kKeySize));
  write_slot(sql, holder_of(database_id, SlotKind::passphrase), passphrase, cost, keys);
  return keys;
}

void write_recovery_slot(soci::session& sql, const std::string& database_id,
                         const Secret& recovery_key, const Keys& keys) {
  write_slot(sql, holder_of(database_id, SlotKind::recovery), *read_recovery_key(recovery_key),
             kCheapKeyCost, keys);
}

void write_slot(soci::session& sql, const SlotOwner& owner, const Secret& password,
                const KeyCost& cost, const Keys& keys) {
  const std::string salt = random_hex(kSaltSize);
  const auto key = key_from_password(password, salt, cost);
  if (!key)
    throw Refusal{
        failed("not enough memory for the key of a password"_text, "close other programs"_text)};
  const std::string wrapped = seal(*key, place_of(owner), bundle(keys, owner.user.role).text());
  const std::string kind(name_of(owner.kind));
  const auto operations = static_cast<long long>(cost.operations);
  const auto memory = static_cast<long long>(cost.memory_bytes);
  auto present = owner.kind == SlotKind::user ? soci::i_ok : soci::i_null;
  sql << "DELETE FROM key_slots WHERE kind = :kind AND user_id IS :user", soci::use(kind),
      soci::use(owner.user.id, present);
  sql << "INSERT INTO key_slots (kind, user_id, salt, operations, memory_bytes, wrapped) "
         "VALUES (:kind, :user, :salt, :operations, :memory, :wrapped)",
      soci::use(kind), soci::use(owner.user.id, present), soci::use(salt), soci::use(operations),
      soci::use(memory), soci::use(wrapped);
}

std::optional<KeySlot> read_slot(soci::session& sql, const SlotOwner& owner) {
  KeySlot slot;
  const std::string kind(name_of(owner.kind));
  auto present = owner.kind == SlotKind::user ? soci::i_ok : soci::i_null;
  long long operations = 0;
  long long memory = 0;
  sql << "SELECT id, salt, operations, memory_bytes, wrapped, failed_count, retry_at_unix_s "
         "FROM key_slots WHERE kind = :kind AND user_id IS :user",
      soci::use(kind), soci::use(owner.user.id, present), soci::into(slot.id),
      soci::into(slot.salt), soci::into(operations), soci::into(memory), soci::into(slot.wrapped),
      soci::into(slot.failed_count), soci::into(slot.retry_at_unix_s);
  if (!sql.got_data()) return std::nullopt;
  slot.cost = {static_cast<std::uint64_t>(operations), static_cast<std::uint64_t>(memory)};
  return slot;
}

std::optional<Keys> open_slot(const KeySlot& slot, const SlotOwner& owner, const Secret& password) {
  if (!is_reasonable(slot.cost)) return std::nullopt;
  const auto key = key_from_password(password, slot.salt, slot.cost);
  if (!key) return std::nullopt;
  auto bundle = unseal(*key, place_of(owner), slot.wrapped);
  if (!bundle) return std::nullopt;
  return keys_in(*std::move(bundle), owner.user.role);
}

Secret make_recovery_key() {
  const Secret random = Secret::random(kRecoveryDigits);
  Secret digits(kRecoveryDigits + kCheckDigits);
  for (std::size_t i = 0; i < kRecoveryDigits; ++i)
    digits.data()[i] = static_cast<unsigned char>(kDigits[random.data()[i] % kBase]);
  const std::string check = check_digits(digits.text().substr(0, kRecoveryDigits));
  std::memcpy(digits.data() + kRecoveryDigits, check.data(), kCheckDigits);
  constexpr std::size_t kGroup = 4;
  Secret shown(digits.size() + (digits.size() - 1) / kGroup);
  for (std::size_t i = 0, at = 0; i < digits.size(); ++i) {
    if (i > 0 && i % kGroup == 0) shown.data()[at++] = '-';
    shown.data()[at++] = digits.data()[i];
  }
  return shown;
}

std::optional<Secret> read_recovery_key(const Secret& typed) {
  Secret digits(kRecoveryDigits + kCheckDigits);
  std::size_t count = 0;
  for (const char c : typed.text()) {
    if (c == '-' || c == ' ') continue;
    char digit = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (digit == 'O') digit = '0';  // Crockford: letters that look like digits
    if (digit == 'I' || digit == 'L') digit = '1';
    if (kDigits.find(digit) == std::string_view::npos || count == digits.size())
      return std::nullopt;
    digits.data()[count++] = static_cast<unsigned char>(digit);
  }
  if (count != digits.size()) return std::nullopt;
  if (digits.text().substr(kRecoveryDigits) !=
      check_digits(digits.text().substr(0, kRecoveryDigits)))
    return std::nullopt;
  return digits.part(0, kRecoveryDigits);
}

}  // namespace isograsp::storage

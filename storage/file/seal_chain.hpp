// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of row_seals: how they are chained and written. Inside storage/file/ only.
#pragma once

#include <optional>
#include <string>

#include "storage/crypto/content_hash.hpp"
#include "storage/crypto/secret.hpp"
#include "storage/file/row_seals.hpp"
#include "storage/file/seal_summary.hpp"

namespace isograsp::storage {

struct SealLine {
  std::int64_t number = 0;
  std::string table;
  std::string row;
  std::string hash;   ///< 32 bytes; empty: the row was removed
  std::string chain;  ///< 32 bytes
};
/// What chains a line to the one before; 32 bytes.
[[nodiscard]] std::string chain_of(const Secret* key, const std::string& before,
                                   const SealLine& line);
/// How far the lines had come when the last one was written, and who says so.
struct SealAnchor {
  std::int64_t count = 0;
  std::string chain;    ///< 32 bytes; empty: there was no line yet
  std::string proof;    ///< 32 bytes
  std::string summary;  ///< SealSummary; empty: none, as older programs left it
};
[[nodiscard]] std::optional<SealAnchor> read_anchor(soci::session& sql);
/// With it a holder of the key states how far the lines have come and what they say in sum.
[[nodiscard]] std::string seal_proof(const Secret* key, const SealAnchor& anchor);
[[nodiscard]] bool proves(const Secret* key, const SealAnchor& anchor);
/// It says so itself, and the lines end where it says. `proves` is part of it.
[[nodiscard]] bool is_of_last_line(soci::session& sql, const Secret* key, const SealAnchor& anchor);
/// The one that stands there is replaced.
void write_anchor(soci::session& sql, const SealAnchor& anchor);

/// Adds lines behind those that are there. Inside a transaction; throws as SOCI does.
class SealWriter {
 public:
  SealWriter(soci::session& sql, const Secret* key);
  /// Of before.
  [[nodiscard]] const SealAnchor& anchor() const noexcept { return anchor_; }
  /// `hash`: null: the row was removed.
  void add(const std::string& table, const std::string& row, const ContentHash* hash);
  /// Says how far they have come, and `summary`. Where the one who said so before does not prove,
  /// this one does not either, so that `db check` goes on saying it; but if every row has a line
  /// (`anew`).
  void finish(const SealSummary& summary, bool anew = false);

 private:
  soci::session& sql_;
  const Secret* key_;
  SealLine line_;      ///< the last one
  SealAnchor anchor_;  ///< of before
  Statement insert_;
};

}  // namespace isograsp::storage

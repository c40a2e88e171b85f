// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/seal_chain.hpp"

#include <algorithm>

#include <soci/soci.h>

namespace isograsp::storage {

namespace {

std::string_view key_bytes(const Secret* key) {
  return key != nullptr ? key->text() : std::string_view();
}

}  // namespace

std::string chain_of(const Secret* key, const std::string& before, const SealLine& line) {
  ContentHasher whole(key_bytes(key));
  whole.add_text("IsoGrasp seal 1");
  whole.add_text(before);
  whole.add_number(static_cast<std::uint64_t>(line.number));
  whole.add_text(line.table);
  whole.add_text(line.row);
  whole.add_text(line.hash);
  return std::string(bytes_of(whole.hash()));
}

std::string seal_proof(const Secret* key, std::int64_t count, const std::string& chain) {
  ContentHasher whole(key_bytes(key));
  whole.add_text("IsoGrasp seals 1");
  whole.add_number(static_cast<std::uint64_t>(count));
  whole.add_text(chain);
  return std::string(bytes_of(whole.hash()));
}

std::optional<SealAnchor> read_anchor(soci::session& sql) {
  Statement select(sql, "SELECT count, chain, proof FROM main.row_seals_anchor WHERE id = 1");
  if (!select.next()) return std::nullopt;
  SealAnchor anchor{select.number(0), std::string(select.bytes(1)), std::string(select.bytes(2))};
  select.reset();
  return anchor;
}

SealHead seal_head(soci::session& sql) {
  SealHead head;
  long long count = 0;
  sql << "SELECT count, lower(hex(chain)) FROM row_seals_anchor", soci::into(count),
      soci::into(head.chain);
  if (sql.got_data()) head.count = count;
  return head;
}

SealWriter::SealWriter(soci::session& sql, const Secret* key)
    : sql_(sql),
      key_(key),
      anchor_(read_anchor(sql).value_or(SealAnchor{})),
      insert_(sql,
              "INSERT INTO row_seals (id, of_table, of_row, hash, chain) VALUES (?, ?, ?, ?, ?)") {
  // From the anchor on, so that a gap after a cut remains visible.
  line_.chain = anchor_.chain;
  long long last = 0;
  sql << "SELECT coalesce(max(id), 0) FROM row_seals", soci::into(last);
  line_.number = std::max<std::int64_t>(anchor_.count, last);
}

void SealWriter::add(const std::string& table, const std::string& row, const ContentHash* hash) {
  ++line_.number;
  line_.table = table;
  line_.row = row;
  line_.hash = hash != nullptr ? std::string(bytes_of(*hash)) : "";
  line_.chain = chain_of(key_, line_.chain, line_);
  insert_.bind(1, line_.number);
  insert_.bind_text(2, line_.table);
  insert_.bind_text(3, line_.row);
  insert_.bind_bytes(4, line_.hash);
  insert_.bind_bytes(5, line_.chain);
  insert_.run();
}

void SealWriter::finish(bool anew) {
  const bool proved = anew || anchor_.proof.empty() ||
                      anchor_.proof == seal_proof(key_, anchor_.count, anchor_.chain);
  const std::string proof = proved ? seal_proof(key_, line_.number, line_.chain) : anchor_.proof;
  Statement anchor(sql_,
                   "INSERT INTO row_seals_anchor (id, count, chain, proof) VALUES (1, ?, ?, ?) "
                   "ON CONFLICT (id) DO UPDATE SET count = excluded.count, chain = excluded.chain, "
                   "proof = excluded.proof");
  anchor.bind(1, line_.number);
  anchor.bind_bytes(2, line_.chain);
  anchor.bind_bytes(3, proof);
  anchor.run();
}

}  // namespace isograsp::storage

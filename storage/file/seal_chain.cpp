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

std::string seal_proof(const Secret* key, const SealAnchor& anchor) {
  ContentHasher whole(key_bytes(key));
  whole.add_text(anchor.summary.empty() ? "IsoGrasp seals 1" : "IsoGrasp seals 2");
  whole.add_number(static_cast<std::uint64_t>(anchor.count));
  whole.add_text(anchor.chain);
  if (!anchor.summary.empty()) whole.add_text(anchor.summary);
  return std::string(bytes_of(whole.hash()));
}

bool proves(const Secret* key, const SealAnchor& anchor) {
  return anchor.proof == seal_proof(key, anchor);
}

std::optional<SealAnchor> read_anchor(soci::session& sql) {
  Statement select(sql, "SELECT count, chain, proof FROM main.row_seals_anchor WHERE id = 1");
  if (!select.next()) return std::nullopt;
  const std::string_view proof = select.bytes(2);
  const std::size_t own = std::min(proof.size(), ContentHash{}.size());
  SealAnchor anchor{select.number(0), std::string(select.bytes(1)),
                    std::string(proof.substr(0, own)), std::string(proof.substr(own))};
  select.reset();
  return anchor;
}

bool is_of_last_line(soci::session& sql, const Secret* key, const SealAnchor& anchor) {
  if (!proves(key, anchor)) return false;
  Statement last(sql, "SELECT id, chain FROM main.row_seals ORDER BY id DESC LIMIT 1");
  const bool same = last.next() ? last.number(0) == anchor.count && last.bytes(1) == anchor.chain
                                : anchor.count == 0;
  last.reset();
  return same;
}

void write_anchor(soci::session& sql, const SealAnchor& anchor) {
  Statement write(sql,
                  "INSERT INTO row_seals_anchor (id, count, chain, proof) VALUES (1, ?, ?, ?) "
                  "ON CONFLICT (id) DO UPDATE SET count = excluded.count, chain = excluded.chain, "
                  "proof = excluded.proof");
  write.bind(1, anchor.count);
  write.bind_bytes(2, anchor.chain);
  write.bind_bytes(3, anchor.proof + anchor.summary);
  write.run();
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

void SealWriter::finish(const SealSummary& summary, bool anew) {
  const bool proved = anew || anchor_.proof.empty() || proves(key_, anchor_);
  SealAnchor anchor{line_.number, line_.chain, anchor_.proof, anchor_.summary};
  if (proved) {
    anchor.summary = written(summary);
    anchor.proof = seal_proof(key_, anchor);
  }
  write_anchor(sql_, anchor);
}

}  // namespace isograsp::storage

// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/seal_chain.hpp"

#include <algorithm>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

namespace isograsp::storage {

using namespace sqlite_api;

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

SealHead seal_head(soci::session& sql) {
  SealHead head;
  long long count = 0;
  sql << "SELECT count, lower(hex(chain)) FROM row_seals_anchor", soci::into(count),
      soci::into(head.chain);
  if (sql.got_data()) head.count = count;
  return head;
}

/// A statement with bytes in it, which SOCI would copy into a BLOB of its own, one open of it a
/// line.
struct SealWriter::Insert {
  Insert(soci::session& sql, const char* query)
      : connection(static_cast<soci::sqlite3_session_backend*>(sql.get_backend())->conn_) {
    must(sqlite3_prepare_v2(connection, query, -1, &compiled, nullptr));
  }
  Insert(const Insert&) = delete;
  Insert& operator=(const Insert&) = delete;
  ~Insert() { sqlite3_finalize(compiled); }
  void must(int code) const {
    if (code != SQLITE_OK) throw soci::sqlite3_soci_error(sqlite3_errmsg(connection), code);
  }
  void number(int at, std::int64_t value) { must(sqlite3_bind_int64(compiled, at, value)); }
  void text(int at, const std::string& value) {
    must(sqlite3_bind_text(compiled, at, value.data(), static_cast<int>(value.size()),
                           SQLITE_STATIC));
  }
  void bytes(int at, const std::string& value) {  // none: NULL
    must(value.empty() ? sqlite3_bind_null(compiled, at)
                       : sqlite3_bind_blob(compiled, at, value.data(),
                                           static_cast<int>(value.size()), SQLITE_STATIC));
  }
  void run() {
    sqlite3_step(compiled);
    must(sqlite3_reset(compiled));
  }
  sqlite3* connection;
  sqlite3_stmt* compiled = nullptr;
};

SealWriter::SealWriter(soci::session& sql, const Secret* key)
    : sql_(sql),
      key_(key),
      insert_(std::make_unique<Insert>(
          sql,
          "INSERT INTO row_seals (id, of_table, of_row, hash, chain) VALUES (?, ?, ?, ?, ?)")) {
  // From the anchor on, so that a gap after a cut remains visible.
  soci::blob chain(sql);
  long long count = 0;
  sql << "SELECT count, chain FROM row_seals_anchor", soci::into(count), soci::into(chain);
  if (sql.got_data()) {
    line_.chain.resize(chain.get_len());
    if (!line_.chain.empty()) chain.read(0, line_.chain.data(), line_.chain.size());
  }
  long long last = 0;
  sql << "SELECT coalesce(max(id), 0) FROM row_seals", soci::into(last);
  line_.number = std::max(count, last);
}

SealWriter::~SealWriter() = default;

void SealWriter::add(const std::string& table, const std::string& row, const ContentHash* hash) {
  ++line_.number;
  line_.table = table;
  line_.row = row;
  line_.hash = hash != nullptr ? std::string(bytes_of(*hash)) : "";
  line_.chain = chain_of(key_, line_.chain, line_);
  insert_->number(1, line_.number);
  insert_->text(2, line_.table);
  insert_->text(3, line_.row);
  insert_->bytes(4, line_.hash);
  insert_->bytes(5, line_.chain);
  insert_->run();
}

void SealWriter::finish() {
  const std::string proof = seal_proof(key_, line_.number, line_.chain);
  Insert anchor(sql_,
                "INSERT INTO row_seals_anchor (id, count, chain, proof) VALUES (1, ?, ?, ?) "
                "ON CONFLICT (id) DO UPDATE SET count = excluded.count, chain = excluded.chain, "
                "proof = excluded.proof");
  anchor.number(1, line_.number);
  anchor.bytes(2, line_.chain);
  anchor.bytes(3, proof);
  anchor.run();
}

}  // namespace isograsp::storage

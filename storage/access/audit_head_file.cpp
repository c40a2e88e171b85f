// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/audit_head_file.hpp"

#include <cstdio>
#include <sstream>

#include "core/files.hpp"
#include "storage/access/audit_chain.hpp"

namespace isograsp::storage {

namespace {

constexpr const char* kFormat = "isograsp-audit-head-1";

}  // namespace

std::string head_file_of(const std::string& database) {
  return database + "-audit";
}

std::string set_aside_head_file(const std::string& database) {
  std::string name = free_name(head_file_of(database) + ".old");
  if (std::rename(head_file_of(database).c_str(), name.c_str()) != 0) name.clear();
  return name;
}

HeadFile read_head_file(const std::string& database, const Secret* key,
                        const std::string& database_id) {
  const auto text = read_text(head_file_of(database));
  if (!text) return {};
  HeadFile file;
  file.present = true;
  std::istringstream in(*text);
  std::string format;
  std::string id;
  std::string proof;
  AuditHead head;
  if (in >> format >> id >> head.count >> head.hash >> proof && format == kFormat &&
      id == database_id && proof == head_proof(key, database_id, head))
    file.head = head;
  return file;
}

void write_head_file(const std::string& database, const Secret* key, const std::string& database_id,
                     const AuditHead& head) {
  const std::string name = head_file_of(database);
  const auto written =
      write_text(name, std::string(kFormat) + " " + database_id + " " + std::to_string(head.count) +
                           " " + head.hash + " " + head_proof(key, database_id, head) + "\n");
  if (written) give_permissions_of(database, name);
}

}  // namespace isograsp::storage

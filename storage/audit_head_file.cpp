// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/audit_head_file.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include "storage/audit_chain.hpp"

namespace isograsp {

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
  std::ifstream in(head_file_of(database));
  if (!in) return {};
  HeadFile file;
  file.present = true;
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
  const std::string temporary = head_file_of(database) + ".part" + std::to_string(getpid());
  {
    std::ofstream out(temporary);
    out << kFormat << ' ' << database_id << ' ' << head.count << ' ' << head.hash << ' '
        << head_proof(key, database_id, head) << '\n';
    out.flush();
    if (!out || !sync_path(temporary)) {
      std::remove(temporary.c_str());
      return;
    }
  }
  std::rename(temporary.c_str(), head_file_of(database).c_str());
}

}  // namespace isograsp

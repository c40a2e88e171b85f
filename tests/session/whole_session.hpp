// SPDX-License-Identifier: GPL-3.0-or-later
// A whole session of a simulated hand in virtual time: a protocol from its first to its last step,
// into a new database.
#pragma once

#include <string>

#include "session/open_two_platforms.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

struct WholeSession {
  std::string database;  ///< is not there yet
  std::string patient_code;
  std::string device_uri;  ///< "sim://healthy?seed=7"
  std::string protocol;    ///< path of its file
  std::string library = std::string(ISOGRASP_SOURCE_DIR) + "/library";
};

/// Runs it and closes the database. Throws std::runtime_error if any of it fails.
inline session::ProtocolResult run_whole(const WholeSession& what) {
  session::SessionConfig config;
  config.database = what.database;
  config.create_database = true;
  config.patient_code = what.patient_code;
  config.device_uri = what.device_uri;
  config.library = what.library;
  config.virtual_time = true;
  if (session::two_platforms_in(what.device_uri)) config.hand.reset();
  const auto protocol = must(session::read_protocol(what.protocol, what.library));
  const auto session = must(session::Session::open(config));
  auto result = must(session::run_protocol(*session, protocol, {}));
  session->close();
  return result;
}

}  // namespace isograsp::test

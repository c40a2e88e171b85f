// SPDX-License-Identifier: GPL-3.0-or-later
// Made-up patients for the tests of reports: sessions with rest, maximum, sine and two targets
// whose curves are closed forms, scored by the shipped measures. SI units.
#pragma once

#include <string>

#include "storage/records/session_store.hpp"

namespace isograsp::test {

struct DemoSession {
  std::string date = "2026-03-02";
  Hand hand = Hand::right;
  bool simulated = false;
  bool recorded = false;
  double skill = 0.0;  ///< 0 … 1
  int task_version = 1;
  bool with_faults = false;
};

/// Adds one complete session; returns its id. Fails the running test if the store refuses.
storage::RowId add_session(storage::SessionStore& store, const std::string& code,
                           const DemoSession& demo);

/// A patient with six sessions of the right hand over five weeks, the last with faults.
void add_course(storage::SessionStore& store, const std::string& code, bool simulated);

}  // namespace isograsp::test

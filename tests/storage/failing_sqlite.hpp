// SPDX-License-Identifier: GPL-3.0-or-later
// What SQLite asks of the system fails on demand: the n-th call of one kind, once or from then on.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace isograsp::storage {

/// What can fail. All but memory are calls of the file layer; of any file that SQLite opens.
enum class Asked : std::uint8_t {
  read,
  write,
  sync,
  truncate,
  open,
  remove,
  size,
  map,  ///< shared memory of the index of the log
  memory
};

/// While it lives, what SQLite asks goes through it. One at a time; @pre no connection is open when
/// it is made and when it ends. Not thread-safe.
class FailingSqlite {
 public:
  FailingSqlite();
  ~FailingSqlite();
  FailingSqlite(const FailingSqlite&) = delete;
  FailingSqlite& operator=(const FailingSqlite&) = delete;

  /// From now on calls of this kind are counted; the `nth` (from 1) fails, and with `for_good` all
  /// later ones. 0: none fails.
  void fail(Asked what, int nth, bool for_good = false);
  /// Nothing fails any more; how many calls were counted.
  int heal();
  /// Numbers of the calls that were counted, in their order, since fail(memory, 0): of each place
  /// in the program (a whole stack of calls) that asks, the first and the last. SQLite asks some
  /// hundred thousand times for memory, mostly at the same places.
  [[nodiscard]] std::vector<int> calls_by_place() const;
  [[nodiscard]] bool has_failed() const;

 private:
  struct Layer;
  std::unique_ptr<Layer> layer_;
};

}  // namespace isograsp::storage

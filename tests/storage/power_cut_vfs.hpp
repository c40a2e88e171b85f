// SPDX-License-Identifier: GPL-3.0-or-later
// A file layer for SQLite (VFS) under which the power can be cut, the disk be full. It passes
// everything on to the usual one and keeps, of every file of a folder, what a sync has made durable
// and every version of each 512-byte sector since. After a cut a sector holds any of these
// versions, whatever the others hold: writes are lost, reordered and torn. A new name may be lost
// until the first sync of its file, a removed one may come back.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace isograsp::storage {

class PowerCutVfs {
 public:
  /// From now on, and until it is destroyed, the layer of all new connections of this process.
  explicit PowerCutVfs(std::string folder, unsigned seed);
  ~PowerCutVfs();
  PowerCutVfs(const PowerCutVfs&) = delete;
  PowerCutVfs& operator=(const PowerCutVfs&) = delete;

  /// What the disk holds after a cut, and what had been confirmed then.
  struct Cut {
    std::map<std::string, std::string> files;  ///< bytes by name
    std::vector<int> confirmed;                ///< counters of confirm()
    /// Writes the files into an empty folder.
    void restore(const std::string& folder) const;
  };
  /// A cut in one of `every` writes and syncs, chosen by chance.
  void cut_in_one_of(unsigned every) { every_ = every; }
  /// The writer was told that number `counter` has reached `value`.
  void confirm(std::size_t counter, int value);
  [[nodiscard]] const std::vector<Cut>& cuts() const { return cuts_; }

  /// After so many more writes no write succeeds any more ("disk full"); -1: there is space.
  void full_after(int writes) { writes_left_ = writes; }

  struct Layer;  ///< what SQLite is given
  struct File;   ///< of the folder, as the disk and its cache hold it

 private:
  friend struct Layer;
  void tick();
  [[nodiscard]] std::string after_cut(const File& file);

  std::string folder_;
  std::mt19937 random_;
  std::unique_ptr<Layer> layer_;
  std::map<std::string, File> files_;
  unsigned every_ = 0;
  int writes_left_ = -1;
  std::vector<int> confirmed_;
  std::vector<Cut> cuts_;
};

}  // namespace isograsp::storage

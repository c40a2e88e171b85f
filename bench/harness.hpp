// SPDX-License-Identifier: GPL-3.0-or-later
// The same main program for every engine: error over the whole case, time per hold, instructions.
// An engine brings its methods; the driver (bench/report/measure.py) starts it again and again.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/case.hpp"

namespace isograsp::bench {

/// One engine with one method, standing at the start of a case.
class Simulation {
 public:
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;
  /// Runs holds first .. last - 1. This alone is timed.
  virtual void run(std::size_t first, std::size_t last) = 0;
  [[nodiscard]] virtual Motion6 motion() const = 0;
};

/// An integrator of an engine at one price.
struct Method {
  std::string integrator;
  int substeps = 0;   ///< per hold; 0: the method chooses
  std::string setup;  ///< how springs, dampers and wrench were given to the engine
  std::function<std::unique_ptr<Simulation>(const Case&)> start;
  bool parts = false;  ///< the engine's inner functions called one by one instead of its own step
};

/// `program CASE list|error|time|count [NUMBER ...]`: one line per method (or per method chosen by
/// number) on standard output, announced before it starts, so that the driver knows who aborted.
int run_engine(const std::string& engine, const std::string& version,
               const std::function<std::vector<Method>(const Case&)>& methods, int argc,
               char** argv);

/// 1, 2, 4, … most.
[[nodiscard]] std::vector<int> ladder(int most);

}  // namespace isograsp::bench

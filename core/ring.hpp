// SPDX-License-Identifier: GPL-3.0-or-later
// The queue between two threads: one producer, one consumer, no lock, no allocation after start.
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

namespace isograsp {

/// push() and pop() return false when full or empty; both are real-time safe.
template <class T>
using Ring = boost::lockfree::spsc_queue<T>;

}  // namespace isograsp

// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/visual_memory.hpp"

namespace isograsp::virtual_patient {

VisualMemory::VisualMemory() : ring_(kPictures) {}

bool VisualMemory::see(const Stimulus& stimulus) noexcept {
  const bool again = written_ > 0 && stimulus.t_s < ring_[(written_ - 1) % kPictures].t_s;
  if (again) taken_ = written_;
  ring_[written_++ % kPictures] = stimulus;
  if (written_ - taken_ > kPictures) taken_ = written_ - kPictures;
  return again;
}

const Stimulus* VisualMemory::next(double until_s) noexcept {
  if (taken_ == written_ || ring_[taken_ % kPictures].t_s > until_s) return nullptr;
  return &ring_[taken_++ % kPictures];
}

}  // namespace isograsp::virtual_patient

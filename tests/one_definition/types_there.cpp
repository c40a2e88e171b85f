// SPDX-License-Identifier: GPL-3.0-or-later
// Beside types_here.cpp: two types of one name.
#include <string>

namespace twice {
class Section {
 public:
  virtual ~Section() = default;
  std::string title;
};
}  // namespace twice

int letters_there() {
  const twice::Section section;
  return static_cast<int>(section.title.size());
}

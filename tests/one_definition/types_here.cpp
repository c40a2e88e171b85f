// SPDX-License-Identifier: GPL-3.0-or-later
// Beside types_there.cpp: two types of one name.
namespace twice {
class Section {
 public:
  virtual ~Section() = default;
  int lines = 0;
};
}  // namespace twice

int lines_here() {
  const twice::Section section;
  return section.lines;
}

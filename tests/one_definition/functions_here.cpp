// SPDX-License-Identifier: GPL-3.0-or-later
// Beside functions_there.cpp: two functions of one name.
int defined_twice() {
  return 1;
}

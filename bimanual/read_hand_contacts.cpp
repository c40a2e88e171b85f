// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/read_hand_contacts.hpp"

#include <algorithm>

namespace isograsp::bimanual {

namespace {

bool has_contact(const HandContacts& hand, Finger finger) {
  return std::any_of(hand.contacts.begin(), hand.contacts.end(),
                     [&](const Contact& contact) { return contact.finger == finger; });
}

}  // namespace

std::array<HandContacts, kSides> read_hand_contacts(TomlReader& root, const Scene& object) {
  std::array<HandContacts, kSides> hands;
  auto tables = root.tables("contact");
  if (tables.empty())
    root.fail("contact", "is missing: nothing passes the forces on"_text,
              "add [[contact]] with hand = \"left\" or \"right\""_text);
  for (TomlReader& table : tables) {
    HandContacts& hand = hands[table.choice("hand", {"left", "right"})];
    const bool whole = !table.has("finger");
    const auto finger =
        whole ? kFingers.front()
              : static_cast<Finger>(table.choice("finger", {"thumb", "index", "middle"}));
    if (!hand.contacts.empty() && hand.whole != whole)
      table.fail("hand",
                 "presses as a whole and with single fingers: forces would count twice"_text,
                 "write finger in all contacts of this hand, or one contact without"_text);
    else if (whole && hand.whole)
      table.fail("hand", "has two contacts"_text, "keep one, or name the finger of each"_text);
    else if (has_contact(hand, finger))
      table.fail("finger", "has two contacts"_text, "keep one contact per finger"_text);
    Contact contact = read_contact(table, object);
    contact.finger = finger;
    hand.whole = whole;
    hand.contacts.push_back(contact);
  }
  return hands;
}

}  // namespace isograsp::bimanual

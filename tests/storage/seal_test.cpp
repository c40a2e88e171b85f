// SPDX-License-Identifier: GPL-3.0-or-later
// Sealing, keys and hashes by themselves.
#include "storage/crypto/seal.hpp"

#include <set>

#include "storage/access/vault.hpp"
#include "tests/storage/examples.hpp"

namespace isograsp::storage::seal_test {
namespace {

const std::string kText = "Frau Žižková\nspricht nicht";

TEST(Seal, ComesBackForItsKeyAndPlaceOnly) {
  const Secret key = Secret::random(kKeySize);
  for (const std::string& text : {std::string(), kText, std::string(5000, 'x')}) {
    const std::string sealed = seal(key, "here", text);
    EXPECT_EQ(unseal(key, "here", sealed)->text(), text);
    EXPECT_FALSE(unseal(key, "there", sealed));
    EXPECT_FALSE(unseal(Secret::random(kKeySize), "here", sealed));
  }
}

TEST(Seal, NoticesEveryChangedCharacterAndEveryCut) {
  const Secret key = Secret::random(kKeySize);
  const std::string sealed = seal(key, "here", kText);
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    std::string changed = sealed;
    changed[i] = changed[i] == 'A' ? 'B' : 'A';
    // The last digit of base64 carries bits that belong to no byte; those are refused as well.
    EXPECT_FALSE(unseal(key, "here", changed)) << i;
    EXPECT_FALSE(unseal(key, "here", sealed.substr(0, i))) << i;
  }
  EXPECT_FALSE(unseal(key, "here", sealed + "A"));
}

TEST(Seal, TellsNothing) {
  const Secret key = Secret::random(kKeySize);
  EXPECT_NE(seal(key, "here", kText), seal(key, "here", kText)) << "equal texts look equal";
  EXPECT_EQ(seal(key, "here", "Jo").size(), seal(key, "here", "Maximiliane Berg").size());
  EXPECT_EQ(seal(key, "here", kText).find("Frau"), std::string::npos);
}

TEST(Keys, DifferByNumberAndAreMadeAgain) {
  const Secret key = Secret::random(kKeySize);
  std::set<std::string> all{std::string(key.text())};
  for (std::uint64_t number = 1; number <= 4; ++number) {
    EXPECT_EQ(derived_key(key, number).text(), derived_key(key, number).text());
    all.insert(std::string(derived_key(key, number).text()));
  }
  EXPECT_EQ(all.size(), 5u);
}

TEST(Keys, FromAPasswordDependOnPasswordSaltAndCost) {
  const std::string salt(32, '1');
  const Secret a{std::string_view("password")};
  const auto key = key_from_password(a, salt, kCheapKeyCost);
  ASSERT_TRUE(key);
  EXPECT_EQ(key_from_password(a, salt, kCheapKeyCost)->text(), key->text());
  EXPECT_NE(key_from_password(Secret{std::string_view("passworD")}, salt, kCheapKeyCost)->text(),
            key->text());
  EXPECT_NE(key_from_password(a, std::string(32, '2'), kCheapKeyCost)->text(), key->text());
  EXPECT_NE(key_from_password(a, salt, {2, 8192})->text(), key->text());
  EXPECT_FALSE(key_from_password(a, "not a salt", kCheapKeyCost));
  EXPECT_FALSE(is_reasonable({1, std::uint64_t{1} << 62})) << "a file could stop the program";
  EXPECT_FALSE(is_reasonable({std::uint64_t{1} << 40, 8192}));
}

TEST(Digest, DiffersWhereverPartsEnd) {
  EXPECT_NE(Digest().add("ab").add("c").hex(), Digest().add("a").add("bc").hex());
  EXPECT_NE(Digest().add("a").hex(), Digest().add("a").add("").hex());
  const Secret key = Secret::random(kKeySize);
  EXPECT_NE(Digest().add("a").hex(), Digest(&key).add("a").hex());
}

/// Reference: hashlib.blake2b of Python, digest_size 32, over the length (eight bytes, little end
/// first) and the text.
TEST(Digest, IsBlake2bOfLengthAndText) {
  EXPECT_EQ(Digest().add("").hex(),
            "81e47a19e6b29b0a65b9591762ce5143ed30d0261e5d24a3201752506b20f15c");
  EXPECT_EQ(Digest().add("abc").hex(),
            "3bdc62cfd65e3b78e3d90e32e0a91ebfbc229c30abe54e6abd16c5d4def0db7b");
}

TEST(RecoveryKey, IsReadAsItIsWrittenByHand) {
  const Secret key = make_recovery_key();
  EXPECT_EQ(key.size(), 69u);  // fourteen groups of four
  const auto digits = read_recovery_key(key);
  ASSERT_TRUE(digits);
  std::string by_hand;
  for (const char c : key.text())
    by_hand += c == '-' ? ' ' : c == '0' ? 'o' : c == '1' ? 'l' : static_cast<char>(tolower(c));
  EXPECT_EQ(read_recovery_key(Secret{std::string_view(by_hand)})->text(), digits->text());
  EXPECT_NE(make_recovery_key().text(), key.text());
}

TEST(RecoveryKey, NoticesASlip) {
  const Secret key = make_recovery_key();
  int unnoticed = 0;
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (key.text()[i] == '-') continue;
    std::string slip(key.text());
    slip[i] = slip[i] == '7' ? '8' : '7';
    unnoticed += read_recovery_key(Secret{std::string_view(slip)}) ? 1 : 0;
    EXPECT_FALSE(read_recovery_key(Secret{key.text().substr(0, i)}));
  }
  // Twenty bits of check: one slip in a million.
  EXPECT_EQ(unnoticed, 0);
}

TEST(SecretFile, GivesItsFirstLine) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) {
    std::ofstream(folder.file("f"), std::ios::binary) << bytes;
    return Secret::from_file(folder.file("f"));
  };
  EXPECT_EQ(must(read("two words\n")).text(), "two words");
  EXPECT_EQ(must(read("two words\r\nmore")).text(), "two words");
  EXPECT_EQ(must(read("two words")).text(), "two words");
  EXPECT_EQ(must(read(std::string(1024, 'a') + "\n")).size(), 1024u);
  for (const std::string& bad : {std::string(), std::string("\n"), std::string(1025, 'a'),
                                 std::string("a\0b\n", 4), std::string(1 << 20, 'a')}) {
    const auto refused = read(bad);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message().find("aaa"), std::string::npos) << "tells the secret";
  }
  EXPECT_FALSE(Secret::from_file(folder.file("none")).ok());
  EXPECT_FALSE(Secret::from_file(folder.path()).ok());
}

}  // namespace
}  // namespace isograsp::storage::seal_test

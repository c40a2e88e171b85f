// SPDX-License-Identifier: GPL-3.0-or-later
// What a signature beside a backup proves, and to whom.
#include <algorithm>
#include <fstream>
#include <random>

#include "core/files.hpp"
#include "storage/access/protection.hpp"
#include "storage/access/signing.hpp"
#include "storage/care/backups.hpp"
#include "tests/storage/clinic_under_attack.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::signed_backups_test {
namespace {

namespace fs = std::filesystem;

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string flipped(std::string bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
  return bytes;
}

struct SignedBackup : ClinicUnderAttack {
  std::string backup = folder.file("monday.db");
  std::string sig = signature_file_of(backup);
  std::string key;

  SignedBackup() {
    must(opened(path, OpenMode::read_only)->backup(backup));
    key = must(public_key_of(path));
  }
  [[nodiscard]] std::string why_not(const std::string& expected = "") const {
    return refusal(check_signature(backup, SignedKind::backup, expected));
  }
};
INSTANTIATE_TEST_SUITE_P(, SignedBackup, testing::Bool(),
                         [](const auto& one) { return one.param ? "Protected" : "Unprotected"; });

TEST_P(SignedBackup, ProvesWithoutALoginAndStaysAPlainDatabase) {
  access.reset();
  EXPECT_EQ(why_not(key), "");
  EXPECT_EQ(must(check_signature(backup, SignedKind::backup)).key, key);
  EXPECT_EQ(bytes_of(backup).substr(0, 15), "SQLite format 3");
  log_in();
  EXPECT_TRUE(must(opened(backup, OpenMode::read_only)->check()).empty());
  EXPECT_EQ(why_not(key), "") << "who reads it changes nothing";
}

TEST_P(SignedBackup, TheKeyStaysThatOfTheClinicAndStandsInItsLog) {
  const std::string tuesday = folder.file("tuesday.db");
  log_in();
  must(opened(path, OpenMode::read_only)->backup(tuesday));
  EXPECT_EQ(must(check_signature(tuesday, SignedKind::backup)).key, key);
  if (!GetParam()) access = must(Access::open(path));
  const auto entries = must(read_audit(*access, {"backup", ""}));
  ASSERT_EQ(entries.size(), 2u);
  for (const auto& entry : test::every(entries)) EXPECT_EQ(entry.detail, "signed " + key);
}

TEST_P(SignedBackup, EveryFlippedBitOfTheSignatureIsNoticed) {
  const std::string good = bytes_of(sig);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    write_bytes(sig, flipped(good, bit));
    EXPECT_NE(why_not(), "") << "bit " << bit;
  }
  write_bytes(sig, good);
  EXPECT_EQ(why_not(), "");
}

TEST_P(SignedBackup, EveryFlippedBitOfTheDatabaseIsNoticed) {
  const std::string good = bytes_of(backup);
  std::mt19937_64 random(23);
  for (int i = 0; i < 100; ++i) {
    write_bytes(backup, flipped(good, random() % (8 * good.size())));
    EXPECT_NE(why_not().find("not what was signed"), std::string::npos);
  }
  for (const std::string& other : {good + '\0', good.substr(0, good.size() - 1), std::string()}) {
    write_bytes(backup, other);
    EXPECT_NE(why_not(), "");
  }
}

TEST_P(SignedBackup, ASignatureThatIsCutOrPaddedIsNone) {
  const std::string good = bytes_of(sig);
  for (std::size_t length = 0; length < good.size(); ++length) {
    write_bytes(sig, good.substr(0, length));
    EXPECT_NE(why_not(), "") << length;
  }
  for (const char* more : {"\n", " ", "signature 00\n"}) {
    write_bytes(sig, good + more);
    EXPECT_NE(why_not(), "") << more;
  }
}

TEST_P(SignedBackup, OfAnotherBackupProvesNothing) {
  log_in();
  must(opened(path)->add_patient("P-2"));
  const std::string tuesday = folder.file("tuesday.db");
  must(opened(path, OpenMode::read_only)->backup(tuesday));
  fs::copy_file(signature_file_of(tuesday), sig, fs::copy_options::overwrite_existing);
  EXPECT_NE(why_not().find("not what was signed"), std::string::npos);
}

TEST_P(SignedBackup, OfAnotherClinicIsToldByItsKey) {
  const std::string other = folder.file("other.db");
  record(other);
  fs::remove(backup);
  must(opened(other, OpenMode::read_only)->backup(backup));
  EXPECT_EQ(why_not(), "") << "without the clinic's key anybody may have signed it";
  EXPECT_NE(why_not(key).find("another key"), std::string::npos);
}

TEST_P(SignedBackup, ALogOfChangesBesideItIsNotProved) {
  for (const char* log : {"-wal", "-journal"}) {
    write_bytes(backup + log, "what SQLite would play into it");
    EXPECT_NE(why_not().find("log of changes"), std::string::npos) << log;
    fs::remove(backup + log);
  }
  EXPECT_EQ(why_not(), "");
}

TEST_P(SignedBackup, WithoutASignatureIsSaidToBeNotSigned) {
  fs::remove(sig);
  EXPECT_NE(why_not().find("is not signed"), std::string::npos);
  EXPECT_EQ(check_signature(backup, SignedKind::backup).error().code, Error::Code::failed);
  EXPECT_EQ(check_signature(backup, SignedKind::backup, "short").error().code,
            Error::Code::bad_input);
}

TEST_P(SignedBackup, OfAnExportIsNoneOfABackup) {
  log_in();
  must(sign_file(path, backup, SignedKind::export_list));
  EXPECT_NE(why_not().find("something else"), std::string::npos);
}

TEST_P(SignedBackup, OfAnotherSizeIsNotReadToTheEnd) {
  constexpr std::uintmax_t kTooLargeToRead_bytes = std::uintmax_t{1}
                                                   << 40;  // without a block of it
  fs::resize_file(backup, kTooLargeToRead_bytes);
  EXPECT_NE(why_not().find("not what was signed"), std::string::npos);
}

TEST_P(SignedBackup, ThatWasAlteredIsNotPutBack) {
  // With seals computed anew, as somebody can in a database without protection.
  access.reset();
  if (!GetParam()) must(opened(backup, OpenMode::existing)->add_patient("P-9"));
  if (GetParam()) write_bytes(backup, bytes_of(backup) + '\0');
  const auto restored = restore_backup(backup, path, [](const std::string& copy) {
    auto in = Access::open(copy);
    if (in && (*in)->is_protected())
      must((*in)->log_in_with_passphrase(secret("the clinic's passphrase")));
    return in;
  });
  EXPECT_NE(refusal(restored).find("not what was signed"), std::string::npos);
}

TEST_P(SignedBackup, OfOldStandsBesideNoNewFile) {
  const std::string before = bytes_of(sig);
  fs::remove(backup);
  log_in();
  must(opened(path)->add_patient("P-2"));
  must(opened(path, OpenMode::read_only)->backup(backup));
  EXPECT_NE(bytes_of(sig), before);
  EXPECT_EQ(why_not(key), "");
}

TEST_P(SignedBackup, DailyOnesAreSignedAndTheirSignaturesGoWithThem) {
  constexpr std::time_t kDay_s = 86400;
  const Backups daily(path, {1, 0, 0});
  log_in();
  for (int day = 1; day < 4; ++day) must(daily.make(1'800'000'000 + day * kDay_s));
  const auto left = must(daily.list());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(must(check_signature(left[0].path, SignedKind::backup, key)).key, key);
  EXPECT_EQ(std::distance(fs::directory_iterator(daily.folder()), {}), 2);
}

TEST(Signing, IsThatOfTheStandard) {
  // RFC 8032, 7.1, test 1: the public key of this seed.
  Secret seed(kKeySize);
  const std::string digits = "9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60";
  for (std::size_t i = 0; i < seed.size(); ++i)
    seed.data()[i] = static_cast<unsigned char>(std::stoi(digits.substr(2 * i, 2), nullptr, 16));
  const FileSignature made =
      signed_with(seed, {SignedKind::backup, 1, std::string(64, 'a'), "", "", ""});
  EXPECT_EQ(made.key, "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a");
  EXPECT_TRUE(is_genuine(made));
  // Over the lines as docs/file_formats.md has them, by another program (OpenSSL 3).
  EXPECT_EQ(made.signature,
            "7da65a0abdd6c738518ef8fce4287dad26b3a88ef1699cc3872ef3302d97fe5d"
            "38a14025c1944c0f8d8a2de0120b64bef9f31e9d7b4ef863d45fbe53645d0808");
}

TEST(Signing, TheKeyStaysWithANewPassphraseAndABackupThatIsPutBack) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  auto made = must(Access::create(path, secret("the clinic's passphrase"), &kCheapKeyCost));
  const std::string key = must(public_key_of(path));
  const std::string backup = folder.file("monday.db");
  must(opened(path, OpenMode::read_only)->backup(backup));
  must(change_passphrase(*made.access, secret("another passphrase"), kCheapKeyCost));
  EXPECT_EQ(must(public_key_of(path)), key);
  const std::string back = folder.file("back.db");
  const auto restored = must(restore_backup(backup, back, [](const std::string& copy) {
    auto in = Access::open(copy);
    if (in) must((*in)->log_in_with_passphrase(secret("the clinic's passphrase")));
    return in;
  }));
  EXPECT_EQ(restored.key, key);
  const auto access = must(Access::open(back));
  must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
  EXPECT_EQ(must(public_key_of(back)), key);
  EXPECT_EQ(refusal(check_signature(backup, SignedKind::backup, key)), "") << "it is only read";
}

TEST(Signing, ACopyOfAnUnprotectedDatabaseHasNotItsKey) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const std::string stolen = folder.file("stolen.db");
  record(path);
  must(opened(path, OpenMode::read_only)->backup(folder.file("monday.db")));
  fs::copy_file(folder.file("monday.db"), stolen);
  must(opened(stolen, OpenMode::read_only)->backup(folder.file("forged.db")));
  EXPECT_EQ(refusal(check_signature(folder.file("monday.db"), SignedKind::backup,
                                    must(public_key_of(path)))),
            "");
  EXPECT_NE(refusal(check_signature(folder.file("forged.db"), SignedKind::backup,
                                    must(public_key_of(path)))),
            "");
}

TEST(Signing, TheKeyBesideADatabaseIsForWhoMayWriteIt) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  record(path);
  for (const auto& [of_database, of_key] :
       {std::pair{0600, 0600}, {0644, 0600}, {0640, 0600}, {0660, 0640}}) {
    fs::permissions(path, static_cast<fs::perms>(of_database));
    fs::remove(signing_key_file_of(path));
    fs::remove(folder.file("monday.db"));
    must(opened(path, OpenMode::read_only)->backup(folder.file("monday.db")));
    EXPECT_EQ(fs::status(signing_key_file_of(path)).permissions(), static_cast<fs::perms>(of_key));
  }
}

TEST(Signing, AKeyFileThatIsNoneLeavesABackupUnsigned) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  record(path);
  for (const char* text :
       {"", "0123\n", "0123456789ABCDEF0123456789ABCDEF0123456789ABCDEF0123456789ABCDEF\n"}) {
    write_bytes(signing_key_file_of(path), text);
    const std::string backup = folder.file("monday.db");
    must(opened(path, OpenMode::read_only)->backup(backup));
    EXPECT_FALSE(fs::exists(signature_file_of(backup)));
    EXPECT_NE(refusal(check_signature(backup, SignedKind::backup)), "");
    fs::remove(backup);
  }
}

TEST(Signing, AProtectedDatabaseKeepsNoKeyThatOthersCanRead) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  record(path);
  const std::string before = folder.file("before.db");
  must(opened(path, OpenMode::read_only)->backup(before));
  const std::string old_key = must(public_key_of(path));
  auto made = must(protect_database(path, secret("the clinic's passphrase"), &kCheapKeyCost));
  EXPECT_FALSE(fs::exists(signing_key_file_of(path)));
  const std::string key = must(public_key_of(path));
  EXPECT_NE(key, old_key);
  EXPECT_EQ(refusal(check_signature(before, SignedKind::backup, old_key)), "");
  // The same for whoever logs in, whatever the role; nothing for nobody.
  must(add_user(*made.access, "Rita", Role::researcher, secret("rita's password"), kCheapKeyCost));
  made.access.reset();
  EXPECT_EQ(must(public_key_of(path)), "");
  const auto access = must(Access::open(path));
  must(access->log_in("Rita", secret("rita's password")));
  EXPECT_EQ(must(public_key_of(path)), key);
}

}  // namespace
}  // namespace isograsp::storage::signed_backups_test

// SPDX-License-Identifier: GPL-3.0-or-later
// What a signed list proves of an export: the file that was altered, added or is missing is named,
// and nothing outside of the folder is ever read.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/files.hpp"
#include "exports/export_list.hpp"
#include "exports/research_export.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/signing.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/every.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::exports::signed_exports_test {
namespace {

namespace fs = std::filesystem;
using test::must;

class SignedExport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    store_ = *storage::open_store(folder_->path("clinic.db"), storage::OpenMode::create);
    test::DemoSession demo;
    demo.date = "2026-03-02";
    test::add_session(*store_, "TK-104", demo);
  }
  static void TearDownTestSuite() {
    store_.reset();
    folder_.reset();
  }
  void SetUp() override {
    fs::remove_all(out_);
    must(write_export(*store_, {}, ExportFormat::csv, out_));
    key_ = must(storage::public_key_of(folder_->path("clinic.db")));
    files_ = test::files_below(out_);
    std::erase_if(files_,
                  [](const auto& name) { return name == kExportList || name == kExportSignature; });
  }
  /// What is wrong, or why it cannot be said; empty: nothing.
  [[nodiscard]] std::vector<std::string> wrong(const std::string& key = "") const {
    const auto proof = prove_export(out_, key);
    if (!proof) return {proof.error().message()};
    std::vector<std::string> all;
    for (const Text& one : proof->problems) all.push_back(english(one));
    return all;
  }
  [[nodiscard]] std::string at(const std::string& name) const { return out_ + "/" + name; }
  [[nodiscard]] std::string list() const { return read_text(at(kExportList)).value(); }
  /// A list that somebody else has made and signed with a key of their own.
  void replace_list(const std::string& text) const {
    must(write_text(at(kExportList), text));
    const std::string other = folder_->path("other.db");
    must(storage::open_store(other, storage::OpenMode::create));
    must(storage::sign_file(other, at(kExportList), storage::SignedKind::export_list));
  }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
  static inline std::unique_ptr<storage::SessionStore> store_;
  std::string out_ = folder_->path("out");
  std::string key_;
  std::vector<std::string> files_;
};

using Wrong = std::vector<std::string>;

TEST_F(SignedExport, OfEveryFormatProves) {
  for (const auto format :
       {ExportFormat::csv, ExportFormat::hdf5, ExportFormat::bids, ExportFormat::fhir}) {
    fs::remove_all(out_);
    must(write_export(*store_, {}, format, out_));
    const auto proof = must(prove_export(out_, key_));
    EXPECT_TRUE(proof.problems.empty()) << name_of(format);
    EXPECT_EQ(proof.key, key_);
    EXPECT_EQ(proof.files + 2, test::files_below(out_).size());
    EXPECT_EQ(read_text(at(kExportSignature)).value().find("made"), std::string::npos)
        << "an export tells no dates";
  }
}

TEST_F(SignedExport, AFlippedBitOfAnyFileNamesTheFile) {
  for (const std::string& name : test::every(files_)) {
    const std::string good = read_text(at(name)).value();
    for (const std::size_t place : {std::size_t{0}, good.size() / 2, good.size() - 1}) {
      std::string bad = good;
      bad[place] = static_cast<char>(bad[place] ^ 1);
      must(write_text(at(name), bad));
      EXPECT_EQ(wrong(), Wrong{name + " was altered"});
    }
    must(write_text(at(name), good));
  }
  EXPECT_EQ(wrong(key_), Wrong{});
}

TEST_F(SignedExport, AFlippedBitOfListOrSignatureProvesNothing) {
  constexpr std::size_t kStep = 13;  // every bit of a byte has its turn
  for (const char* name : {kExportList, kExportSignature}) {
    const std::string good = read_text(at(name)).value();
    for (std::size_t bit = 0; bit < 8 * good.size(); bit += kStep) {
      std::string bad = good;
      bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << (bit % 8)));
      must(write_text(at(name), bad));
      EXPECT_FALSE(prove_export(out_).ok()) << name << " bit " << bit;
    }
    must(write_text(at(name), good));
  }
}

TEST_F(SignedExport, FilesThatWereAddedOrAreMissingAreNamed) {
  must(write_text(at("more.csv"), "t_s\n"));
  fs::remove(at(files_.front()));
  EXPECT_EQ(wrong(), (Wrong{"more.csv was added", files_.front() + " is missing"}));
}

TEST_F(SignedExport, LinksAndPipesAreNamedAndNotFollowed) {
  const std::string elsewhere = folder_->path("elsewhere");
  fs::rename(at(files_.front()), elsewhere);
  fs::create_symlink(elsewhere, at(files_.front()));
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  fs::create_directory_symlink(folder_->path("."), at("round"));
  EXPECT_EQ(wrong(),
            (Wrong{files_.front() + " is no plain file: it was added",
                   "pipe is no plain file: it was added", "round is no plain file: it was added",
                   files_.front() + " is missing"}));
  fs::remove(at(kExportList));
  fs::create_symlink(folder_->path("clinic.db"), at(kExportList));
  EXPECT_NE(wrong().front().find("no list"), std::string::npos);
}

TEST_F(SignedExport, AListThatIsCutProvesNothing) {
  const std::string good = list();
  for (std::size_t length = 0; length < good.size(); length += 37) {
    must(write_text(at(kExportList), good.substr(0, length)));
    EXPECT_FALSE(prove_export(out_).ok()) << length;
  }
}

TEST_F(SignedExport, NamesInAListThatLeadElsewhereAreRefused) {
  const std::string hash = list().substr(0, 64);
  for (const std::string name :
       {"../clinic.db", "/etc/passwd", "a/../../clinic.db", "./a.csv", "a//b.csv", "a/", "", ".",
        "..", "a\\b", "SHA256SUMS", "SHA256SUMS.sig", "a\tb", "a\rb"}) {
    replace_list(hash + "  " + name + "\n");
    EXPECT_NE(wrong().front().find("SHA256SUMS:1"), std::string::npos) << name;
  }
  const std::string good = hash + "  a.csv\n";
  for (const std::string& text : {good + good, hash + " a.csv\n", hash + "  a.csv", "\n" + good,
                                  hash.substr(1) + "  a.csv\n", "#" + good}) {
    replace_list(text);
    EXPECT_NE(wrong().front().find("no line of a list"), std::string::npos) << text;
  }
}

TEST_F(SignedExport, AnotherClinicsKeyIsTold) {
  replace_list(list());
  EXPECT_EQ(wrong(), Wrong{}) << "anybody can sign with a key of their own";
  EXPECT_NE(must(prove_export(out_)).key, key_);
  EXPECT_NE(wrong(key_).front().find("another key"), std::string::npos);
}

TEST_F(SignedExport, AListOfAnotherExportNamesWhatDiffers) {
  const std::string hdf5 = folder_->path("hdf5");
  must(write_export(*store_, {}, ExportFormat::hdf5, hdf5));
  for (const char* name : {kExportList, kExportSignature})
    fs::copy_file(hdf5 + "/" + name, at(name), fs::copy_options::overwrite_existing);
  EXPECT_EQ(wrong(key_).size(), files_.size() + 1);
}

TEST_F(SignedExport, WithoutASignatureItsListStillNamesFilesAndNoKey) {
  fs::remove(at(kExportSignature));
  EXPECT_EQ(must(prove_export(out_)).key, "");
  EXPECT_EQ(wrong(), Wrong{});
  fs::remove(at(kExportList));
  EXPECT_EQ(prove_export(out_).error().code, Error::Code::failed);
  EXPECT_EQ(prove_export(folder_->path("absent")).error().code, Error::Code::bad_input);
}

}  // namespace
}  // namespace isograsp::exports::signed_exports_test

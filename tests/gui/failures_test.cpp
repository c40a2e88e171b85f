// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong below the windows is told in the language of the windows: real failures of each
// layer, made here, leave no English sentence.
#include <QRegularExpression>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>

#include "core/files.hpp"
#include "device/config/device_config.hpp"
#include "device/recording/recording.hpp"
#include "device/sensors/force_device.hpp"
#include "exports/research_export.hpp"
#include "grasp_model/scene.hpp"
#include "gui/library/library_files.hpp"
#include "gui/words/texts.hpp"
#include "reports/findings/progress_report.hpp"
#include "session/library/library.hpp"
#include "session/resume.hpp"
#include "session/simulated_person.hpp"
#include "spoken.hpp"
#include "storage/access/accounts.hpp"
#include "storage/access/open_store.hpp"
#include "storage/care/backups.hpp"
#include "tests/support/every_language.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::failures_test {
namespace {

namespace fs = std::filesystem;

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class FailuresInEachLanguage : public QtTest, public ::testing::WithParamInterface<const char*> {
 protected:
  template <class T>
  void expect_translated(const Result<T>& result) {
    ASSERT_FALSE(result.ok());
    expect_translated(result.error());
  }
  void expect_translated(Error error) {
    error.file = folder_.path();  // names of files and keys are as somebody gave them
    error.field = "key";
    EXPECT_EQ(english_in(translated(error)), "") << translated(error).toStdString();
    EXPECT_EQ(english_in(translated(error.what)), "") << english(error.what);
    EXPECT_EQ(english_in(translated(error.remedy)), "") << english(error.remedy);
  }
  /// The first word that stands in English sentences only; not in what somebody wrote.
  [[nodiscard]] std::string english_in(QString text) const {
    text.remove(QString::fromStdString(folder_.path()));
    static const QRegularExpression kWritten(
        QStringLiteral("„[^“]*“|«[^»]*»|\"[^\"]*\"|'[^']*'|\\[\\[?\\w+\\]\\]?|\\w+://\\S*|/"
                       "\\S+|isograsp db \\w+|--[\\w-]+"));
    text.remove(kWritten);
    static const QRegularExpression kEnglishWords(QStringLiteral(
        "\\b(the|is|are|not|of|and|or|with|cannot|has|have|holds|no|this|that|it|its|give|"
        "write|check|add|choose|use|for|while|on|to|at|by|there|expected|saw|parsing|file|"
        "directory|reading|storing|from|sensor's|does|wrong|make|log|keep)\\b"));
    return kEnglishWords.match(text).captured().toStdString();
  }

  TemporaryFolder folder_;
  Spoken spoken_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(, FailuresInEachLanguage,
                         ::testing::ValuesIn(test::translated_languages()), test::code_of_language);

TEST_P(FailuresInEachLanguage, OfADeviceThatCannotBeOpened) {
  const auto config = folder_.write("device.toml", "format = \"isograsp-device-1\"\n");
  const auto empty = folder_.write("empty.csv", "");
  for (const std::string& uri :
       {std::string("no uri"),
        std::string("foo://bar"),
        std::string("sim://"),
        std::string("sim://healthy?seed=x"),
        std::string("sim://healthy?hand=third"),
        std::string("sim://healthy?colour=red"),
        std::string("sim://healthy?seed=1&seed=2"),
        std::string("replay://"),
        "replay://" + folder_.path("no.csv"),
        "replay://" + empty,
        "replay://" + empty + "?speed=0.001",
        "replay://" + folder_.path("no.log"),
        std::string("can://"),
        std::string("can://nothere0"),
        std::string("can://nothere0?protocol=x"),
        std::string("can://nothere0?protocol=rft"),
        std::string("udp://?protocol=rft"),
        std::string("udp://1,2,3?protocol=net-ft"),
        "serial://?config=" + folder_.path("none.toml"),
        "serial://" + folder_.path("ttyNone") + "," + folder_.path("tty1") + "," +
            folder_.path("tty2") + "?protocol=rft",
        "can://?config=" + config,
        "comedi://?config=" + kLibrary + "/devices/rft_three_fingers.toml",
        std::string("comedi:///dev/none?protocol=jr3-comedi")}) {
    SCOPED_TRACE(uri);
    expect_translated(open_device(uri));
  }
  expect_translated(session::simulated_traits(*Uri::parse("sim://nobody"), kLibrary));
}

TEST_P(FailuresInEachLanguage, OfADeviceFileThatIsWrong) {
  const auto good = *read_text(kLibrary + "/devices/rft_three_fingers.toml");
  for (const auto& [from, to] :
       {std::pair{"finger = \"thumb\"", "finger = \"toe\""},
        std::pair{"finger = \"thumb\"", "finger = \"index\""},
        std::pair{"filter_Hz = 30", "filter_Hz = 31"}, std::pair{"filter_Hz = ", "filter_kHz = "},
        std::pair{"protocol = ", "protocol = \"x\" #"}, std::pair{"format = \"", "format = \"x"}}) {
    SCOPED_TRACE(to);
    expect_translated(DeviceConfig::parse(replaced(good, from, to), "device.toml"));
  }
}

TEST_P(FailuresInEachLanguage, OfATaskSceneOrProtocolThatIsWrong) {
  const auto task = *read_text(kLibrary + "/tasks/grip_sine.toml");
  for (const std::string& text :
       {std::string(), std::string("format = 3\n"), task + "\nunknown = 1\n", task + "\n[open\n",
        task + "\na = \n", task + "\nb = \"text\n", task + "\nc = [1, 2\n", task + "\nd = 1_\n",
        replaced(task, "version = ", "version = \"x\" #"), replaced(task, "name = ", "name = 3 #"),
        replaced(task, "kind = ", "kind = \"dance\" #")}) {
    SCOPED_TRACE(text.substr(text.size() - std::min<std::size_t>(text.size(), 40)));
    expect_translated(tasks::parse_task(text, folder_.path("task.toml")));
  }
  const auto scene = *read_text(kLibrary + "/scenes/planar_block.toml");
  expect_translated(parse_scene(replaced(scene, "free = [", "free = [\"q\", "), "scene.toml"));
  expect_translated(parse_scene(replaced(scene, "free = [", "free = [3, "), "scene.toml"));
  expect_translated(parse_scene(replaced(scene, "mass_kg = ", "mass_kg = -"), "scene.toml"));
  const auto protocol = *read_text(kLibrary + "/protocols/short.toml");
  expect_translated(session::read_protocol(protocol + "\n[[step]]\ntasks = [\"none.toml\"]\n",
                                           "protocol.toml", kLibrary));
  expect_translated(
      session::read_protocol(protocol + "\n[[step]]\ntasks = []\n", "protocol.toml", kLibrary));
  expect_translated(session::load_task(folder_.path("none.toml")));
}

TEST_P(FailuresInEachLanguage, OfADatabaseThatCannotBeOpened) {
  expect_translated(storage::open_store(folder_.path("none.db"), storage::OpenMode::existing));
  expect_translated(storage::open_store(folder_.path("sub/none.db"), storage::OpenMode::create));
  expect_translated(storage::open_store(folder_.path(), storage::OpenMode::existing));
  expect_translated(storage::open_store("", storage::OpenMode::existing));
  expect_translated(
      storage::open_store(folder_.write("text.db", "no database"), storage::OpenMode::existing));
  const auto path = folder_.path("clinic.db");
  ASSERT_TRUE(storage::open_store(path, storage::OpenMode::create).ok());
  const auto set_format = [&](int version) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    constexpr int kUserVersion_byte = 63;
    file.seekp(kUserVersion_byte).put(static_cast<char>(version));
  };
  set_format(99);
  expect_translated(storage::open_store(path, storage::OpenMode::existing));
  set_format(1);
  expect_translated(storage::open_store(path, storage::OpenMode::existing));
}

TEST_P(FailuresInEachLanguage, OfWritingWhatCannotBeStored) {
  const auto path = folder_.path("clinic.db");
  auto store = *storage::open_store(path, storage::OpenMode::create);
  ASSERT_TRUE(store->add_patient("P-0427").ok());
  expect_translated(store->add_patient("P-0427"));
  expect_translated(store->add_patient("Maria"));
  expect_translated(store->end_session(99, {}));
  storage::PatientProfile profile;
  profile.onset_date = "yesterday";
  expect_translated(store->set_profile(1, profile));
  expect_translated(store->remove_primary_measure(99));
  expect_translated(reports::gather_progress(*store, "P-9999"));
  exports::ExportRequest request;
  request.patient = "P-9999";
  expect_translated(exports::list_export(*store, request));
}

TEST_P(FailuresInEachLanguage, OfAFullDisk) {
  auto store = *storage::open_store(folder_.path("clinic.db"), storage::OpenMode::create);
  const auto former_signal = std::signal(SIGXFSZ, SIG_IGN);
  rlimit former{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &former), 0);
  rlimit none = former;
  none.rlim_cur = 100;  // bytes: what a file may grow to
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
  const auto added = store->add_patient("P-0427");
  const auto written = write_text(folder_.path("large.toml"), std::string(1000, 'x'));
  setrlimit(RLIMIT_FSIZE, &former);
  std::signal(SIGXFSZ, former_signal);
  expect_translated(added);
  expect_translated(written);
}

TEST_P(FailuresInEachLanguage, OfALogin) {
  const auto path = folder_.path("clinic.db");
  auto made = storage::Access::create(path, storage::Secret("a clinic by the sea"),
                                      &storage::kCheapKeyCost);
  ASSERT_TRUE(made.ok());
  storage::Access& access = *made->access;
  ASSERT_TRUE(storage::add_user(access, "Rosa", storage::Role::researcher,
                                storage::Secret("correct horse"), storage::kCheapKeyCost)
                  .ok());
  expect_translated(access.log_in("Rosa", storage::Secret("wrong horse")));
  expect_translated(access.log_in("Nobody", storage::Secret("wrong horse")));
  expect_translated(access.switch_user("Rosa", storage::Secret("1379")));
  expect_translated(access.log_in_with_recovery_key(storage::Secret("12")));
  Result<void> last;
  for (int i = 0; i < 12; ++i) last = access.log_in("Rosa", storage::Secret("wrong horse"));
  expect_translated(last);
}

TEST_P(FailuresInEachLanguage, OfADatabaseWithoutALogin) {
  const auto path = folder_.path("clinic.db");
  auto made = storage::Access::create(path, storage::Secret("a clinic by the sea"),
                                      &storage::kCheapKeyCost);
  ASSERT_TRUE(made.ok());
  auto store = storage::open_store(path, storage::OpenMode::existing);
  ASSERT_TRUE(store.ok());
  made->access->log_out();
  expect_translated(storage::open_store(path, storage::OpenMode::existing));
  expect_translated((*store)->add_patient("P-0427"));
}

TEST_P(FailuresInEachLanguage, OfTheOwnLibrary) {
  const LibraryFiles files(kLibrary, session::own_library_folder(folder_.path("clinic.db")));
  const auto shipped = files.list(LibraryKind::tasks).front();
  const auto text = *files.read(shipped);
  expect_translated(files.save(shipped, text, text, {}));
  folder_.write("clinic.library", "a file where a folder should be");
  expect_translated(files.duplicate(shipped, text));
}

TEST_P(FailuresInEachLanguage, OfABackup) {
  const auto path = folder_.write("clinic.db", "no database");
  expect_translated(storage::Backups(path).make(0));
  expect_translated(storage::restore_backup(folder_.path("none.db"), path));
}

}  // namespace
}  // namespace isograsp::gui::test::failures_test

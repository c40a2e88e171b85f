// SPDX-License-Identifier: GPL-3.0-or-later
// The clinic's own library beside the shipped one: nothing shipped is written, nothing that a
// stored trial used is overwritten, nothing typed is lost.
#include "gui/library/library_files.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "gui/library/library_use.hpp"
#include "kinematics/pose_task.hpp"
#include "session/library/library.hpp"
#include "storage/access/open_store.hpp"
#include "storage/crypto/content_hash.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::library_files_test {
namespace {

namespace fs = std::filesystem;
using isograsp::test::every;
using isograsp::test::TemporaryFolder;

const std::string kShipped = std::string(ISOGRASP_SOURCE_DIR) + "/library";

class OwnLibrary : public ::testing::Test {
 protected:
  [[nodiscard]] LibraryEntry shipped(LibraryKind kind, const std::string& file) const {
    for (const auto& entry : files_.list(kind))
      if (!entry.own && fs::path(entry.path).filename() == file) return entry;
    ADD_FAILURE() << file << " is not shipped";
    return {};
  }
  [[nodiscard]] std::string content_of(const LibraryEntry& entry) const {
    return files_.read(entry).value();
  }
  [[nodiscard]] LibraryEntry copy_of(LibraryKind kind, const std::string& file) const {
    const auto original = shipped(kind, file);
    auto copy = files_.duplicate(original, content_of(original));
    EXPECT_TRUE(copy.ok()) << copy.error().message();
    return *copy;
  }

  TemporaryFolder folder_;
  LibraryFiles files_{kShipped, session::own_library_folder(folder_.path("clinic.db"))};
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(OwnLibrary, StandsBesideTheDatabase) {
  EXPECT_EQ(session::own_library_folder("/data/clinic.db"), "/data/clinic.library");
  EXPECT_NE(session::own_library_folder("/data/clinic.db"),
            session::own_library_folder("/data/demo.db"));
}

TEST_F(OwnLibrary, EveryShippedFileIsListedSoundAndUnderANameOfItsOwn) {
  for (const auto& [kind, fewest] :
       {std::pair{LibraryKind::tasks, 8U}, std::pair{LibraryKind::scenes, 8U},
        std::pair{LibraryKind::protocols, 8U}, std::pair{LibraryKind::postures, 2U}}) {
    const auto entries = files_.list(kind);
    EXPECT_GE(entries.size(), fewest);
    for (const auto& entry : every(entries)) {
      EXPECT_TRUE(entry.sound) << entry.path;
      EXPECT_FALSE(entry.own);
      const auto good = files_.check_name(kind, content_of(entry), entry.path);
      EXPECT_TRUE(good.ok()) << good.error().message();
    }
  }
}

TEST_F(OwnLibrary, OnlyOneLineChangesWithTheNameOrTheVersion) {
  const std::string text =
      "# format = \"no\"\nformat = \"isograsp-task-1\"\nname = \"A\"  # for people\nkind = 1\n"
      "[table]\nversion = 7\n";
  EXPECT_EQ(name_in(text), "A");
  EXPECT_EQ(with_name(text, "B \"2\""), replaced(text, "\"A\"", R"("B \"2\"")"));
  EXPECT_EQ(name_in(with_name(text, "B \"2\"")), "B \"2\"");
  EXPECT_EQ(with_version(text, 3), replaced(text, "name =", "version = 3\nname ="))
      << "that of a table is another key";
  EXPECT_EQ(with_version("version = 1", 2), "version = 2\n");
}

TEST_F(OwnLibrary, ADuplicateIsAnOwnFileWithAFreeName) {
  const auto original = shipped(LibraryKind::tasks, "grip_sine.toml");
  const auto first = copy_of(LibraryKind::tasks, "grip_sine.toml");
  EXPECT_TRUE(first.own);
  EXPECT_EQ(first.name, original.name + " (copy)");
  EXPECT_EQ(first.path, files_.own() + "/tasks/grip_sine_copy.toml");
  const auto spec = session::load_task(first.path);
  ASSERT_TRUE(spec.ok());
  EXPECT_EQ(spec->name, first.name);
  EXPECT_EQ(spec->version, 1) << "it is another task: its versions begin anew";
  const auto second = files_.duplicate(first, content_of(first));
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(second->name, original.name + " (copy 2)");
  const auto listed = files_.list(LibraryKind::tasks);
  EXPECT_TRUE(listed[0].own && listed[1].own) << "own ones come first";
  EXPECT_EQ(content_of(original), content_of(shipped(LibraryKind::tasks, "grip_sine.toml")));
}

TEST_F(OwnLibrary, ADuplicateDoesNotMeetTheDraftOfAFileThatIsGone) {
  const auto first = copy_of(LibraryKind::tasks, "grip_sine.toml");
  ASSERT_TRUE(files_.keep_draft(first, "of the other one").ok());
  ASSERT_TRUE(files_.remove(first).ok());
  const auto second = copy_of(LibraryKind::tasks, "grip_sine.toml");
  EXPECT_FALSE(files_.draft(second).has_value());
}

TEST_F(OwnLibrary, EveryShippedFileCanBeDuplicatedAndUsed) {
  for (const auto kind :
       {LibraryKind::tasks, LibraryKind::scenes, LibraryKind::protocols, LibraryKind::postures})
    for (const auto& entry : every(files_.list(kind))) {
      const auto copy = files_.duplicate(entry, content_of(entry));
      ASSERT_TRUE(copy.ok()) << copy.error().message();
      EXPECT_TRUE(copy->sound) << entry.path;
    }
}

TEST_F(OwnLibrary, AnOwnTaskFindsOwnAndShippedScenesAndAShippedOneOnlyShipped) {
  const auto scene = copy_of(LibraryKind::scenes, "planar_block.toml");
  const auto task = copy_of(LibraryKind::tasks, "two_target.toml");
  const auto found = [&](const std::string& name, const LibraryEntry& by) {
    const auto path = session::find_in_library(kShipped, "scenes", name, by.path);
    return path ? fs::path(*path) : fs::path();
  };
  EXPECT_EQ(found("planar_block_copy", task), fs::path(scene.path));
  EXPECT_EQ(found("planar_block", task), fs::path(kShipped) / "scenes/planar_block.toml");
  EXPECT_TRUE(found("planar_block_copy", shipped(LibraryKind::tasks, "two_target.toml")).empty());
  const auto text = content_of(copy_of(LibraryKind::protocols, "short.toml"));
  const auto path = files_.own() + "/protocols/mine.toml";
  EXPECT_TRUE(
      session::read_protocol(replaced(text, "two_target", "two_target_copy"), path, kShipped).ok());
  EXPECT_FALSE(session::read_protocol(replaced(text, "two_target", "absent"), path, kShipped).ok());
}

TEST_F(OwnLibrary, ShippedFilesAreNeitherSavedNorRemoved) {
  const auto entry = shipped(LibraryKind::tasks, "grip_sine.toml");
  const auto text = content_of(entry);
  EXPECT_FALSE(files_.save(entry, text, text + "# mine\n", {}).ok());
  EXPECT_FALSE(files_.remove(entry).ok());
  EXPECT_EQ(content_of(entry), text);
}

TEST_F(OwnLibrary, ATextThatNoTrialUsedIsReplaced) {
  const auto entry = copy_of(LibraryKind::tasks, "grip_sine.toml");
  const auto former = content_of(entry);
  const auto text = replaced(former, "duration_s = 30", "duration_s = 20");
  const auto saved = files_.save(entry, former, text, {});
  ASSERT_TRUE(saved.ok()) << saved.error().message();
  EXPECT_EQ(content_of(entry), text);
  EXPECT_EQ(saved->version, 1);
  EXPECT_FALSE(saved->raised);
  EXPECT_FALSE(fs::exists(files_.own() + "/history"));
}

TEST_F(OwnLibrary, ATextThatATrialUsedIsKeptAndTheTaskGetsTheNextVersion) {
  const auto entry = copy_of(LibraryKind::tasks, "grip_sine.toml");
  const auto former = content_of(entry);
  auto text = replaced(former, "duration_s = 30", "duration_s = 20");
  const auto saved = files_.save(entry, former, text, {true, 4});
  ASSERT_TRUE(saved.ok());
  EXPECT_TRUE(saved->raised);
  EXPECT_EQ(saved->version, 5) << "above every version that was used";
  EXPECT_EQ(session::load_task(entry.path)->version, 5);
  EXPECT_EQ(read_text(saved->kept).value(), former);
  const auto again = files_.save(entry, saved->text, saved->text + "# more\n", {true, 5});
  ASSERT_TRUE(again.ok());
  EXPECT_NE(again->kept, saved->kept) << "nothing in the history is overwritten";
  EXPECT_EQ(read_text(saved->kept).value(), former);
  const auto by_hand = replaced(again->text, "version = 6", "version = 9");
  EXPECT_EQ(files_.save(entry, again->text, by_hand, {true, 6})->version, 9);
}

TEST_F(OwnLibrary, WhatCannotBeReadIsNotSaved) {
  const auto entry = copy_of(LibraryKind::tasks, "two_target.toml");
  const auto former = content_of(entry);
  for (const auto& text :
       {former + "unknown_key = 1\n", replaced(former, "scene = \"", "scene = \"no_"),
        std::string("name = ")}) {
    EXPECT_FALSE(files_.save(entry, former, text, {}).ok()) << text;
    EXPECT_EQ(content_of(entry), former);
  }
  const auto taken = with_name(former, shipped(LibraryKind::tasks, "two_target.toml").name);
  const auto refused = files_.save(entry, content_of(entry), taken, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "name");
}

TEST_F(OwnLibrary, AFileThatSomebodyElseChangedIsNotOverwritten) {
  const auto entry = copy_of(LibraryKind::scenes, "firm_block.toml");
  const auto former = content_of(entry);
  ASSERT_TRUE(write_text(entry.path, former + "# theirs\n").ok());
  EXPECT_FALSE(files_.save(entry, former, former + "# mine\n", {}).ok());
  EXPECT_EQ(content_of(entry), former + "# theirs\n");
}

TEST_F(OwnLibrary, WhatWasRemovedComesBack) {
  const auto entry = copy_of(LibraryKind::protocols, "short.toml");
  const auto text = content_of(entry);
  const auto removed = files_.remove(entry);
  ASSERT_TRUE(removed.ok());
  EXPECT_FALSE(fs::exists(entry.path));
  ASSERT_TRUE(files_.bring_back(*removed, entry).ok());
  EXPECT_EQ(content_of(entry), text);
  const auto again = files_.remove(entry);
  ASSERT_TRUE(write_text(entry.path, "another").ok());
  EXPECT_FALSE(files_.bring_back(*again, entry).ok()) << "nothing is overwritten";
  EXPECT_EQ(content_of(entry), "another");
}

TEST_F(OwnLibrary, ADraftOutlivesTheProgramAndGoesWithSave) {
  const auto entry = copy_of(LibraryKind::tasks, "grip_sine.toml");
  const auto former = content_of(entry);
  ASSERT_TRUE(files_.keep_draft(entry, "name = ").ok());
  const LibraryFiles later(kShipped, files_.own());
  EXPECT_EQ(later.draft(entry), "name = ");
  EXPECT_TRUE(later.list(LibraryKind::tasks).front().draft);
  EXPECT_EQ(content_of(entry), former) << "the file itself is untouched";
  ASSERT_TRUE(later.save(entry, former, former + "# more\n", {}).ok());
  EXPECT_FALSE(later.draft(entry).has_value());
}

TEST(LibraryUse, ATaskOfAProtocolThatIsFollowedCountsAsUsed) {
  const auto former = read_text(kShipped + "/tasks/grip_sine.toml").value();
  const int version = tasks::parse_task(former, "").value().version;
  FileUse use;
  count_as_used(use, LibraryKind::tasks, former, former + "# more\n");
  EXPECT_TRUE(use.used);
  EXPECT_EQ(use.newest_version, version) << "trials to come will carry it";
  FileUse renamed;
  count_as_used(renamed, LibraryKind::tasks, former, with_name(former, "Another"));
  EXPECT_EQ(renamed.newest_version, 0);
}

TEST_F(OwnLibrary, APostureFileIsDuplicatedSavedAndItsUsedTextKept) {
  const auto original = shipped(LibraryKind::postures, "screw.toml");
  const auto entry = copy_of(LibraryKind::postures, "screw.toml");
  EXPECT_TRUE(entry.sound);
  EXPECT_EQ(entry.path, files_.own() + "/postures/screw_copy.toml");
  EXPECT_FALSE(files_.save(original, content_of(original), content_of(entry), {}).ok());
  const auto former = content_of(entry);
  const auto text = replaced(former, "name = \"screw\"", "name = \"in\"");
  EXPECT_FALSE(files_.save(entry, former, replaced(former, "[[posture]]", "[[pose]]"), {}).ok());
  FileUse use;
  use.used = true;
  const auto saved = files_.save(entry, former, text, use);
  ASSERT_TRUE(saved.ok()) << saved.error().message();
  EXPECT_EQ(saved->kept, files_.own() + "/history/postures/screw_copy-1.toml");
  EXPECT_EQ(read_text(saved->kept).value(), former);
  EXPECT_EQ(content_of(entry), text);
  EXPECT_EQ(content_of(original), content_of(shipped(LibraryKind::postures, "screw.toml")));
}

TEST_F(OwnLibrary, ANewFileHasANameAndAPlaceOfItsOwn) {
  const auto text =
      with_name(content_of(shipped(LibraryKind::postures, "screw.toml")), "Recorded postures");
  const auto first = files_.add(LibraryKind::postures, "recorded", text);
  ASSERT_TRUE(first.ok()) << first.error().message();
  EXPECT_EQ(first->path, files_.own() + "/postures/recorded.toml");
  EXPECT_EQ(content_of(*first), text);
  const auto second = files_.add(LibraryKind::postures, "recorded", text);
  ASSERT_TRUE(second.ok()) << second.error().message();
  EXPECT_EQ(second->path, files_.own() + "/postures/recorded_2.toml");
  EXPECT_EQ(second->name, "Recorded postures (2)");
  EXPECT_EQ(name_in(content_of(*second)), second->name);
  EXPECT_FALSE(files_.add(LibraryKind::postures, "recorded", "name = \"no file\"\n").ok());
}

TEST_F(OwnLibrary, ATaskThatNamesPosturesThatAreNotThereCannotBeUsed) {
  const auto entry = copy_of(LibraryKind::tasks, "arm_screw.toml");
  const auto text = content_of(entry);
  const auto other = replaced(text, "\"screw\"", "\"mine\"");
  const auto refused = files_.check(LibraryKind::tasks, other, entry.path);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "postures");
  const auto postures = content_of(shipped(LibraryKind::postures, "screw.toml"));
  ASSERT_TRUE(files_.add(LibraryKind::postures, "mine", with_name(postures, "Mine")).ok());
  EXPECT_TRUE(files_.check(LibraryKind::tasks, other, entry.path).ok());
}

TEST(LibraryUse, IsFoundInTheTextsOfStoredTrialsAndSessions) {
  TemporaryFolder folder;
  auto store = *storage::open_store(folder.path("clinic.db"), storage::OpenMode::create);
  const auto patient = store->add_patient("P-4T8R2").value();
  storage::SessionRecord session;
  session.patient_id = patient.id;
  session.started_utc = "2026-03-02T09:00:00Z";
  session.device_uri = "sim://healthy";
  session.protocol_text = "the protocol";
  const auto session_id = store->begin_session(session).value();
  const auto add_trial = [&](int number, const std::string& text, int version,
                             const std::string& scene = "the scene") {
    storage::TrialRecord trial;
    trial.session_id = session_id;
    trial.number = number;
    trial.task_name = "Sine";
    trial.task_version = version;
    trial.task_text = text;
    trial.scene_text = scene;
    trial.groups = {{"force", {"t_s"}}};
    const auto id = store->begin_trial(trial);
    ASSERT_TRUE(id.ok()) << id.error().message();
    trial.id = *id;
    trial.status = storage::TrialStatus::completed;
    ASSERT_TRUE(store->end_trial(trial, {}).ok());
  };
  const std::string first = "name = \"Sine\"\nversion = 1\n";
  const std::string second = "name = \"Sine\"\nversion = 2\n";
  add_trial(1, first, 1);
  add_trial(2, second + "\n[chosen]\nlevel = 0.3\n", 2);
  const auto use = [&](LibraryKind kind, const std::string& former, const std::string& text) {
    return use_of(*store, kind, former, text).value();
  };
  EXPECT_TRUE(use(LibraryKind::tasks, first, first).used);
  EXPECT_TRUE(use(LibraryKind::tasks, second, second).used) << "at a level of its difficulty";
  EXPECT_FALSE(use(LibraryKind::tasks, second + "# new\n", second).used);
  EXPECT_EQ(use(LibraryKind::tasks, second, second + "# new\n").newest_version, 2);
  EXPECT_EQ(use(LibraryKind::tasks, second, second).newest_version, 1)
      << "the text of version 2 may be saved again as it was";
  EXPECT_EQ(use(LibraryKind::tasks, second, "name = \"Other\"\n").newest_version, 0);
  EXPECT_TRUE(use(LibraryKind::scenes, "the scene", "").used);
  EXPECT_FALSE(use(LibraryKind::scenes, "the scen", "").used);
  EXPECT_TRUE(use(LibraryKind::protocols, "the protocol", "").used);
  EXPECT_FALSE(use(LibraryKind::protocols, "another", "").used);
  EXPECT_TRUE(use(LibraryKind::postures, "the scene", "").used) << "a reference that moves";
  EXPECT_FALSE(use(LibraryKind::postures, "the postures", "").used);
  PoseTask compiled;
  compiled.name = "Turn";
  compiled.frame = "object";
  compiled.position_tolerance_m = compiled.angle_tolerance_rad = 0.1;
  compiled.time_limit_s = 10.0;
  compiled.references = {{"in", Pose{}}};
  compiled.targets = {0};
  compiled.postures_hash = storage::uuid_of("the postures");
  add_trial(3, first, 1, pose_task_text(compiled));
  EXPECT_TRUE(use(LibraryKind::postures, "the postures", "").used);
  EXPECT_FALSE(use(LibraryKind::postures, "others", "").used);
}

}  // namespace
}  // namespace isograsp::gui::test::library_files_test

// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that started anew has another zero than the one that was measured before: an unattended
// run begins no trial with it, like the windows. Real datagrams of emulated boxes, in real time.
#include <gtest/gtest.h>

#include "device/config/net_ft_sensor.hpp"
#include "session/platform/zeroing.hpp"
#include "session/protocol/protocol_run.hpp"
#include "storage/access/open_store.hpp"
#include "tests/device/net_ft_boxes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::outdated_zero_test {
namespace {

constexpr const char* kLibrary = ISOGRASP_SOURCE_DIR "/library";

/// Three boxes in a pause between two trials; the power of one dips there.
class BoxesAtRest {
 public:
  BoxesAtRest() : boxes_(options(), at_rest()) {
    static_cast<void>(folder_.write(
        "short.toml",
        "format = \"isograsp-task-1\"\nname = \"Free handling\"\ninstruction = \"Move.\"\n"
        "version = 1\nkind = \"observe\"\nscene = \"firm_block\"\nduration_s = 1\n"));
    protocol_ = folder_.write(
        "p.toml",
        "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\nkind = \"instrument_zero\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"short.toml\"\n"
        "[[step]]\nkind = \"pause\"\nduration_s = 20\n"
        "[[step]]\nkind = \"task\"\ntask = \"short.toml\"\n");
  }

  Result<ProtocolResult> run(bool resume) {
    SessionConfig config;
    config.database = database();
    config.create_database = true;
    config.patient_code = "T-01";
    config.library = kLibrary;
    config.device_uri = "udp://" + boxes_.full_address(0) + "," + boxes_.full_address(1) + "," +
                        boxes_.full_address(2) + "?protocol=net-ft";
    const auto protocol = read_protocol(protocol_, kLibrary).value();
    config.protocol_name = protocol.spec.name;
    config.protocol_text = protocol.spec.text;
    config.resume = resume;
    const auto session = Session::open(config);
    if (!session) return session.error();
    return run_protocol(**session, protocol, {});
  }
  /// Of the newest session.
  [[nodiscard]] std::vector<storage::TrialRecord> stored_trials() const {
    const auto store = storage::open_store(database(), storage::OpenMode::read_only).value();
    return store->trials(store->recent_sessions(1).value().at(0).id).value();
  }

 private:
  [[nodiscard]] static EmulatorOptions options() {
    EmulatorOptions options;
    options.config = DeviceConfig::standard(kNetFtFamily);
    constexpr int kDither = 3;  // counts
    options.noise_counts = kDither;
    options.faults.push_back(*Fault::parse("dip=index@12s"));
    return options;
  }
  [[nodiscard]] static FingerPlay at_rest() {
    FingerPlay play;
    play.t_s = {0.0};
    play.wrench_C = {FingerWrenches{}};
    return play;
  }
  [[nodiscard]] std::string database() const { return folder_.path("clinic.db"); }

  test::TemporaryFolder folder_;
  std::string protocol_;
  test::Boxes boxes_;
};

/// The dip is that of the index. A computer that is held up for long keeps an emulated box waiting,
/// which its driver takes for one that began anew; then this run proves nothing.
bool held_up(const Error& error) {
  const std::string said = error.message();
  return said.find("started anew") != std::string::npos &&
         said.find("(index)") == std::string::npos;
}

TEST(OutdatedZero, NoTrialOfAnUnattendedRunBeginsWithItAndResumingBeginsWithANewOne) {
  BoxesAtRest boxes;
  const auto refused = boxes.run(false);
  ASSERT_FALSE(refused) << "a trial was measured with the zero of another sensor";
  if (held_up(refused.error())) GTEST_SKIP() << "this computer held up a box";
  EXPECT_EQ(refused.error().code, Error::Code::failed) << "status 1";
  const std::string said = refused.error().message();
  EXPECT_NE(said.find("since the zero was set a sensor started anew (index)"), std::string::npos)
      << said;
  EXPECT_NE(said.find("--resume"), std::string::npos) << said;
  ASSERT_EQ(boxes.stored_trials().size(), 1u) << "what was measured before stays, and nothing else";
  EXPECT_EQ(boxes.stored_trials()[0].status, storage::TrialStatus::completed);

  const auto resumed = boxes.run(true);
  if (!resumed && held_up(resumed.error())) GTEST_SKIP() << "this computer held up a box";
  ASSERT_TRUE(resumed) << resumed.error().message();
  ASSERT_EQ(resumed->trials.size(), 1u) << "the one that is left";
  EXPECT_EQ(resumed->trials[0].trial.status, storage::TrialStatus::completed);
}

TEST(OutdatedZero, RecordedForcesHaveHadTheirsAndAMissingOneIsNotOutdated) {
  static_assert(standing_of_zero(true, false, true) == ZeroStanding::good);
  static_assert(standing_of_zero(false, false, true) == ZeroStanding::missing);
  static_assert(standing_of_zero(false, true, false) == ZeroStanding::good);
  static_assert(standing_of_zero(false, true, true) == ZeroStanding::outdated);
}

}  // namespace
}  // namespace isograsp::session::outdated_zero_test

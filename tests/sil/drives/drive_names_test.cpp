// Drive names: one folder a drive, never two drives in one.
#include "sil/studies/drives/drive_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

TEST(DriveNames, AreThoseOfTheFilesWithoutEnding) {
    EXPECT_THAT(sil::drive_names({"a/slalom.csv", "fishhook.2.log"}),
                testing::ElementsAre("slalom", "fishhook.2"));
}

TEST(DriveNames, BearTheFolderWhereFilesAreCalledTheSame) {
    EXPECT_THAT(sil::drive_names({"runs/slalom/signals.csv", "runs/j-turn/signals.csv", "x/other.csv"}),
                testing::ElementsAre("slalom_signals", "j-turn_signals", "other"));
}

TEST(DriveNames, AreNumberedWhereFoldersAreCalledTheSameToo) {
    EXPECT_THAT(sil::drive_names({"a/run/signals.csv", "b/run/signals.csv", "b/run/signals.csv"}),
                testing::ElementsAre("run_signals", "run_signals_2", "run_signals_3"));
}

TEST(DriveNames, NeverLeadOutOfTheOutputFolder) {
    EXPECT_THAT(sil::drive_names({".."}), testing::ElementsAre("drive"));
    EXPECT_THAT(sil::drive_names({"/"}), testing::ElementsAre("drive"));
}

}  // namespace

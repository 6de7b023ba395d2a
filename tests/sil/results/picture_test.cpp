// Pictures: the drawing script on an invented run, and what it says when its input is missing.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/sil/results/example_run.hpp"
#include "tests/support/full_disk.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;

int draw(const std::filesystem::path& folder, const std::filesystem::path& messages) {
    const std::string command =
        std::string(RSI_DRAW_SCRIPT) + " '" + folder.string() + "' > '" + messages.string() + "' 2>&1";
    return std::system(command.c_str());
}

void expect_four_pictures(const example_run::Options& options) {
    const ScratchFolder folder;
    example_run::write(options, folder.path());
    ASSERT_EQ(draw(folder.path(), folder.path() / "messages"), 0) << text_of(folder.path() / "messages");
    EXPECT_EQ(text_of(folder.path() / "messages"), "");
    for (const std::string picture : {"run", "stability_boundary"}) {
        const std::string png = text_of(folder.path() / (picture + ".png"));
        EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
        EXPECT_GT(png.size(), 10'000U);
        const std::string svg = text_of(folder.path() / (picture + ".svg"));
        EXPECT_NE(svg.find("</svg>"), std::string::npos);
        EXPECT_NE(svg.find("RSI threshold"), std::string::npos);
        EXPECT_EQ(svg.find("NaN"), std::string::npos);
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        EXPECT_EQ(entry.path().filename().string().find(".partial"), std::string::npos) << entry.path();
    }
}

TEST(Picture, ARunThatRollsOverIsDrawn) {
    expect_four_pictures({});
}

TEST(Picture, ARightTurnIsDrawn) {
    example_run::Options options;
    options.direction = -1.0;
    options.noise_share = 1.0;
    expect_four_pictures(options);
}

TEST(Picture, ARunWithoutAnyEventIsDrawn) {
    example_run::Options options;
    options.steady_acceleration_g = 0.0;
    expect_four_pictures(options);
}

TEST(Picture, AMissingInputFileIsNamed) {
    const ScratchFolder folder;
    example_run::write({}, folder.path());
    std::filesystem::remove(folder.path() / "events.gp");
    EXPECT_NE(draw(folder.path(), folder.path() / "messages"), 0);
    EXPECT_NE(text_of(folder.path() / "messages").find("events.gp is missing"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "run.png"));
}

// gnuplot itself says nothing of it and leaves what there was room for.
TEST(Picture, AFullDiskLeavesNoHalfOfAPicture) {
    const ScratchFolder folder;
    example_run::write({}, folder.path());
    {
        const test_support::FullDisk full{8192U};
        EXPECT_NE(draw(folder.path(), folder.path() / "messages"), 0);
    }
    EXPECT_NE(text_of(folder.path() / "messages").find("is there room on the disk?"), std::string::npos);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        const std::string ending = entry.path().extension().string();
        EXPECT_TRUE(ending != ".svg" && ending != ".png" && ending != ".partial") << entry.path();
    }
}

TEST(Picture, AMissingFolderIsNamed) {
    const ScratchFolder folder;
    EXPECT_NE(draw(folder.path() / "nowhere", folder.path() / "messages"), 0);
    EXPECT_NE(text_of(folder.path() / "messages").find("nowhere"), std::string::npos);
}

}  // namespace

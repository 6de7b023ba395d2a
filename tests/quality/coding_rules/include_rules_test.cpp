// The tree keeps to "who may know whom", and a planted breach of each rule is found.
#include "tests/quality/coding_rules/include_rules.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;

TEST(IncludeRules, TheTreeKeepsThem) {
    for (const std::string& found : rsi_test::forbidden_includes(RSI_PROJECT_ROOT)) {
        ADD_FAILURE() << found;
    }
}

TEST(IncludeRules, NoFoldersOfTheTreeUseEachOther) {
    for (const std::string& found : rsi_test::folder_circles(RSI_PROJECT_ROOT)) {
        ADD_FAILURE() << found;
    }
}

struct Include {
    const char* path;
    const char* header;
};

class Forbidden : public ::testing::TestWithParam<Include> {};

TEST_P(Forbidden, IsRefused) {
    EXPECT_NE(rsi_test::objection(GetParam().path, GetParam().header), "")
        << GetParam().path << " including " << GetParam().header;
}

INSTANTIATE_TEST_SUITE_P(
    IncludeRules, Forbidden,
    ::testing::Values(Include{"firmware/rsi/component.cpp", "rsi/can_dbc/codec.hpp"},
                      Include{"firmware/rsi/component.cpp", "rsi/hal/clock.hpp"},
                      Include{"firmware/rsi/component.cpp", "rsi/ecu/application/ecu.hpp"},
                      Include{"firmware/rsi/model/a.cpp", "sil/world/vehicle/truth.hpp"},
                      Include{"firmware/rsi/model/a.cpp", "cmath"},
                      Include{"firmware/rsi/component.cpp", "Eigen/Core"},
                      Include{"firmware/calibrations/generated/a.h", "math.h"},
                      Include{"firmware/selftest/selftest.c", "stdio.h"},
                      Include{"firmware/selftest/selftest.c", "rsi/ecu/application/rollover_ecu.hpp"},
                      Include{"firmware/rsi/model/a.cpp", "vector"}, Include{"firmware/rsi/rsi.h", "math.h"},
                      Include{"firmware/rsi/model/a.cpp", "../component.hpp"},
                      Include{"can_dbc/include/rsi/can_dbc/codec.hpp", "rsi/rsi.h"},
                      Include{"can_dbc/include/rsi/can_dbc/codec.hpp", "rsi/language.hpp"},
                      Include{"can_dbc/include/rsi/can_dbc/codec.hpp", "linux/can.h"},
                      Include{"can_dbc/include/rsi/can_dbc/codec.hpp", "rsi/hal/can_bus.hpp"},
                      Include{"hal/interface/rsi/hal/can_bus.hpp", "rsi/can_dbc/codec.hpp"},
                      Include{"hal/interface/rsi/hal/can_bus.hpp", "hal/socketcan/bus.hpp"},
                      Include{"hal/interface/rsi/hal/can_bus.hpp", "linux/can.h"},
                      Include{"firmware/rsi/component.cpp", "rsi/ecu/monitoring/degradation.hpp"},
                      Include{"firmware/rsi/ecu/monitoring/a.cpp", "rsi/can_dbc/codec.hpp"},
                      Include{"firmware/rsi/ecu/monitoring/a.cpp", "rsi/hal/clock.hpp"},
                      Include{"firmware/rsi/ecu/monitoring/a.cpp", "rsi/ecu/application/ecu.hpp"},
                      Include{"firmware/rsi/ecu/access/a.cpp", "rsi/ecu/application/ecu.hpp"},
                      Include{"firmware/rsi/ecu/application/a.cpp", "rsi/ecu/diagnosis/iso_tp.hpp"},
                      Include{"firmware/rsi/ecu/diagnosis/a.cpp", "rsi/can_dbc/codec.hpp"},
                      Include{"firmware/rsi/ecu/access/a.cpp", "hal/software_keys/cmac.hpp"},
                      Include{"firmware/rsi/ecu/access/a.cpp", "rsi/ecu/xcp/slave.hpp"},
                      Include{"firmware/rsi/ecu/xcp/a.cpp", "rsi/ecu/application/calibration_pages.hpp"},
                      Include{"firmware/rsi/ecu/xcp/a.cpp", "rsi/rsi.h"},
                      Include{"hal/socketcan/bus.cpp", "rsi/rsi.h"},
                      Include{"hal/socketcan/bus.cpp", "rsi/ecu/application/ecu.hpp"},
                      Include{"hal/memory/bus.cpp", "sil/world/vehicle/truth.hpp"},
                      Include{"hal/memory/bus.cpp", "images/zynqmp_r5/ecu_image.hpp"},
                      Include{"firmware/images/zynqmp_r5/main.cpp", "sil/world/vehicle/truth.hpp"},
                      Include{"firmware/rsi/ecu/application/ecu.cpp", "hal/socketcan/bus.hpp"},
                      Include{"firmware/rsi/ecu/application/ecu.cpp", "sil/world/vehicle/truth.hpp"},
                      Include{"firmware/rsi/ecu/application/ecu.cpp", "sys/socket.h"},
                      Include{"sil/world/vehicle/body.cpp", "tests/rsi/support/nominal.hpp"},
                      Include{"elsewhere/a.cpp", "vector"}));

class Allowed : public ::testing::TestWithParam<Include> {};

TEST_P(Allowed, IsAccepted) {
    EXPECT_EQ(rsi_test::objection(GetParam().path, GetParam().header), "");
}

INSTANTIATE_TEST_SUITE_P(
    IncludeRules, Allowed,
    ::testing::Values(Include{"firmware/rsi/component.cpp", "rsi/rsi.h"},
                      Include{"firmware/rsi/numeric/matrix.hpp", "Eigen/Core"},
                      Include{"firmware/selftest/selftest.c", "math.h"},
                      Include{"firmware/rsi/component.cpp", "limits"},
                      Include{"firmware/rsi/rsi.h", "stdint.h"},
                      Include{"can_dbc/include/rsi/can_dbc/codec.hpp", "rsi/can_dbc/e2e/profile11.hpp"},
                      Include{"can_dbc/include/rsi/can_dbc/codec.hpp", "cstdint"},
                      Include{"hal/socketcan/bus.cpp", "rsi/hal/can_bus.hpp"},
                      Include{"firmware/images/zynqmp_r5/main.cpp", "rsi/ecu/application/rollover_ecu.hpp"},
                      Include{"hal/socketcan/bus.cpp", "linux/can.h"},
                      Include{"firmware/rsi/ecu/monitoring/a.cpp", "rsi/types.hpp"},
                      Include{"firmware/rsi/ecu/application/ecu.cpp", "rsi/ecu/monitoring/a.hpp"},
                      Include{"firmware/rsi/ecu/application/ecu.cpp", "rsi/can_dbc/codec.hpp"},
                      Include{"firmware/rsi/ecu/application/ecu.cpp", "rsi/hal/clock.hpp"},
                      Include{"sil/apps/ecu.cpp", "rsi/ecu/application/ecu.hpp"},
                      Include{"sil/apps/ecu.cpp", "toml++/toml.h"},
                      Include{"tests/rsi/a.cpp", "sil/world/vehicle/truth.hpp"}));

struct CMakeLine {
    const char* path;
    const char* line;
};

class ForbiddenInCMake : public ::testing::TestWithParam<CMakeLine> {};

TEST_P(ForbiddenInCMake, IsRefused) {
    EXPECT_NE(rsi_test::cmake_objection(GetParam().path, GetParam().line), "")
        << GetParam().path << ": " << GetParam().line;
}

INSTANTIATE_TEST_SUITE_P(
    IncludeRules, ForbiddenInCMake,
    ::testing::Values(CMakeLine{"firmware/images/a/CMakeLists.txt", "set(sil ${PROJECT_SOURCE_DIR}/sil)"},
                      CMakeLine{"firmware/images/a/CMakeLists.txt", "    ../../sil/apps/rsi_ecu.cpp)"},
                      CMakeLine{"firmware/CMakeLists.txt", "add_subdirectory(../tests/rsi)"},
                      CMakeLine{"firmware/rules.cmake", "    COMMAND ${PROJECT_SOURCE_DIR}/tests/run"},
                      CMakeLine{"hal/CMakeLists.txt",
                                "set(map \"${PROJECT_SOURCE_DIR}/tests/support/r5.ld\")"},
                      CMakeLine{"hal/CMakeLists.txt", "include(${CMAKE_SOURCE_DIR}/firmware/list.cmake)"},
                      CMakeLine{"can_dbc/CMakeLists.txt", "    DEPENDS sil/simulation/frames.cpp  # why"},
                      CMakeLine{"sil/CMakeLists.txt", "include_directories(${PROJECT_SOURCE_DIR}/tests)"}));

class AllowedInCMake : public ::testing::TestWithParam<CMakeLine> {};

TEST_P(AllowedInCMake, IsAccepted) {
    EXPECT_EQ(rsi_test::cmake_objection(GetParam().path, GetParam().line), "");
}

INSTANTIATE_TEST_SUITE_P(
    IncludeRules, AllowedInCMake,
    ::testing::Values(CMakeLine{"CMakeLists.txt", "add_subdirectory(sil/images)"},
                      CMakeLine{"cmake/target_program.cmake", "tests/targets/support/linux.cpp"},
                      CMakeLine{"firmware/CMakeLists.txt", "# what tests/targets/freestanding checks"},
                      CMakeLine{"firmware/CMakeLists.txt", "if(RSI_BUILD_TESTS AND RSI_BUILD_SIL)"},
                      CMakeLine{"firmware/CMakeLists.txt", "target_link_libraries(a PRIVATE sil_vehicle)"},
                      CMakeLine{"firmware/CMakeLists.txt", "add_library(a ${PROJECT_SOURCE_DIR}/hal/a.cpp)"},
                      CMakeLine{"sil/apps/CMakeLists.txt", "${PROJECT_SOURCE_DIR}/firmware/calibrations"},
                      CMakeLine{"tests/CMakeLists.txt", "${PROJECT_SOURCE_DIR}/sil/vehicles"}));

TEST(IncludeRules, APlantedPathInACMakeFileIsFoundByFileAndLine) {
    const test_support::ScratchFolder folder;
    const fs::path& root = folder.path();
    fs::create_directories(root / "hal/board");
    fs::create_directories(root / "firmware");
    std::ofstream(root / "hal/board/CMakeLists.txt")
        << "add_library(board start.S)\nset(map ../../tests/board.ld)\n";
    std::ofstream(root / "firmware/parts.cmake") << "set(log ${PROJECT_SOURCE_DIR}/sil/log.cpp)\n";
    const std::vector<std::string> found = rsi_test::forbidden_includes(root.string());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], "firmware/parts.cmake:1: a CMake file of firmware/ may not name a path of sil/");
    EXPECT_EQ(found[1], "hal/board/CMakeLists.txt:2: a CMake file of hal/ may not name a path of tests/");
}

// Code that only tests use belongs to them.
TEST(IncludeRules, EveryHeaderOfTheProductHasAUserInIt) {
    const std::vector<std::string> exceptions{
        "firmware/selftest/selftest.h",        // exported
        "hal/software_keys/mbedtls_config.h",  // named by a compile definition
        "sil/exchange/wheel/component.h",      // called from Python
        // Parts of a procedure that its source runs and a test takes one by one.
        "sil/studies/procedures/sine_with_dwell.hpp", "sil/studies/procedures/steady_circle.hpp",
        "sil/studies/procedures/tilt_table.hpp"};
    EXPECT_EQ(rsi_test::headers_without_user(RSI_PROJECT_ROOT), exceptions);
}

TEST(IncludeRules, APlantedHeaderThatOnlyItsSourceAndATestIncludeIsFound) {
    const test_support::ScratchFolder folder;
    const auto plant = [&folder](const std::string& path, const std::string& header) {
        fs::create_directories((folder.path() / path).parent_path());
        std::ofstream(folder.path() / path) << "#include \"" << header << "\"\n";
    };
    plant("sil/files/compare.hpp", "cstdint");
    plant("sil/files/compare.cpp", "sil/files/compare.hpp");
    plant("tests/sil/files/compare_test.cpp", "sil/files/compare.hpp");
    plant("sil/files/log.hpp", "cstdint");
    plant("sil/apps/main.cpp", "sil/files/log.hpp");
    EXPECT_EQ(rsi_test::headers_without_user(folder.path().string()),
              std::vector<std::string>{"sil/files/compare.hpp"});
}

// Directly, by way of a third folder, and between folders of a folder; a folder and one within it are no
// pair.
TEST(IncludeRules, PlantedCirclesOfFoldersAreFoundByFileAndLine) {
    const test_support::ScratchFolder folder;
    const auto plant = [&folder](const std::string& path, const std::string& header) {
        fs::create_directories((folder.path() / path).parent_path());
        std::ofstream(folder.path() / path) << "#pragma once\n#include \"" << header << "\"\n";
    };
    plant("sil/world/vehicle/truth.hpp", "sil/world/units.hpp");
    plant("sil/world/units.hpp", "sil/files/csv.hpp");
    plant("sil/files/csv.hpp", "sil/results/events.hpp");
    plant("sil/results/events.hpp", "cstdint");
    plant("firmware/rsi/model/a.hpp", "rsi/rsi.hpp");
    plant("firmware/rsi/rsi.hpp", "rsi/model/a.hpp");
    EXPECT_EQ(rsi_test::folder_circles(folder.path().string()), std::vector<std::string>{});

    plant("sil/results/events.hpp", "sil/world/vehicle/truth.hpp");
    plant("firmware/rsi/model/a.hpp", "../numeric/b.hpp");
    plant("firmware/rsi/numeric/b.hpp", "rsi/model/a.hpp");
    const std::string circle = ": folders use each other: ";
    EXPECT_EQ(
        rsi_test::folder_circles(folder.path().string()),
        (std::vector<std::string>{
            "firmware/rsi/model/a.hpp:2" + circle +
                "firmware/rsi/model -> firmware/rsi/numeric -> firmware/rsi/model",
            "firmware/rsi/numeric/b.hpp:2" + circle +
                "firmware/rsi/numeric -> firmware/rsi/model -> firmware/rsi/numeric",
            "sil/files/csv.hpp:2" + circle + "sil/files -> sil/results -> sil/world -> sil/files",
            "sil/results/events.hpp:2" + circle + "sil/results -> sil/world -> sil/files -> sil/results",
            "sil/world/units.hpp:2" + circle + "sil/world -> sil/files -> sil/results -> sil/world"}));
}

// The search itself: one breach among good lines, found with file and line.
TEST(IncludeRules, APlantedBreachIsFoundByFileAndLine) {
    const test_support::ScratchFolder folder;
    const fs::path& root = folder.path();
    fs::create_directories(root / "firmware/rsi/model");
    std::ofstream(root / "firmware/rsi/model/planted.cpp")
        << "// A comment.\n#include \"rsi/rsi.h\"\n  #  include <vector>\n#include <array>\n";
    std::ofstream(root / "firmware/rsi/notes.txt") << "#include <vector>\n";
    const std::vector<std::string> found = rsi_test::forbidden_includes(root.string());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0], "firmware/rsi/model/planted.cpp:3: firmware/rsi/ may not include vector");
}

}  // namespace

// Row file: what is finished survives, what is half is dropped, what is wrong is refused.
#include "sil/studies/campaign/row_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using test_support::ScratchFolder;
using test_support::text_of;
using test_support::write_text;
using testing::ElementsAre;
using testing::HasSubstr;

class RowFile : public ::testing::Test {
 protected:
    std::filesystem::path path() const { return folder_.path() / "runs.csv"; }
    void expect_refused(const std::string& why) const {
        const std::string before = text_of(path());
        try {
            const sil::RowFile file{path(), "run,value"};
            FAIL() << "was accepted";
        } catch (const sil::InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(why));
        }
        EXPECT_EQ(text_of(path()), before);
    }

 private:
    ScratchFolder folder_;
};

TEST_F(RowFile, IsSortedByRunWhenFinished) {
    sil::RowFile file{path(), "run,value"};
    file.append(10U, "10,a");
    file.append(9U, "9,b");
    file.append(2U, "2,c");
    EXPECT_EQ(text_of(path()), "run,value\n10,a\n9,b\n2,c\n");
    file.finish();
    EXPECT_EQ(text_of(path()), "run,value\n2,c\n9,b\n10,a\n");
}

TEST_F(RowFile, IsTakenUpWithWhatItHas) {
    write_text(path(), "run,value\n3,a\n1,b\n");
    sil::RowFile file{path(), "run,value"};
    EXPECT_THAT(file.finished_runs(), ElementsAre(1U, 3U));
    file.append(2U, "2,c");
    file.finish();
    EXPECT_EQ(text_of(path()), "run,value\n1,b\n2,c\n3,a\n");
}

TEST_F(RowFile, DropsALineThatWasCutOff) {
    write_text(path(), "run,value\n3,a\n1");
    sil::RowFile file{path(), "run,value"};
    EXPECT_THAT(file.finished_runs(), ElementsAre(3U));
    EXPECT_EQ(text_of(path()), "run,value\n3,a\n");
    file.append(1U, "1,b");
    EXPECT_EQ(text_of(path()), "run,value\n3,a\n1,b\n");
}

TEST_F(RowFile, DropsAWholeLookingLineWithoutItsEnd) {
    write_text(path(), "run,value\n3,a\n1,0.12");
    EXPECT_THAT((sil::RowFile{path(), "run,value"}.finished_runs()), ElementsAre(3U));
}

TEST_F(RowFile, BeginsAnewWhenEvenTheHeaderWasCutOff) {
    write_text(path(), "run,va");
    EXPECT_THAT((sil::RowFile{path(), "run,value"}.finished_runs()), testing::IsEmpty());
    EXPECT_EQ(text_of(path()), "run,value\n");
}

TEST_F(RowFile, RefusesADamagedLineByItsNumber) {
    write_text(path(), "run,value\n3,a\n4\n5,b\n");
    expect_refused("runs.csv:3:1: is not a row of 2 cells");
    write_text(path(), "run,value\nx,a\n5,b\n");
    expect_refused("runs.csv:2:1: is not a row");
}

TEST_F(RowFile, RefusesOtherColumns) {
    write_text(path(), "run,other\n3,a\n");
    expect_refused("runs.csv:1:1: has other columns");
}

}  // namespace

// Vehicle classes: the built-in ones, and what is refused.
#include "sil/studies/population/vehicle_class.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sil/files/file_io.hpp"
#include "sil/input_error.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace vehicle_class_test {
namespace {

using testing::HasSubstr;

std::string built_in_text() {
    return sil::read_whole_file(RSI_SOURCE_DIR "/sil/studies/population/classes.toml");
}

std::string replaced(const std::string& from, const std::string& to) {
    std::string text = built_in_text();
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return text.replace(position, from.size(), to);
}

void expect_refused(const std::string& text, const std::string& why) {
    try {
        sil::parse_vehicle_classes(text, "classes.toml");
        FAIL() << "was accepted";
    } catch (const sil::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

TEST(VehicleClass, TheBuiltInOnesAreThoseThatWereAskedFor) {
    std::vector<std::string> names;
    for (const sil::VehicleClass& one : sil::vehicle_classes()) {
        names.push_back(one.name);
    }
    EXPECT_THAT(names, testing::ElementsAre("small car", "sedan", "SUV", "van", "pick-up", "light truck",
                                            "heavy truck", "bus", "micro vehicle"));
}

TEST(VehicleClass, ErrorsAreNamed) {
    expect_refused(replaced("mass_kg = [900.0, 1350.0]\n", ""), "\"class.mass_kg\" is missing");
    expect_refused(replaced("mass_kg = [900.0, 1350.0]", "mass_kg = [1350.0, 900.0]"),
                   "\"class.mass_kg\" must be two numbers, [lowest, highest]");
    expect_refused(replaced("mass_kg = [900.0, 1350.0]", "mass_kg = [900.0]"), "\"class.mass_kg\"");
    expect_refused(replaced("[every_class]\n", "[every_class]\nwings = [1.0, 2.0]\n"),
                   "wings\" is not known");
    expect_refused(replaced("[[class]]\n", "[[class]]\nwings = [1.0, 2.0]\n"), "wings\" is not known");
    expect_refused(replaced("max_speed_kmh = 130.0", "max_speed_kmh = 1300.0"), "\"class.max_speed_kmh\"");
    expect_refused(replaced("mass_sensor = false ", "mass_sensor = 0 "),
                   "\"class.mass_sensor\" must be true or false");
    expect_refused(built_in_text().substr(0U, built_in_text().find("[[class]]")), "\"class\"");
}

TEST(VehicleClass, ALoadIsAMassAtAHeightOrAShareOfTheVehicle) {
    const sil::VehicleParameters van = sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/van.toml");
    const double mass = sil::total_mass_kg(van);
    sil::ClassLoad roof;
    roof.mass_kg = 150.0;
    roof.height_m = 2.5;
    const sil::VehicleParameters with_roof = sil::loaded(van, roof);
    EXPECT_NEAR(sil::total_mass_kg(with_roof), mass + 150.0, 1e-9);
    EXPECT_NEAR(with_roof.geometry.cg_height_m,
                (van.mass.sprung_kg * van.geometry.cg_height_m + 150.0 * 2.5) / (van.mass.sprung_kg + 150.0),
                1e-12);
    sil::ClassLoad share;
    share.mass_share = 0.15;
    share.height_factor = 1.5;
    const sil::VehicleParameters with_share = sil::loaded(van, share);
    EXPECT_NEAR(sil::total_mass_kg(with_share), 1.15 * mass, 1e-9);
    EXPECT_NEAR(with_share.geometry.cg_height_m,
                van.geometry.cg_height_m * (van.mass.sprung_kg + 1.5 * 0.15 * mass) /
                    (van.mass.sprung_kg + 0.15 * mass),
                1e-12);
}

TEST(VehicleClass, CarsCarryItOnTheRoofAndTrucksHalfOfThemselves) {
    for (const sil::VehicleClass& one : sil::vehicle_classes()) {
        if (one.name.find("truck") != std::string::npos) {
            EXPECT_EQ(one.load.mass_share, 0.5) << one.name;
        } else if (one.name == "van") {
            EXPECT_EQ(one.load.mass_share, 0.15);
            EXPECT_EQ(one.load.height_factor, 1.5);
        } else if (one.name != "bus") {
            EXPECT_EQ(one.load.mass_kg, one.name == "micro vehicle" ? 90.0 : 150.0) << one.name;
            EXPECT_GE(one.load.height_m, one.body_height_m.lowest) << one.name;
        }
    }
}

}  // namespace
}  // namespace vehicle_class_test

// Campaign settings from TOML: a file's own, and the built-in ones.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "default_campaign.hpp"
#include "sil/printable.hpp"
#include "sil/studies/campaign/settings.hpp"

namespace sil {
namespace {

// One table of the file; remembers where it is for the messages.
class Reader {
 public:
    Reader(const toml::table& table, std::string file) : table_{table}, file_{std::move(file)} {}

    void allow_only(std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, node] : table_) {
            bool known = false;
            for (const std::string_view allowed : keys) {
                known = known || key.str() == allowed;
            }
            if (!known) {
                fail(node, key.str(), "is not known here; remove it or correct its name");
            }
        }
    }

    void read(std::string_view key, double& value) const {
        if (const toml::node* node = table_.get(key)) {
            value = number(*node, key);
        }
    }

    void read(std::string_view key, std::uint64_t& value) const {
        if (const toml::node* node = table_.get(key)) {
            const auto given = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
            if (!given || *given < 0) {
                fail(*node, key, "must be a whole number, 0 or above");
            }
            value = static_cast<std::uint64_t>(*given);
        }
    }

    void read(std::string_view key, bool& value) const {
        if (const toml::node* node = table_.get(key)) {
            if (!node->is_boolean()) {
                fail(*node, key, "must be true or false");
            }
            value = *node->value<bool>();
        }
    }

    void read(std::string_view key, Interval& value) const {
        if (const toml::node* node = table_.get(key)) {
            const toml::array* ends = node->as_array();
            if (ends == nullptr || ends->size() != 2U) {
                fail(*node, key, "must be two numbers, [lowest, highest]");
            }
            value = {number((*ends)[0], key), number((*ends)[1], key)};
        }
    }

    std::string text(std::string_view key) const {
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            fail(table_, key, "is missing");
        }
        if (!node->is_string()) {
            fail(*node, key, "must be a text in quotation marks");
        }
        return *node->value<std::string>();
    }

    // The tables of [[key]]; none where the file has no such key.
    std::vector<Reader> tables(std::string_view key) const {
        std::vector<Reader> found;
        if (const toml::node* node = table_.get(key)) {
            const toml::array* all = node->as_array();
            if (all == nullptr) {
                fail(*node, key, fmt::format("must be written as [[{}]]", key));
            }
            for (const toml::node& one : *all) {
                if (!one.is_table()) {
                    fail(one, key, fmt::format("must be written as [[{}]]", key));
                }
                found.emplace_back(*one.as_table(), file_);
            }
        }
        return found;
    }

    const toml::table* table(std::string_view key) const {
        const toml::node* node = table_.get(key);
        if (node != nullptr && !node->is_table()) {
            fail(*node, key, fmt::format("must be written as [{}]", key));
        }
        return node == nullptr ? nullptr : node->as_table();
    }

    bool has(std::string_view key) const { return table_.get(key) != nullptr; }

 private:
    double number(const toml::node& node, std::string_view key) const {
        const auto value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value || !std::isfinite(*value)) {
            fail(node, key, "must be a number");
        }
        return *value;
    }

    [[noreturn]] void fail(const toml::node& node, std::string_view key, const std::string& what) const {
        throw CampaignError(
            fmt::format("{}:{}: \"{}\" {}", file_, node.source().begin.line, printable(key), what));
    }

    const toml::table& table_;
    std::string file_;
};

CampaignManoeuvre read_manoeuvre(const Reader& table) {
    table.allow_only({"name", "weight", "speed_factor", "steering_factor", "duration_s"});
    CampaignManoeuvre manoeuvre;
    manoeuvre.name = table.text("name");
    table.read("weight", manoeuvre.weight);
    table.read("speed_factor", manoeuvre.speed_factor);
    table.read("steering_factor", manoeuvre.steering_factor);
    table.read("duration_s", manoeuvre.duration_s);
    return manoeuvre;
}

CampaignVehicle read_vehicle(const Reader& table) {
    table.allow_only({"parameters", "calibration"});
    return {table.text("parameters"), table.text("calibration")};
}

void read_spread(const Reader& table, CampaignSpread& spread) {
    table.allow_only({"friction_factor", "load_share", "load_height_factor", "cg_height_error",
                      "stiffness_error", "mass_error", "accelerometer_bias_g", "sensor_noise",
                      "steering_sensor", "roll_sensor"});
    table.read("friction_factor", spread.friction_factor);
    table.read("load_share", spread.load_share);
    table.read("load_height_factor", spread.load_height_factor);
    table.read("cg_height_error", spread.cg_height_error);
    table.read("stiffness_error", spread.stiffness_error);
    table.read("mass_error", spread.mass_error);
    table.read("accelerometer_bias_g", spread.accelerometer_bias_g);
    table.read("sensor_noise", spread.sensor_noise);
    table.read("steering_sensor", spread.steering_sensor);
    table.read("roll_sensor", spread.roll_sensor);
}

// Puts what the table says over `settings`.
CampaignSettings read_settings(const toml::table& root, const std::string& file, CampaignSettings settings) {
    const Reader reader{root, file};
    reader.allow_only({"runs", "seed", "spread", "vehicle", "manoeuvre", "made_with"});
    reader.read("runs", settings.runs);
    reader.read("seed", settings.seed);
    if (const toml::table* spread = reader.table("spread")) {
        read_spread(Reader{*spread, file}, settings.spread);
    }
    if (reader.has("vehicle")) {
        settings.vehicles.clear();
        for (const Reader& table : reader.tables("vehicle")) {
            settings.vehicles.push_back(read_vehicle(table));
        }
    }
    if (reader.has("manoeuvre")) {
        settings.manoeuvres.clear();
        for (const Reader& table : reader.tables("manoeuvre")) {
            settings.manoeuvres.push_back(read_manoeuvre(table));
        }
    }
    try {
        check_campaign(settings);
    } catch (const CampaignError& error) {
        throw CampaignError(fmt::format("{}: {}", file, error.what()));
    }
    return settings;
}

}  // namespace

CampaignSettings default_campaign() {
    return read_settings(toml::parse(default_campaign_text), "built-in settings", {});
}

CampaignSettings load_campaign(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw CampaignError(fmt::format("{}: there is no such file", path.string()));
    }
    toml::table table;
    try {
        table = toml::parse_file(path.string());
    } catch (const toml::parse_error& error) {
        throw CampaignError(fmt::format("{}:{}: cannot be read as TOML: {}", path.string(),
                                        error.source().begin.line, error.description()));
    }
    static const CampaignSettings defaults = default_campaign();
    return read_settings(table, path.string(), defaults);
}

}  // namespace sil

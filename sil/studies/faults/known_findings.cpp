#include "sil/studies/faults/known_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "known_findings_text.hpp"
#include "sil/files/toml_table.hpp"
#include "sil/studies/faults/names.hpp"

namespace sil {
namespace {

std::vector<KnownFinding> read_known() {
    TomlTable file = TomlTable::parse(known_findings_text, "sil/studies/faults/known_findings.toml");
    std::vector<KnownFinding> all;
    for (TomlTable table : file.tables("finding")) {
        KnownFinding known;
        known.found.kind = named(table, "what", FindingKind::good_sensor_with_code);
        if (table.has("fault")) {
            known.found.fault = named(table, "fault", FaultKind::turned_about_z);
            known.found.place = named(table, "of", FaultPlace::all_signals);
        }
        known.cells = table.texts("cells");
        known.why = table.text("why");
        table.refuse_unknown_keys();
        all.push_back(std::move(known));
    }
    file.refuse_unknown_keys();
    return all;
}

std::string line(const FindingClass& found, const std::string& cell) {
    return fmt::format("{}: {}", describe(found), cell);
}

}  // namespace

bool operator==(const FindingClass& left, const FindingClass& right) {
    return left.kind == right.kind && left.fault == right.fault && left.place == right.place;
}

std::string describe(const FindingClass& found) {
    if (found.fault == FaultKind::none) {
        return to_string(found.kind);
    }
    return fmt::format("{}, {} of {}", to_string(found.kind), to_string(found.fault), to_string(found.place));
}

const std::vector<KnownFinding>& known_findings() {
    static const std::vector<KnownFinding> all = read_known();
    return all;
}

bool is_known(const FindingClass& found) {
    const std::vector<KnownFinding>& all = known_findings();
    return std::any_of(all.begin(), all.end(),
                       [&found](const KnownFinding& each) { return each.found == found; });
}

std::vector<std::string> differences(const std::vector<CellFinding>& found,
                                     const std::vector<KnownFinding>& known) {
    std::set<std::string> lines_found;
    for (const CellFinding& each : found) {
        lines_found.insert(line(each.found, each.cell));
    }
    std::set<std::string> lines_known;
    for (const KnownFinding& each : known) {
        for (const std::string& cell : each.cells) {
            lines_known.insert(line(each.found, cell));
        }
    }
    std::vector<std::string> all;
    const auto report = [&all](const std::set<std::string>& those, const std::set<std::string>& others,
                               const char* what) {
        for (const std::string& each : those) {
            if (others.count(each) == 0U) {
                all.push_back(fmt::format("{}: {}", what, each));
            }
        }
    };
    report(lines_found, lines_known, "not known");
    report(lines_known, lines_found, "known, but no longer found");
    return all;
}

}  // namespace sil

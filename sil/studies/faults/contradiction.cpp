#include "sil/studies/faults/contradiction.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "contradictions.hpp"
#include "sil/files/toml_table.hpp"
#include "sil/studies/faults/names.hpp"

namespace sil {
namespace {

// In the order of SceneKind; `over` follows from two of them.
constexpr std::array scene_names{"rest",     "straight",       "turn",   "before_turn",
                                 "steering", "before_warning", "warning"};
static_assert(scene_names.size() == std::tuple_size_v<decltype(Contradiction::limits_ms)>);

int milliseconds(TomlTable& table, std::string_view key) {
    return static_cast<int>(table.number(key, {0.0, 1.0e5}));
}

void read_limits(TomlTable table, Contradiction& contradiction) {
    for (std::size_t scene = 0U; scene < scene_names.size(); ++scene) {
        for (const char* name : {"every_scene", scene_names[scene]}) {
            if (table.has(name)) {
                contradiction.limits_ms[scene] = milliseconds(table, name);
            }
        }
    }
    table.refuse_unknown_keys();
}

Contradiction read(TomlTable table) {
    Contradiction contradiction;
    contradiction.kind = named(table, "kind", FaultKind::turned_about_z);
    contradiction.place = named(table, "place", FaultPlace::all_signals);
    contradiction.why = table.text("why");
    if (table.has("error")) {
        contradiction.sign = table.choice("error", {"negative", "positive"}) == 0U ? -1 : 1;
    }
    contradiction.limits_ms.fill(hidden);
    if (table.has("shows_ms")) {
        read_limits(table.table("shows_ms"), contradiction);
    }
    if (table.has("lapse_ms")) {
        contradiction.lapse_ms = milliseconds(table, "lapse_ms");
    }
    if (table.has("lapse")) {
        static_cast<void>(table.choice("lapse", {"any time"}));
        contradiction.lapse_ms = any_time_ms;
    }
    if (table.has("wrong_ms")) {
        contradiction.wrong_ms = milliseconds(table, "wrong_ms");
    }
    if (table.has("late_ms")) {
        contradiction.late_ms = milliseconds(table, "late_ms");
    }
    table.refuse_unknown_keys();
    return contradiction;
}

std::vector<Contradiction> read_all() {
    TomlTable file = TomlTable::parse(contradictions_text, "sil/studies/faults/contradictions.toml");
    std::vector<Contradiction> all;
    for (const TomlTable& table : file.tables("contradiction")) {
        all.push_back(read(table));
    }
    file.refuse_unknown_keys();
    return all;
}

}  // namespace

const std::vector<Contradiction>& contradictions() {
    static const std::vector<Contradiction> all = read_all();
    return all;
}

int limit_of(const Contradiction& stated, SceneKind scene) {
    const auto limit = [&stated](SceneKind kind) { return stated.limits_ms[static_cast<std::size_t>(kind)]; };
    if (scene != SceneKind::over) {
        return limit(scene);
    }
    const int before = limit(SceneKind::before_turn);
    const int steering = limit(SceneKind::steering);
    return before == hidden || steering == hidden ? hidden : std::max(before, steering);
}

const Contradiction& contradiction_of(const Fault& fault) {
    const std::vector<Contradiction>& all = contradictions();
    const auto found = std::find_if(all.begin(), all.end(), [&fault](const Contradiction& each) {
        return each.kind == fault.kind && each.place == fault.place && each.sign * fault.magnitude >= 0.0;
    });
    if (found == all.end()) {
        throw std::logic_error("no contradiction is stated for: " + describe(fault));
    }
    return *found;
}

}  // namespace sil

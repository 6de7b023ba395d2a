#include "sil/files/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "sil/files/file_io.hpp"
#include "sil/input_error.hpp"
#include "sil/printable.hpp"

namespace sil {
namespace {

// A hundred times what the settings of a campaign with a thousand vehicles need; what is parsed takes many
// times as much.
constexpr std::uint64_t longest_toml_bytes = 16U * 1024U * 1024U;

struct Document {
    std::string file;
    toml::table root{};
    std::map<std::string, std::string> changes{};  // as they were asked for, by key
};

std::string text_of(const std::filesystem::path& path, std::string_view example) {
    try {
        return read_whole_file(path, longest_toml_bytes);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}{}{}", error.what(), example.empty() ? "" : ", or ", example));
    }
}

toml::table parsed(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}: not valid TOML: {}; correct this line", file,
                                     error.source().begin.line, error.description()));
    }
}

// A word need not stand in quotation marks.
toml::table value_of(const std::string& text) {
    try {
        return toml::parse("value = " + text);
    } catch (const toml::parse_error&) {
        return toml::table{{"value", text}};
    }
}

}  // namespace

struct TomlTable::State {
    std::shared_ptr<Document> document;
    toml::table* table;  // in the document
    std::string name{};  // empty for the file itself
    std::vector<std::string> known{};

    bool is_known(std::string_view key) const {
        return std::find(known.begin(), known.end(), key) != known.end();
    }

    void allow(std::string_view key) {
        if (!is_known(key)) {
            known.emplace_back(key);
        }
    }

    std::string full_name(std::string_view key) const {
        return name.empty() ? std::string{key} : fmt::format("{}.{}", name, key);
    }

    std::string place(const toml::source_region& where, std::string_view key) const {
        const auto changed = document->changes.find(full_name(key));
        const std::string label = fmt::format("\"{}\"", full_name(printable(key)));
        return changed != document->changes.end()
                   ? fmt::format("{}: {}", printable(changed->second), label)
                   : fmt::format("{}:{}: {}", document->file, where.begin.line, label);
    }

    [[noreturn]] void fail(const toml::node& node, std::string_view key, const std::string& what) const {
        throw InputError(fmt::format("{} {}", place(node.source(), key), what));
    }

    const toml::node& find(std::string_view key, std::string_view kind) {
        allow(key);
        const toml::node* node = table->get(key);
        if (node == nullptr) {
            fail(*table, key,
                 fmt::format("is missing; add {} of this name {}", kind,
                             name.empty() ? "at the top of the file" : "to the table [" + name + "]"));
        }
        return *node;
    }

    double number_of(const toml::node& node, std::string_view key) const {
        if (!node.is_number()) {
            fail(node, key, "must be a number; write a plain number in SI units");
        }
        return node.value<double>().value_or(0.0);
    }

    double finite(const toml::node& node, std::string_view key) const {
        const double value = number_of(node, key);
        if (!std::isfinite(value)) {
            fail(node, key, "is not a finite number; give a plain number");
        }
        return value;
    }

    TomlTable inner(toml::table& inner_table, std::string_view key) const {
        return TomlTable{std::make_shared<State>(State{document, &inner_table, full_name(key)})};
    }
};

TomlTable::TomlTable(std::shared_ptr<State> state) : state_{std::move(state)} {}

TomlTable TomlTable::load(const std::filesystem::path& path, std::string_view example) {
    return parse(text_of(path, example), path.string());
}

TomlTable TomlTable::parse(std::string_view text, const std::string& name) {
    auto document = std::make_shared<Document>();
    document->file = name;
    document->root = parsed(text, name);
    toml::table* const root = &document->root;
    return TomlTable{std::make_shared<State>(State{std::move(document), root})};
}

void TomlTable::change(const std::string& text, std::string_view example) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0U, text.find_last_not_of(" =", equals) + 1U);
    if (equals == std::string::npos || !state_->is_known(key)) {
        throw InputError(fmt::format("\"{}\" must be KEY=VALUE with a key of {}, such as {}", printable(text),
                                     file(), example));
    }
    const std::string value = text.substr(equals + 1U);
    toml::table changed = value_of(value);
    if (changed.size() != 1U) {
        throw InputError(fmt::format("\"{}\": {} is not one value", printable(text), printable(value)));
    }
    state_->table->insert_or_assign(key, std::move(*changed.get("value")));
    state_->document->changes[state_->full_name(key)] = text;
}

void TomlTable::allow(std::string_view key) {
    state_->allow(key);
}

void TomlTable::refuse_unknown_keys() const {
    for (const auto& [key, node] : *state_->table) {
        if (!state_->is_known(key.str())) {
            throw InputError(
                fmt::format("{} is not known here; remove it or correct its spelling; known here: {}",
                            state_->place(key.source(), key.str()), fmt::join(state_->known, ", ")));
        }
    }
}

bool TomlTable::is_empty() const {
    return state_->table->empty();
}

bool TomlTable::has(std::string_view key) {
    allow(key);
    return state_->table->contains(key);
}

double TomlTable::number(std::string_view key) {
    return state_->finite(state_->find(key, "a number"), key);
}

double TomlTable::number(std::string_view key, Range range, std::string_view meaning) {
    const toml::node& node = state_->find(key, "a number");
    const double value = state_->number_of(node, key);
    if (!std::isfinite(value) || value < range.lowest || value > range.highest) {
        const std::string found =
            std::isfinite(value) ? fmt::format("{:g}, which is out of range", value) : "not a finite number";
        state_->fail(
            node, key,
            fmt::format("is {}{}; give a number from {:g} to {:g}, in SI units", found,
                        meaning.empty() ? "" : fmt::format(" ({})", meaning), range.lowest, range.highest));
    }
    return value;
}

double TomlTable::any_number(std::string_view key) {
    return state_->number_of(state_->find(key, "a number"), key);
}

std::uint64_t TomlTable::whole_number(std::string_view key) {
    const toml::node& node = state_->find(key, "a whole number");
    const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
    if (!value || *value < 0) {
        state_->fail(node, key, "must be a whole number, 0 or above");
    }
    return static_cast<std::uint64_t>(*value);
}

bool TomlTable::boolean(std::string_view key) {
    const toml::node& node = state_->find(key, "true or false");
    if (!node.is_boolean()) {
        state_->fail(node, key, "must be true or false");
    }
    return *node.value<bool>();
}

std::string TomlTable::text(std::string_view key) {
    const toml::node& node = state_->find(key, "a text");
    if (!node.is_string()) {
        state_->fail(node, key, "must be a text in quotation marks");
    }
    return *node.value<std::string>();
}

std::size_t TomlTable::choice(std::string_view key, const std::vector<std::string_view>& choices) {
    const toml::node& node = state_->find(key, "a text");
    const auto value = node.value<std::string_view>();
    const auto found = value ? std::find(choices.begin(), choices.end(), *value) : choices.end();
    if (found == choices.end()) {
        state_->fail(node, key, fmt::format("must be one of \"{}\"", fmt::join(choices, "\", \"")));
    }
    return static_cast<std::size_t>(found - choices.begin());
}

std::vector<double> TomlTable::numbers(std::string_view key) {
    const toml::node& node = state_->find(key, "an array of numbers");
    const toml::array* const all = node.as_array();
    if (all == nullptr) {
        state_->fail(node, key, "must be numbers in brackets, such as [0.5, 1.0]");
    }
    std::vector<double> values;
    for (const toml::node& each : *all) {
        values.push_back(state_->finite(each, key));
    }
    return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key) {
    const toml::node& node = state_->find(key, "an array of texts");
    const toml::array* const all = node.as_array();
    std::vector<std::string> values;
    for (std::size_t i = 0U; all != nullptr && i < all->size(); ++i) {
        if (const toml::value<std::string>* const each = all->get(i)->as_string()) {
            values.push_back(each->get());
        }
    }
    if (all == nullptr || values.size() != all->size()) {
        state_->fail(node, key, "must be texts in brackets, such as [\"a\", \"b\"]");
    }
    return values;
}

TomlTable TomlTable::table(std::string_view key) {
    state_->find(key, "a table");
    toml::node& node = *state_->table->get(key);
    if (!node.is_table()) {
        state_->fail(node, key,
                     fmt::format("must be a table; write [{}] and its keys below", state_->full_name(key)));
    }
    return state_->inner(*node.as_table(), key);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
    std::vector<TomlTable> found;
    if (!has(key)) {
        return found;
    }
    toml::node& node = *state_->table->get(key);
    const std::string wanted = fmt::format("must be written as [[{}]]", state_->full_name(key));
    toml::array* const all = node.as_array();
    if (all == nullptr) {
        state_->fail(node, key, wanted);
    }
    for (toml::node& each : *all) {
        if (!each.is_table()) {
            state_->fail(each, key, wanted);
        }
        found.push_back(state_->inner(*each.as_table(), key));
    }
    return found;
}

void TomlTable::fail(std::string_view key, const std::string& what) const {
    throw InputError(fmt::format("{} {}", place(key), what));
}

std::string TomlTable::place(std::string_view key) const {
    const toml::node* const node = state_->table->get(key);
    return state_->place((node != nullptr ? *node : *state_->table).source(), key);
}

const std::string& TomlTable::file() const {
    return state_->document->file;
}

}  // namespace sil

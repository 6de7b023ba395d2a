// TOML table: checked values out of a TOML file. Every failure names file, line and key, and says what to do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sil {

// Both ends belong to it.
struct Range {
    double lowest;
    double highest;
};

// One table of a file; its keys are known once they have been named here. Copies are of the same table.
// Functions that throw, throw InputError: "FILE:LINE: "TABLE.KEY" what is wrong; what to do", or the change's
// own text in place of FILE:LINE where change() gave the value.
class TomlTable {
 public:
    // `example` ends the message for a file that cannot be read, such as "name a file like x.toml"; may be
    // empty.
    static TomlTable load(const std::filesystem::path& path, std::string_view example = {});

    // `name` stands for the file in messages.
    static TomlTable parse(std::string_view text, const std::string& name);

    // "KEY=VALUE" in place of what the file says, VALUE as in the file; a word needs no quotes. Throws unless
    // KEY is known. `example` is one such text, for the message.
    void change(const std::string& text, std::string_view example);

    // Counts the key as known.
    void allow(std::string_view key);

    // Throws at the first key that is not known.
    void refuse_unknown_keys() const;

    bool is_empty() const;
    bool has(std::string_view key);

    double number(std::string_view key);
    // `meaning` of the value, for the message; may be empty.
    double number(std::string_view key, Range range, std::string_view meaning = {});
    // NaN and infinity too, for what is checked elsewhere.
    double any_number(std::string_view key);
    std::uint64_t whole_number(std::string_view key);
    bool boolean(std::string_view key);
    std::string text(std::string_view key);
    // The position of the text in `choices`.
    std::size_t choice(std::string_view key, const std::vector<std::string_view>& choices);
    // All numbers of an array, each finite.
    std::vector<double> numbers(std::string_view key);
    // All texts of an array.
    std::vector<std::string> texts(std::string_view key);
    TomlTable table(std::string_view key);
    // The tables of [[key]]; none where the file has no such key.
    std::vector<TomlTable> tables(std::string_view key);

    // Throws InputError at the key's place, or at the table's where it has no such key.
    [[noreturn]] void fail(std::string_view key, const std::string& what) const;

    // "FILE:LINE: "KEY"" for messages of one's own.
    std::string place(std::string_view key) const;
    // The file, or what stands for it.
    const std::string& file() const;

 private:
    struct State;
    explicit TomlTable(std::shared_ptr<State> state);

    std::shared_ptr<State> state_;
};

}  // namespace sil

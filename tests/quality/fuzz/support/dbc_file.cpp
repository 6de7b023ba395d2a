#include "tests/quality/fuzz/support/dbc_file.hpp"

#include <cmath>
#include <fstream>
#include <regex>

#include "tests/quality/fuzz/support/require.hpp"

namespace fuzz {
namespace {

// The bit of the payload that holds the signal's bit `index`, counted from its least significant one; bit b
// is bit b % 8 of byte b / 8.
unsigned place_of(const DbcSignal& signal, unsigned index) {
    if (signal.little_endian) {
        return signal.start_bit + index;
    }
    // Big-endian: from the most significant bit downwards within a byte, then on at the top of the next.
    unsigned bit = signal.start_bit;
    for (unsigned step = signal.length - 1U; step > index; --step) {
        bit = bit % 8U == 0U ? bit + 15U : bit - 1U;
    }
    return bit;
}

class DbcReader {
 public:
    void read_line(const std::string& line) {
        static const std::regex message(R"(BO_ (\d+) (\w+): (\d+) .*)");
        static const std::regex signal(
            R"( SG_ (\w+) : (\d+)\|(\d+)@([01])([+-]) \(([^,]+),([^)]+)\) \[([^|]+)\|([^\]]+)\] .*)");
        static const std::regex start_value(R"(BA_ "GenSigStartValue" SG_ (\d+) (\w+) (-?\d+);)");
        static const std::regex values(R"(VAL_ (\d+) (\w+) (.*) ;)");
        std::smatch found;
        if (std::regex_match(line, found, message)) {
            names_[found[1]] = found[2];
            latest_ = found[2];
            messages_[latest_].length = std::stoul(found[3]);
        } else if (std::regex_match(line, found, signal)) {
            messages_[latest_].signals[found[1]] = described(found);
        } else if (std::regex_match(line, found, start_value)) {
            signal_of(found[1], found[2]).start_value = std::stoll(found[3]);
        } else if (std::regex_match(line, found, values)) {
            name_values(signal_of(found[1], found[2]), found[3]);
        }
    }

    std::map<std::string, DbcMessage> messages() && { return std::move(messages_); }

 private:
    static DbcSignal described(const std::smatch& found) {
        DbcSignal signal;
        signal.start_bit = static_cast<unsigned>(std::stoul(found[2]));
        signal.length = static_cast<unsigned>(std::stoul(found[3]));
        signal.little_endian = found[4] == "1";
        signal.is_signed = found[5] == "-";
        signal.factor = std::stod(found[6]);
        signal.offset = std::stod(found[7]);
        signal.minimum = std::stod(found[8]);
        signal.maximum = std::stod(found[9]);
        for (unsigned index = 0U; index < signal.length; ++index) {
            signal.places.push_back(place_of(signal, index));
        }
        return signal;
    }

    static void name_values(DbcSignal& signal, const std::string& list) {
        static const std::regex one("(-?\\d+) \"([^\"]*)\"");
        for (std::sregex_iterator value{list.begin(), list.end(), one}, end; value != end; ++value) {
            const std::int64_t code = std::stoll((*value)[1]);
            if ((*value)[2] == "not available") {
                signal.not_available = code;
            } else {
                signal.named.insert(code);
            }
        }
    }

    DbcSignal& signal_of(const std::string& identifier, const std::string& name) {
        return messages_.at(names_.at(identifier)).signals.at(name);
    }

    std::map<std::string, DbcMessage> messages_;
    std::map<std::string, std::string> names_;  // by identifier
    std::string latest_;
};

}  // namespace

std::int64_t DbcSignal::raw(const std::uint8_t* payload) const {
    std::uint64_t bits = 0U;
    for (unsigned index = 0U; index < length; ++index) {
        const unsigned place = places[index];
        const std::uint64_t bit = (payload[place / 8U] >> (place % 8U)) & 1U;
        bits |= bit << index;
    }
    const auto value = static_cast<std::int64_t>(bits);
    const std::int64_t range = std::int64_t{1} << length;
    return is_signed && 2 * value >= range ? value - range : value;
}

bool DbcSignal::admits(double value) const {
    const double slack = 1.0e-6 * factor;
    return value >= minimum - slack && value <= maximum + slack;
}

std::uint64_t DbcSignal::mask() const {
    std::uint64_t bits = 0U;
    for (const unsigned place : places) {
        bits |= std::uint64_t{1} << place;
    }
    return bits;
}

std::map<std::string, DbcMessage> read_dbc(const std::string& path) {
    std::ifstream file{path};
    require(file.good(), "the DBC file cannot be read");
    DbcReader reader;
    std::string line;
    while (std::getline(file, line)) {
        reader.read_line(line);
    }
    return std::move(reader).messages();
}

}  // namespace fuzz

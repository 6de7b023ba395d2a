#include "sil/exchange/fmu/serial_state.hpp"

#include <cstring>
#include <type_traits>

#include "sil/exchange/fmu/start_values.hpp"

namespace fmu {
namespace {

class Writer {
 public:
    template <typename Number>
    void number(Number value) {
        static_assert(std::is_arithmetic_v<Number>);
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        all_.append(bytes, sizeof value);
    }
    void text(const std::string& text) {
        number(static_cast<std::uint64_t>(text.size()));
        all_ += text;
    }
    const std::string& all() const { return all_; }

 private:
    std::string all_{};
};

// Reads nothing beyond the end; then it is not good.
class Reader {
 public:
    explicit Reader(const std::string& all) : all_{all} {}

    template <typename Number>
    Number number() {
        Number value{};
        if (take(sizeof value)) {
            std::memcpy(&value, all_.data() + place_ - sizeof value, sizeof value);
        }
        return value;
    }
    std::string text() {
        const auto length = number<std::uint64_t>();
        return take(length) ? all_.substr(place_ - length, length) : std::string{};
    }
    bool ended_well() const { return good_ && place_ == all_.size(); }

 private:
    bool take(std::uint64_t length) {
        good_ = good_ && length <= all_.size() - place_;
        place_ += good_ ? length : 0U;
        return good_;
    }

    const std::string& all_;
    std::size_t place_{0U};
    bool good_{true};
};

// FNV-1a: against damage, not against malice.
std::uint64_t digest(const std::string& text) {
    std::uint64_t sum = 0xCBF29CE484222325U;
    for (const char letter : text) {
        sum = (sum ^ static_cast<unsigned char>(letter)) * 0x100000001B3U;
    }
    return sum;
}

std::string content(const SavedState& state, const std::string& model) {
    Writer writer;
    writer.text(instantiation_token);
    writer.number(static_cast<std::uint8_t>(state.phase));
    writer.number(static_cast<std::uint8_t>(state.outputs_known));
    writer.number(state.start_s);
    writer.number(state.cycles);
    writer.number(state.into_cycle_s);
    for (const double number : state.values.numbers) {
        writer.number(number);
    }
    for (const double number : state.sampled.numbers) {
        writer.number(number);
    }
    for (const std::string& text : state.values.texts) {
        writer.text(text);
    }
    writer.text(model);
    return writer.all();
}

}  // namespace

std::string to_bytes(const SavedState& state) {
    const std::string model = state.model->to_bytes();
    if (model.empty()) {
        return {};
    }
    const std::string all = content(state, model);
    Writer writer;
    writer.number(digest(all));
    return writer.all() + all;
}

bool from_bytes(const std::string& bytes, SavedState& state) {
    constexpr std::size_t head = sizeof(std::uint64_t);
    if (bytes.size() < head) {
        return false;
    }
    const std::string all = bytes.substr(head);
    if (Reader{bytes}.number<std::uint64_t>() != digest(all)) {
        return false;
    }
    Reader reader{all};
    if (reader.text() != instantiation_token) {
        return false;
    }
    const auto phase = static_cast<Phase>(reader.number<std::uint8_t>());
    const bool outputs_known = reader.number<std::uint8_t>() != 0U;
    const auto start_s = reader.number<double>();
    const auto cycles = reader.number<std::uint64_t>();
    const auto into_cycle_s = reader.number<double>();
    Values values = state.values;
    for (double& number : values.numbers) {
        number = reader.number<double>();
    }
    Values sampled = state.sampled;
    for (double& number : sampled.numbers) {
        number = reader.number<double>();
    }
    for (std::string& text : values.texts) {
        text = reader.text();
    }
    const std::string model = reader.text();
    if (phase > Phase::terminated || !reader.ended_well() || !state.model->from_bytes(model)) {
        return false;
    }
    state.phase = phase;
    state.outputs_known = outputs_known;
    state.start_s = start_s;
    state.cycles = cycles;
    state.into_cycle_s = into_cycle_s;
    sampled.texts = values.texts;
    state.values = std::move(values);
    state.sampled = std::move(sampled);
    return true;
}

}  // namespace fmu

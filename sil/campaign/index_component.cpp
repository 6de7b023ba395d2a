#include "sil/campaign/index_component.hpp"

#include <stdexcept>
#include <string>

namespace sil {

IndexComponent::IndexComponent(const rsi::Parameters& parameters) {
    rsi::Parameters with_every_index_new = parameters;
    with_every_index_new.warning_indicator = RSI_INDICATOR_STATIC_STABILITY_FACTOR;
    const rsi::Validation answer = component_.init(with_every_index_new);
    if (answer.accepted == 0) {
        throw std::invalid_argument(std::string{answer.field} + " " + answer.reason);
    }
}

}  // namespace sil

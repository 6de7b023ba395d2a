#include "sil/studies/campaign/index_component.hpp"

#include "sil/files/require_accepted.hpp"

namespace sil {

IndexComponent::IndexComponent(const rsi::Parameters& parameters) {
    rsi::Parameters with_every_index_new = parameters;
    with_every_index_new.warning_indicator = RSI_INDICATOR_STATIC_STABILITY_FACTOR;
    require_accepted(component_.init(with_every_index_new));
}

}  // namespace sil

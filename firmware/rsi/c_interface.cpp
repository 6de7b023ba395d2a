// The C interface over the C++ component: the caller's storage holds the object.
#include <new>
#include <type_traits>

#include "rsi/component.hpp"

static_assert(sizeof(rsi::Component) <= sizeof(rsi_component), "raise RSI_COMPONENT_SIZE in rsi.h");
static_assert(alignof(rsi::Component) <= alignof(rsi_component),
              "rsi_component is not aligned for the component");
static_assert(std::is_trivially_destructible_v<rsi::Component>, "the C interface never destroys a component");

namespace {

rsi::Component& object_in(rsi_component* component) {
    return *std::launder(static_cast<rsi::Component*>(static_cast<void*>(component->bytes)));
}

const rsi::Component& object_in(const rsi_component* component) {
    return *std::launder(static_cast<const rsi::Component*>(static_cast<const void*>(component->bytes)));
}

}  // namespace

extern "C" rsi_validation rsi_init(rsi_component* component, const rsi_parameters* parameters) {
    rsi::Component* const object = ::new (static_cast<void*>(component->bytes)) rsi::Component{};
    return object->init(*parameters);
}

extern "C" void rsi_step(rsi_component* component, const rsi_inputs* inputs, rsi_outputs* outputs) {
    object_in(component).step(*inputs, *outputs);
}

extern "C" rsi_learnt_load rsi_get_learnt_load(const rsi_component* component) {
    return object_in(component).learnt_load();
}

extern "C" int32_t rsi_restore_learnt_load(rsi_component* component, const rsi_learnt_load* learnt,
                                           int32_t doubted) {
    return object_in(component).restore_load(*learnt, doubted != 0) ? 1 : 0;
}

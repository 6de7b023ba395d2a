// The C interface over the C++ component: the caller's storage holds the object.
#include <new>
#include <type_traits>

#include "rsi/component.hpp"

static_assert(sizeof(rsi::Component) <= sizeof(rsi_component), "raise RSI_COMPONENT_SIZE in rsi.h");
static_assert(alignof(rsi::Component) <= alignof(rsi_component),
              "rsi_component is not aligned for the component");
static_assert(std::is_trivially_destructible_v<rsi::Component>, "the C interface never destroys a component");
static_assert(sizeof(rsi::ParameterChange) <= sizeof(rsi_parameter_change),
              "raise RSI_PARAMETER_CHANGE_SIZE in rsi.h");
static_assert(alignof(rsi::ParameterChange) <= alignof(rsi_parameter_change),
              "rsi_parameter_change is not aligned for the change");
static_assert(std::is_trivially_destructible_v<rsi::ParameterChange>,
              "the C interface never destroys a change");

namespace {

rsi::Component& object_in(rsi_component* component) {
    return *std::launder(static_cast<rsi::Component*>(static_cast<void*>(component->bytes)));
}

const rsi::Component& object_in(const rsi_component* component) {
    return *std::launder(static_cast<const rsi::Component*>(static_cast<const void*>(component->bytes)));
}

rsi::ParameterChange& object_in(rsi_parameter_change* change) {
    return *std::launder(static_cast<rsi::ParameterChange*>(static_cast<void*>(change->bytes)));
}

const rsi::ParameterChange& object_in(const rsi_parameter_change* change) {
    return *std::launder(static_cast<const rsi::ParameterChange*>(static_cast<const void*>(change->bytes)));
}

}  // namespace

extern "C" rsi_validation rsi_init(rsi_component* component, const rsi_parameters* parameters) {
    rsi::Component* const object = ::new (static_cast<void*>(component->bytes)) rsi::Component{};
    return object->init(*parameters);
}

extern "C" void rsi_reset(rsi_component* component, const rsi_parameters* parameters) {
    object_in(component).reset(*parameters);
}

extern "C" void rsi_step(rsi_component* component, const rsi_inputs* inputs, rsi_outputs* outputs) {
    object_in(component).step(*inputs, *outputs);
}

extern "C" rsi_validation rsi_begin_change(rsi_parameter_change* change, const rsi_parameters* from,
                                           const rsi_parameters* to) {
    rsi::ParameterChange* const object = ::new (static_cast<void*>(change->bytes)) rsi::ParameterChange{};
    return object->begin(*from, *to);
}

extern "C" int32_t rsi_prepare_change(rsi_parameter_change* change) {
    return object_in(change).prepare() ? 1 : 0;
}

extern "C" void rsi_change(rsi_component* component, const rsi_parameter_change* change) {
    object_in(component).change(object_in(change));
}

extern "C" rsi_learnt_load rsi_get_learnt_load(const rsi_component* component) {
    return object_in(component).learnt_load();
}

extern "C" int32_t rsi_restore_learnt_load(rsi_component* component, const rsi_learnt_load* learnt,
                                           int32_t doubted) {
    return object_in(component).restore_load(*learnt, doubted != 0) ? 1 : 0;
}

extern "C" int32_t rsi_is_optimised() {
#ifdef __OPTIMIZE__
    return 1;
#else
    return 0;
#endif
}

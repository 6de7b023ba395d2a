// Messages for a SocketCAN interface that cannot be opened.
#include "hal/socketcan/open_result.hpp"

#include <cstdio>
#include <cstring>

namespace rsi::hal {
namespace {

struct Explanation {
    const char* what;
    const char* next;  // each %s stands for the interface's name
};

Explanation explain(OpenFailure failure) noexcept {
    switch (failure) {
        case OpenFailure::interface_name:
            return {
                "the name is empty or longer than 15 characters",
                "give the name of a CAN interface; `ip -brief link show type can` and `ip -brief link show "
                "type vcan` list them"};
        case OpenFailure::identifiers:
            return {"the list of identifiers to receive is not usable",
                    "give at most 64 identifiers, up to 0x7FF each, or up to 0x1FFFFFFF when extended"};
        case OpenFailure::kernel_without_can:
            return {"this kernel has no CAN sockets",
                    "try `modprobe can-raw` as root; where the kernel was built without CAN, use `sil/run`, "
                    "which "
                    "boots a small virtual machine that has it"};
        case OpenFailure::not_permitted:
            return {"the system does not permit a CAN socket here",
                    "run as root or look at the container's or service's restrictions on address families"};
        case OpenFailure::interface_missing:
            return {"there is no such interface",
                    "make a virtual one with `ip link add dev %s type vcan && ip link set %s up`; for a real "
                    "controller load its driver, then `ip link set %s up type can bitrate 500000`"};
        case OpenFailure::interface_not_can:
            return {"the interface exists, but is not a CAN interface",
                    "choose another name; `ip -brief link show type can` and `ip -brief link show type vcan` "
                    "list "
                    "those that are"};
        case OpenFailure::interface_down:
            return {"the interface is down",
                    "switch it on with `ip link set %s up type can bitrate 500000`, or `ip link set %s up` "
                    "when it "
                    "is virtual"};
        case OpenFailure::system:
            return {"the system refused", "look the reason up in `man 7 socket` and `dmesg`"};
        case OpenFailure::none:
            break;
    }
    return {"", ""};
}

// Appends `part` at `used`, replacing each %s by `name`; cuts off what does not fit.
void append(OpenResult& result, std::size_t& used, const char* part, const char* name) noexcept {
    for (const char* at = part; *at != '\0'; ++at) {
        const bool is_name = at[0] == '%' && at[1] == 's';
        const int wanted = is_name
                               ? std::snprintf(&result.text[used], result.text.size() - used, "%.32s", name)
                               : std::snprintf(&result.text[used], result.text.size() - used, "%c", *at);
        used += static_cast<std::size_t>(wanted);
        if (used >= result.text.size()) {
            used = result.text.size() - 1U;
            return;
        }
        at += is_name ? 1 : 0;
    }
}

}  // namespace

OpenResult describe_open_failure(OpenFailure failure, int system_error, const char* interface_name) noexcept {
    OpenResult result;
    result.failure = failure;
    result.system_error = system_error;
    if (failure == OpenFailure::none) {
        return result;
    }
    const Explanation explanation = explain(failure);
    std::size_t used = 0U;
    append(result, used, "CAN interface '%s' cannot be opened: ", interface_name);
    append(result, used, explanation.what, interface_name);
    if (system_error != 0) {
        append(result, used, " (", interface_name);
        append(result, used, std::strerror(system_error), interface_name);
        append(result, used, ")", interface_name);
    }
    append(result, used, ". Next: ", interface_name);
    append(result, used, explanation.next, interface_name);
    append(result, used, ".", interface_name);
    return result;
}

}  // namespace rsi::hal

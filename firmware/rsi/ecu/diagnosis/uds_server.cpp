#include "rsi/ecu/diagnosis/uds_server.hpp"

#include "rsi/ecu/diagnosis/trouble_report.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::diagnosis {
namespace {

constexpr std::uint32_t session_cycles = 500U;               // S3: 5 s
constexpr std::uint32_t response_milliseconds = 50U;         // P2
constexpr std::uint32_t late_response_milliseconds = 5000U;  // P2*
constexpr std::uint32_t cycles_to_say_later = 3U;            // within P2
constexpr std::uint32_t most_wait_cycles = 450U;             // within P2*
constexpr float standing_mps = 1.4F;
constexpr float turning_radps = 0.1F;

constexpr std::uint8_t suppress_positive = 0x80U;
constexpr std::uint8_t start_routine = 0x01U;
constexpr std::uint8_t routine_results = 0x03U;
constexpr std::uint32_t all_groups = 0xFF'FFFFU;

const Service* service_of(const Request& request) {
    for (const Service& each : services) {
        if (each.id == request.service()) {
            return (each.is_functional || !request.is_functional()) ? &each : nullptr;
        }
    }
    return nullptr;
}

Nrc check_sub_function(const Request& request) {
    if (request.length() < 2U) {
        return Nrc::incorrect_length;
    }
    for (const ListedSubFunction& each : sub_functions) {
        if ((each.service == request.service()) && (each.number == request.sub_function())) {
            return (request.length() == each.length) ? Nrc::none : Nrc::incorrect_length;
        }
    }
    return Nrc::sub_function_not_supported;
}

// Precondition: the request has been validated.
bool is_suppressed(const Request& request) {
    bool has_sub_function = false;
    for (const Service& each : services) {
        const bool is_it = (each.id == request.service()) && (each.sub_function != SubFunction::none);
        has_sub_function = has_sub_function || is_it;
    }
    return has_sub_function && ((request.byte(1U) & suppress_positive) != 0U);
}

// Functionally addressed requests get no such negative response (ISO 14229-1).
bool is_sent_to_functional(Nrc code) {
    return (code != Nrc::service_not_supported) && (code != Nrc::sub_function_not_supported) &&
           (code != Nrc::request_out_of_range) && (code != Nrc::service_not_in_session);
}

// A measured standstill: switching the warning off needs proof, not just the absence of a speed.
bool is_standing(const EcuState& ecu) {
    return ecu.inputs.speed_mps <= standing_mps;
}

// Without a speed, rates that no parked vehicle has show motion. Without these too it counts as at rest, so
// that the ECU can be serviced on a bench; what is done then needs the key, or has a limit.
bool is_moving(const EcuState& ecu) {
    const bool is_turning = (rsi::absolute(ecu.inputs.yaw_rate_radps) > turning_radps) ||
                            (rsi::absolute(ecu.inputs.roll_rate_radps) > turning_radps);
    return (ecu.inputs.speed_mps > standing_mps) || (is_turning && !is_standing(ecu));
}

constexpr monitoring::CodeSet storage_failed = monitoring::set_of(monitoring::DiagnosticCode::storage_failed);

std::uint8_t bit_where(monitoring::CodeSet failed, monitoring::CodeSet codes, std::uint8_t bit) {
    return ((failed & codes) != 0U) ? bit : std::uint8_t{0U};
}

std::uint8_t self_test_of(monitoring::CodeSet failed) {
    using monitoring::DiagnosticCode;
    using monitoring::set_of;
    const std::uint32_t found =
        std::uint32_t{bit_where(failed,
                                set_of(DiagnosticCode::parameters_refused, DiagnosticCode::parameters_damaged,
                                       DiagnosticCode::stored_parameters_refused),
                                self_test::parameters)} |
        bit_where(failed, set_of(DiagnosticCode::memory_restored), self_test::memory) |
        bit_where(failed, set_of(DiagnosticCode::estimate_out_of_range, DiagnosticCode::output_not_finite),
                  self_test::computing) |
        bit_where(
            failed,
            set_of(DiagnosticCode::cycle_overrun, DiagnosticCode::cycle_stall, DiagnosticCode::clock_jump),
            self_test::timing) |
        bit_where(failed, set_of(DiagnosticCode::bus_error, DiagnosticCode::receive_overflow),
                  self_test::bus) |
        bit_where(failed, storage_failed, self_test::storing);
    return static_cast<std::uint8_t>(found);
}

}  // namespace

// A request that waits for the memory waits in the transport, too.
void UdsServer::work(const EcuState& ecu) noexcept {
    if (!is_standing(ecu)) {
        switch_all_on();
    }
    count_session_time();
    const Request request = transport_.request();
    if (waiting_ != Waiting::nothing) {
        drop_functional_request();
        wait_for_storage(ecu);
    } else if (transport_.is_sending()) {
        drop_functional_request();
    } else if (request.length() != 0U) {
        serve(request, ecu);
    } else {
        // no request
    }
}

// While a request is on its way or is answered, the tester is there.
void UdsServer::count_session_time() noexcept {
    const bool is_busy =
        (waiting_ != Waiting::nothing) || transport_.is_sending() || transport_.is_receiving();
    idle_cycles_ = is_busy ? 0U : (idle_cycles_ + 1U);
    if (idle_cycles_ >= session_cycles) {  // of the standard session nothing is left to end
        enter(Session::standard);
    }
}

// All permissions of the tester end; services that it had switched off are on again when it leaves.
void UdsServer::enter(Session session) noexcept {
    session_ = session;
    download_.abort();
    if (access_ != nullptr) {
        access_->lock();
    }
    if (session == Session::standard) {
        switch_all_on();
    }
}

// Services that a tester may switch off at rest.
void UdsServer::switch_all_on() noexcept {
    kept_.codes().set_recording(true);
    lets_ecu_send_ = true;
}

// Functional requests are dropped while another request is in progress, "tester present" too.
void UdsServer::drop_functional_request() noexcept {
    const bool is_waited_for = (waiting_ != Waiting::nothing) && waiting_for_.is_functional();
    if (!is_waited_for) {
        transport_.drop_functional();
    }
}

void UdsServer::serve(const Request& request, const EcuState& ecu) noexcept {
    constexpr std::uint32_t response_bit = 0x40U;
    if ((request.service() & response_bit) != 0U) {  // the answer of another control unit
        transport_.finish(request);
        return;
    }
    idle_cycles_ = 0U;
    begin_answer(request, 0U);
    const Nrc code = check_and_run(request, ecu);
    if (code == Nrc::response_pending) {
        waiting_for_ = request;
        wait_cycles_ = 0U;
        return;
    }
    answer(request, code);
}

void UdsServer::answer(const Request& request, Nrc code) noexcept {
    const Nrc said = response_.is_too_long() ? Nrc::response_too_long : code;
    const bool is_good = (said == Nrc::none);
    const bool is_said = is_good ? (is_later_said_ || !is_suppressed(request))
                                 : (!request.is_functional() || is_sent_to_functional(said));
    if (!is_good) {
        say_no(request, said);
    }
    is_later_said_ = false;
    transport_.finish(request);
    if (is_said) {
        transport_.send(response_);
    }
}

void UdsServer::say_no(const Request& request, Nrc code) noexcept {
    response_.begin(0x7FU);
    response_.put(request.service());
    response_.put(static_cast<std::uint8_t>(code));
}

void UdsServer::begin_routine_answer(const Request& request) noexcept {
    begin_answer(request, 0U);
    response_.put(request.sub_function());
    response_.put_u16(request.u16_at(2U));
}

// `repeated`: number of bytes after the service identifier that the response repeats from the request.
void UdsServer::begin_answer(const Request& request, std::size_t repeated) noexcept {
    response_.begin(static_cast<std::uint8_t>(request.service() + 0x40U));
    for (std::size_t place = 1U; place <= repeated; ++place) {
        response_.put(request.byte(place));
    }
}

// The order of ISO 14229-1: service, session, access to all of it, sub-function, length; then what the
// service itself finds.
Nrc UdsServer::check_and_run(const Request& request, const EcuState& ecu) noexcept {
    const Service* const service = service_of(request);
    if (service == nullptr) {
        return Nrc::service_not_supported;
    }
    if ((service->sessions & in::session(session_)) == 0U) {
        return Nrc::service_not_in_session;
    }
    if (service->is_secured && !is_unlocked()) {
        return Nrc::security_access_denied;
    }
    if (service->sub_function == SubFunction::listed) {
        const Nrc code = check_sub_function(request);
        if (code != Nrc::none) {
            return code;
        }
    }
    return run(request, ecu);
}

Nrc UdsServer::run(const Request& request, const EcuState& ecu) noexcept {
    switch (request.service()) {
        case service_id::session_control:
            return session_control(request, ecu);
        case service_id::reset:
            return reset(ecu);
        case service_id::clear_codes:
            return clear_codes(request, ecu);
        case service_id::read_codes:
            return report_codes(request.sub_function(), request, kept_.codes(), ecu.monitoring, response_);
        case service_id::read_data:
            return read_data(request, ecu);
        case service_id::security_access:
            return security_access(request);
        case service_id::communication_control:
            return communication_control(request, ecu);
        case service_id::write_data:
            return write_data(request, ecu);
        case service_id::routine_control:
            return routine_control(request, ecu);
        case service_id::request_download:
            return request_download(request, ecu);
        case service_id::transfer_data:
        case service_id::transfer_exit:
            return transfer(request, ecu);
        case service_id::code_setting:
            return code_setting(request, ecu);
        default:  // tester present
            response_.put(0x00U);
            return Nrc::none;
    }
}

Nrc UdsServer::session_control(const Request& request, const EcuState& ecu) noexcept {
    const auto session = static_cast<Session>(request.sub_function());
    if ((session == Session::programming) && is_moving(ecu)) {
        return Nrc::conditions_not_correct;
    }
    enter(session);
    response_.put(static_cast<std::uint8_t>(session));
    response_.put_u16(response_milliseconds);
    response_.put_u16(late_response_milliseconds / 10U);
    return Nrc::none;
}

Nrc UdsServer::reset(const EcuState& ecu) noexcept {
    if (is_moving(ecu) || !kept_.codes().takes_reset()) {
        return Nrc::conditions_not_correct;
    }
    kept_.codes().count_reset();
    return wait_for_codes(Waiting::codes_stored_before_reset);
}

Nrc UdsServer::wait_for_codes(Waiting reason) noexcept {
    kept_.begin_order();
    waiting_ = reason;
    return Nrc::response_pending;
}

void UdsServer::promise_reset(const Request& request) noexcept {
    is_reset_requested_ = true;
    begin_answer(request, 0U);
    response_.put(request.sub_function());
}

// Beyond its orders a tester waits for the next operation cycle.
Nrc UdsServer::clear_codes(const Request& request, const EcuState& ecu) noexcept {
    if (request.length() != 4U) {
        return Nrc::incorrect_length;
    }
    const std::uint32_t group = request.u24_at(1U);
    const std::size_t row = row_of_number(group);
    if ((group != all_groups) && (row == trouble_code_count)) {
        return Nrc::request_out_of_range;
    }
    if (is_moving(ecu) || !kept_.takes_order()) {
        return Nrc::conditions_not_correct;
    }
    if (group == all_groups) {
        kept_.codes().clear_all();
    } else {
        kept_.codes().clear(row);
    }
    return wait_for_codes(Waiting::codes_stored);
}

// Unknown identifiers are left out of the response; if all are unknown, the request is out of range.
Nrc UdsServer::read_data(const Request& request, const EcuState& ecu) noexcept {
    if ((request.length() == 1U) || ((request.length() % 2U) == 0U)) {
        return Nrc::incorrect_length;
    }
    const DataSources sources{identification_,
                              ecu.calibration,
                              kept_.written(),
                              ecu.inputs,
                              ecu.outputs,
                              session_,
                              kept_.codes().operation_cycles()};
    bool is_one_known = false;
    for (std::size_t place = 1U; place < request.length(); place += 2U) {
        const bool is_known = read_identifier(request.u16_at(place), sources, response_);
        is_one_known = is_one_known || is_known;
    }
    return is_one_known ? Nrc::none : Nrc::request_out_of_range;
}

Nrc UdsServer::write_data(const Request& request, const EcuState& ecu) noexcept {
    constexpr std::size_t header = 3U;
    if (request.length() <= header) {
        return Nrc::incorrect_length;
    }
    const std::uint32_t identifier = request.u16_at(1U);
    const std::size_t length = writable_length(identifier);
    if (length == 0U) {
        return Nrc::request_out_of_range;
    }
    if (request.length() != header + length) {
        return Nrc::incorrect_length;
    }
    if (!is_unlocked()) {
        return Nrc::security_access_denied;
    }
    if (!is_writable(identifier, request, header)) {
        return Nrc::request_out_of_range;
    }
    if (is_moving(ecu) || !kept_.takes_order()) {
        return Nrc::conditions_not_correct;
    }
    write_identifier(identifier, request, header, kept_.written());
    kept_.codes().request_storing(Storing::now);
    return wait_for_codes(Waiting::codes_stored);
}

Nrc UdsServer::security_access(const Request& request) noexcept {
    if (access_ == nullptr) {
        return Nrc::conditions_not_correct;
    }
    response_.put(request.sub_function());
    if (request.sub_function() == security::send_key) {
        return take_key(request);
    }
    access::Block seed{};  // all zeros: already unlocked (ISO 14229-1)
    if (!access_->is_unlocked() && !access_->give_seed(seed)) {
        return access_->is_delayed() ? Nrc::time_delay_not_expired : Nrc::conditions_not_correct;
    }
    for (const std::uint8_t byte : seed) {
        response_.put(byte);
    }
    return Nrc::none;
}

Nrc UdsServer::take_key(const Request& request) noexcept {
    access::Block key{};
    for (std::size_t index = 0U; index < key.size(); ++index) {
        key[index] = request.byte(2U + index);
    }
    switch (access_->take_key(key)) {
        case access::KeyAnswer::unlocked:
            return Nrc::none;
        case access::KeyAnswer::no_seed:
            return Nrc::request_sequence_error;
        case access::KeyAnswer::too_many_attempts:
            return Nrc::exceeded_attempts;
        default:
            return Nrc::invalid_key;
    }
}

// Switches the application's own frames only; there is no network management. At a measured standstill only,
// and only until the vehicle moves. Reception is never switched off, because the speed arrives by it.
Nrc UdsServer::communication_control(const Request& request, const EcuState& ecu) noexcept {
    constexpr std::uint8_t network_management = 0x02U;
    const std::uint8_t sub_function = request.sub_function();
    const std::uint8_t messages = request.byte(2U);
    if ((messages == 0U) || (messages > 3U)) {
        return Nrc::request_out_of_range;
    }
    const bool sends = (sub_function == 0U);
    if (!sends && !is_standing(ecu)) {
        return Nrc::conditions_not_correct;
    }
    if (messages != network_management) {
        lets_ecu_send_ = sends;
    }
    response_.put(sub_function);
    return Nrc::none;
}

// At a measured standstill only, so that faults on the road are always recorded.
Nrc UdsServer::code_setting(const Request& request, const EcuState& ecu) noexcept {
    const std::uint8_t sub_function = request.sub_function();
    const bool records = (sub_function == 0x01U);
    if (!records && !is_standing(ecu)) {
        return Nrc::conditions_not_correct;
    }
    kept_.codes().set_recording(records);
    response_.put(sub_function);
    return Nrc::none;
}

Nrc UdsServer::routine_control(const Request& request, const EcuState& ecu) noexcept {
    constexpr std::size_t whole_length = 4U;
    if (request.length() < whole_length) {
        return Nrc::incorrect_length;
    }
    const std::uint32_t routine = request.u16_at(2U);
    const bool is_check = (routine == check_section_routine) && (session_ == Session::programming);
    const bool is_self_test = (routine == self_test_routine) && (session_ == Session::extended);
    const std::uint8_t sub_function = request.sub_function();
    if (!is_check && !is_self_test) {
        return Nrc::request_out_of_range;
    }
    if (is_check && !is_unlocked()) {
        return Nrc::security_access_denied;
    }
    if ((sub_function != start_routine) && (is_check || (sub_function != routine_results))) {
        return Nrc::sub_function_not_supported;
    }
    if (request.length() != whole_length) {
        return Nrc::incorrect_length;
    }
    return is_check ? check_section(request, ecu) : self_test(request, ecu);
}

// Reports the codes that fail now. It writes nothing: whether the memory takes records is known of the last.
Nrc UdsServer::self_test(const Request& request, const EcuState& ecu) noexcept {
    if (request.sub_function() == start_routine) {
        self_test_result_ = self_test_of(ecu.monitoring.confirmed_codes() |
                                         (kept_.is_failing() ? storage_failed : monitoring::CodeSet{0U}));
        has_self_test_result_ = true;
    }
    begin_routine_answer(request);
    response_.put(self_test_result_);
    return has_self_test_result_ ? Nrc::none : Nrc::request_sequence_error;
}

// Begun at rest, it goes on at rest only.
Nrc UdsServer::transfer(const Request& request, const EcuState& ecu) noexcept {
    if (is_moving(ecu)) {
        return Nrc::conditions_not_correct;
    }
    return (request.service() == service_id::transfer_data) ? download_.transfer(request, response_)
                                                            : download_.end(request);
}

Nrc UdsServer::check_section(const Request& request, const EcuState& ecu) noexcept {
    if (is_moving(ecu)) {
        return Nrc::conditions_not_correct;
    }
    std::uint8_t refusal = 0U;
    const Nrc code = download_.check_and_store(refusal);
    if (code == Nrc::response_pending) {
        waiting_ = Waiting::section_stored;
    } else {
        begin_routine_answer(request);
        response_.put(refusal);
    }
    kept_.report_section_memory(download_.is_memory_failing());
    return code;
}

Nrc UdsServer::request_download(const Request& request, const EcuState& ecu) noexcept {
    const Nrc code =
        download_.begin(request, is_unlocked(), !is_moving(ecu) && kept_.has_orders_left(), response_);
    if (code == Nrc::none) {
        static_cast<void>(kept_.takes_order());
    }
    return code;
}

// Nrc::response_pending while the record is not stored yet.
Nrc UdsServer::storage_answer(const EcuState& ecu) noexcept {
    const bool is_late = (wait_cycles_ >= most_wait_cycles);
    if (waiting_ == Waiting::section_stored) {
        return section_answer(check_section(waiting_for_, ecu), is_late);
    }
    if (!kept_.is_stored()) {
        kept_.continue_order();
        return is_late ? Nrc::programming_failure : Nrc::response_pending;
    }
    if (waiting_ == Waiting::codes_stored_before_reset) {  // not before it is counted
        promise_reset(waiting_for_);
        return Nrc::none;
    }
    begin_answer(waiting_for_, (waiting_for_.service() == service_id::write_data) ? 2U : 0U);
    return Nrc::none;
}

// Each wait ends the download, so that the tries of a memory are limited as downloads are.
Nrc UdsServer::section_answer(Nrc code, bool is_late) noexcept {
    const bool is_busy = (code == Nrc::response_pending);
    if (is_busy && !is_late) {
        return code;
    }
    download_.abort();
    return is_busy ? Nrc::programming_failure : code;
}

void UdsServer::wait_for_storage(const EcuState& ecu) noexcept {
    ++wait_cycles_;
    if (transport_.is_sending()) {
        return;
    }
    const Nrc code = storage_answer(ecu);
    if (code != Nrc::response_pending) {
        waiting_ = Waiting::nothing;
        answer(waiting_for_, code);
    } else if (wait_cycles_ == cycles_to_say_later) {
        say_no(waiting_for_, Nrc::response_pending);
        is_later_said_ = true;
        transport_.send(response_);
    } else {
        // one response-pending is enough: it extends the time limit to P2*
    }
}

}  // namespace rsi::diagnosis

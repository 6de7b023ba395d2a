// UDS server (ISO 14229-1): sessions, access, and the services of service_table.hpp.
#pragma once

#include <cstdint>

#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/diagnosis/data_identifiers.hpp"
#include "rsi/ecu/diagnosis/iso_tp.hpp"
#include "rsi/ecu/diagnosis/kept_data.hpp"
#include "rsi/ecu/diagnosis/section_download.hpp"
#include "rsi/ecu/diagnosis/service_table.hpp"
#include "rsi/ecu/diagnosis/uds.hpp"
#include "rsi/ecu/monitoring/diagnostic_memory.hpp"
#include "rsi/types.hpp"

namespace rsi::diagnosis {

inline constexpr std::uint32_t self_test_routine = 0x0203U;
inline constexpr std::uint32_t check_section_routine = 0xFF01U;

// Faults found by the self test, a bit each.
namespace self_test {
inline constexpr std::uint8_t parameters = 0x01U;  // refused or damaged
inline constexpr std::uint8_t memory = 0x02U;      // a bit of the component had changed
inline constexpr std::uint8_t computing = 0x04U;   // estimate or outputs
inline constexpr std::uint8_t timing = 0x08U;      // cycle or clock
inline constexpr std::uint8_t bus = 0x10U;
inline constexpr std::uint8_t storing = 0x20U;  // a memory does not take records, or has lost one
}  // namespace self_test

// Findings and outputs of the ECU in its last cycle.
struct EcuState {
    const monitoring::DiagnosticMemory& monitoring;
    const rsi::Inputs& inputs;
    const rsi::Outputs& outputs;
    const application::CalibrationIdentity& calibration;
};

class UdsServer {
 public:
    // All must outlive the server.
    UdsServer(IsoTp& transport, KeptData& kept, const Identification& identification) noexcept
        : transport_{transport}, kept_{kept}, identification_{identification} {}

    // Without them nothing is unlocked, and no section is taken. An unlocked session does not outlive a
    // start.
    void use(access::SeedAndKey& access) noexcept {
        access_ = &access;
        access.lock();
    }
    void use(SectionTarget& target) noexcept { download_.use(target); }

    // Once a cycle of 10 ms: answers at most one request.
    void step(const monitoring::DiagnosticMemory& monitoring, const rsi::Inputs& inputs,
              const rsi::Outputs& outputs, const application::CalibrationIdentity& calibration) noexcept {
        if (access_ != nullptr) {
            access_->end_cycle();
        }
        if ((session_ != Session::standard) || transport_.is_active()) {
            work(EcuState{monitoring, inputs, outputs, calibration});
            transport_.end_cycle();
        }
    }

    // A tester has asked for a reset and has his answer. For the platform: it starts the ECU anew.
    bool is_reset_requested() const noexcept { return is_reset_requested_ && !transport_.is_sending(); }

    Session session() const noexcept { return session_; }

    // False while CommunicationControl keeps the control unit's own frames from the bus.
    bool lets_ecu_send() const noexcept { return lets_ecu_send_; }

 private:
    // Reason that the answer to a request is pending.
    enum class Waiting : std::uint8_t { nothing, codes_stored, codes_stored_before_reset, section_stored };

    void work(const EcuState& ecu) noexcept;
    void serve(const Request& request, const EcuState& ecu) noexcept;
    void answer(const Request& request, Nrc code) noexcept;
    void say_no(const Request& request, Nrc code) noexcept;
    void begin_routine_answer(const Request& request) noexcept;
    void begin_answer(const Request& request, std::size_t repeated) noexcept;
    Nrc check_and_run(const Request& request, const EcuState& ecu) noexcept;
    Nrc run(const Request& request, const EcuState& ecu) noexcept;
    Nrc session_control(const Request& request, const EcuState& ecu) noexcept;
    Nrc reset(const EcuState& ecu) noexcept;
    Nrc wait_for_codes(Waiting reason) noexcept;
    void promise_reset(const Request& request) noexcept;
    void switch_all_on() noexcept;
    Nrc clear_codes(const Request& request, const EcuState& ecu) noexcept;
    Nrc read_data(const Request& request, const EcuState& ecu) noexcept;
    Nrc write_data(const Request& request, const EcuState& ecu) noexcept;
    Nrc security_access(const Request& request) noexcept;
    Nrc take_key(const Request& request) noexcept;
    Nrc communication_control(const Request& request, const EcuState& ecu) noexcept;
    Nrc code_setting(const Request& request, const EcuState& ecu) noexcept;
    Nrc routine_control(const Request& request, const EcuState& ecu) noexcept;
    Nrc self_test(const Request& request, const EcuState& ecu) noexcept;
    Nrc transfer(const Request& request, const EcuState& ecu) noexcept;
    Nrc check_section(const Request& request, const EcuState& ecu) noexcept;
    Nrc request_download(const Request& request, const EcuState& ecu) noexcept;

    void drop_functional_request() noexcept;
    void wait_for_storage(const EcuState& ecu) noexcept;
    Nrc section_answer(Nrc code, bool is_late) noexcept;
    Nrc storage_answer(const EcuState& ecu) noexcept;
    void count_session_time() noexcept;
    void enter(Session session) noexcept;
    bool is_unlocked() const noexcept { return (access_ != nullptr) && access_->is_unlocked(); }

    IsoTp& transport_;
    KeptData& kept_;
    const Identification& identification_;
    access::SeedAndKey* access_{nullptr};
    SectionDownload download_{};
    Response response_{};
    Request waiting_for_;
    std::uint32_t wait_cycles_{0U};
    std::uint32_t idle_cycles_{0U};  // since the tester's last request
    std::uint8_t self_test_result_{0U};
    bool has_self_test_result_{false};
    bool is_reset_requested_{false};
    bool lets_ecu_send_{true};
    bool is_later_said_{false};  // to the request that waits
    Waiting waiting_{Waiting::nothing};
    Session session_{Session::standard};
};

}  // namespace rsi::diagnosis

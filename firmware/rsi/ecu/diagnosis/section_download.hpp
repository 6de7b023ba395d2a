// Section download: RequestDownload, TransferData and RequestTransferExit (34, 36, 37) of a parameter
// section, and its check.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rsi/ecu/diagnosis/iso_tp.hpp"
#include "rsi/ecu/diagnosis/message.hpp"
#include "rsi/ecu/diagnosis/section_target.hpp"
#include "rsi/ecu/diagnosis/uds.hpp"

namespace rsi::diagnosis {

class SectionDownload {
 public:
    // `target` must outlive this object. Without one no download is accepted.
    void use(SectionTarget& target) noexcept { target_ = &target; }

    // `is_unlocked`, `is_allowed` (the vehicle stands, and so on): looked at after the request itself, in
    // this order.
    Nrc begin(const Request& request, bool is_unlocked, bool is_allowed, Response& response) noexcept;
    Nrc transfer(const Request& request, Response& response) noexcept;
    Nrc end(const Request& request) noexcept;

    // After a whole download only; ends it, unless the memory is busy. Nrc::response_pending: again in the
    // next cycle, or abort().
    Nrc check_and_store(std::uint8_t& refusal) noexcept;

    // As the target was after the last try to store.
    bool is_memory_failing() const noexcept { return is_memory_failing_; }

    void abort() noexcept { state_ = State::idle; }

 private:
    enum class State : std::uint8_t { idle, transferring, complete };

    // Service and block counter stand before the data.
    static constexpr std::size_t longest_block = IsoTp::longest_request;

    Nrc take_block(const Request& request) noexcept;

    SectionTarget* target_{nullptr};
    std::size_t received_{0U};
    std::uint8_t next_block_{1U};
    State state_{State::idle};
    bool is_memory_failing_{false};
};

}  // namespace rsi::diagnosis

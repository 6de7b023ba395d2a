// Live session: drives one after the other, the messages to their page, and its requests.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "sil/live/live_drive.hpp"
#include "sil/page/page_recording.hpp"

namespace sil {

// Keeps what a drive leaves.
class LiveRecorder : public RunObserver {
 public:
    // The drive is over, ended or followed by another one.
    virtual void finish() = 0;
};

// Before its first cycle; the drive lives until the recorder is gone.
using MakeLiveRecorder = std::function<std::unique_ptr<LiveRecorder>(const LiveDrive& drive)>;

// Knows neither clock nor network: the caller calls cycle() a hundred times a second, and carries the
// messages.
class LiveSession {
 public:
    // Begins the first drive. Throws what LiveDrive and the recorder throw.
    LiveSession(LiveVehicle what, double start_speed_kmh, MakeLiveRecorder make_recorder);
    LiveSession(const LiveSession&) = delete;
    LiveSession& operator=(const LiveSession&) = delete;
    ~LiveSession();

    // 10 ms of the drive; nothing while it is paused or over.
    void cycle();

    // From the page, as text. Throws InputError with a sentence for what is not understood.
    void take(const std::string& request);

    // For a page that has just come: the drive and its latest row, without what has happened in it before.
    std::string begin();

    // Changes since the last call, as JSON; empty when nothing is. Rows that are not fetched are dropped,
    // the oldest first.
    std::string news();

    // Ends the drive, if it is not over; only another one can follow.
    void finish();

    static constexpr std::size_t most_waiting_rows = 1000U;
    // From "all sensors good" on until the firmware uses them all again, with sensor noise; without, not in
    // any time.
    static constexpr double heals_within_s = 3.0;

 private:
    class Watch;

    void start(double speed_kmh, double load_kg);
    void add(const std::string& name, const std::string& json);
    std::string head() const;

    LiveVehicle what_;
    MakeLiveRecorder make_recorder_;
    DriverWish wish_{};
    double load_kg_{0.0};
    bool paused_{false};
    bool brakes_on_warning_{false};  // in the drives that follow, too
    bool over_{false};
    std::unique_ptr<LiveDrive> drive_{};
    std::unique_ptr<LiveRecorder> recorder_{};
    std::unique_ptr<Watch> watch_{};
    std::deque<std::string> rows_{};  // that wait
    std::string latest_row_{};        // of this drive; empty before the first
    std::string news_{};              // members of the next message, without the rows
};

}  // namespace sil

#include "sil/live/live_session.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "sil/live/live_request.hpp"
#include "sil/results/signal_csv.hpp"

namespace sil {

// Hands everything on to the recorder, and keeps the messages to the page.
class LiveSession::Watch final : public RunObserver {
 public:
    Watch(LiveSession& session, RunObserver& recorder) : session_{session}, recorder_{recorder} {}

    void cycle(const Truth& truth, const SensorSample& sample, const EcuFrames& ecu,
               const RunEvents& events) override {
        recorder_.cycle(truth, sample, ecu, events);
        session_.latest_row_ = page_row(signal_csv_row(truth, sample, ecu.output()));
        session_.rows_.push_back(session_.latest_row_);
        if (session_.rows_.size() > most_waiting_rows) {
            session_.rows_.pop_front();
        }
        if (diagnosis_.observe(truth.time_s, ecu.diagnosis())) {
            session_.add("diagnosis", diagnosis_json(diagnosis_.latest()));
        }
        const std::string now = events_json(events) + judgement_json(events);
        if (now != reported_) {
            reported_ = now;
            session_.add("events", events_json(events));
            session_.add("judgement", judgement_json(events));
        }
    }

    void step(const Truth& truth) override { recorder_.step(truth); }

    const PageDiagnosis& diagnosis() const { return diagnosis_.latest(); }

 private:
    LiveSession& session_;
    RunObserver& recorder_;
    DiagnosisWatch diagnosis_{};
    std::string reported_{};
};

namespace {

const char* end_text(const Truth& truth, const Manoeuvre& manoeuvre) {
    if (truth.time_s < manoeuvre.duration_s - cycle_time_s) {
        return "The vehicle has rolled over. Start again, or look back with the controls below.";
    }
    return "The time of this drive is over. Start again, or look back with the controls below.";
}

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump();
}

}  // namespace

LiveSession::LiveSession(LiveVehicle what, double start_speed_kmh, MakeLiveRecorder make_recorder)
    : what_{std::move(what)}, make_recorder_{std::move(make_recorder)} {
    start(start_speed_kmh, 0.0);
}

LiveSession::~LiveSession() = default;

void LiveSession::start(double speed_kmh, double load_kg) {
    wish_ = {0.0, from_kmh(speed_kmh)};
    load_kg_ = load_kg;
    watch_.reset();
    recorder_.reset();
    drive_ = std::make_unique<LiveDrive>(what_, wish_, load_kg);
    drive_->brake_on_warning(brakes_on_warning_);
    recorder_ = make_recorder_(*drive_);
    watch_ = std::make_unique<Watch>(*this, *recorder_);
    over_ = false;
    paused_ = false;
    rows_.clear();
    latest_row_.clear();
    news_.clear();
    add("drive", head());
    add("notice", quoted(""));
    add("fault", quoted(""));
    add("paused", "false");
    add("brake_on_warning", brakes_on_warning_ ? "true" : "false");
}

void LiveSession::finish() {
    if (!over_) {
        over_ = true;
        recorder_->finish();
    }
}

void LiveSession::cycle() {
    if (paused_ || over_) {
        return;
    }
    if (!drive_->cycle(*watch_)) {
        finish();
        add("notice", quoted(end_text(drive_->plant().truth(), drive_->manoeuvre())));
    }
}

void LiveSession::take(const std::string& text) {
    const LiveRequest request = parse_live_request(text);
    const std::optional<Fault> fault = request.fault ? chosen_fault(*request.fault) : std::nullopt;
    if (request.again) {
        finish();
        start(request.speed_kmh.value_or(wish_.speed_mps * 3.6), request.load_kg);
    }
    if (request.steering_deg) {
        wish_.steering_wheel_angle_rad = from_degrees(*request.steering_deg);
    }
    if (request.speed_kmh) {
        wish_.speed_mps = from_kmh(*request.speed_kmh);
    }
    if (request.pause) {
        paused_ = *request.pause;
        add("paused", paused_ ? "true" : "false");
    }
    if (request.brake_on_warning) {
        brakes_on_warning_ = *request.brake_on_warning;
        drive_->brake_on_warning(brakes_on_warning_);
        add("brake_on_warning", brakes_on_warning_ ? "true" : "false");
    }
    if (request.fault) {
        drive_->break_sensor(fault);
        add("fault", quoted(fault_text(fault)));
    }
}

// A later member of the same name counts, as in JSON.parse.
void LiveSession::add(const std::string& name, const std::string& json) {
    news_ += (news_.empty() ? "\"" : ",\"") + name + "\":" + json;
}

std::string LiveSession::head() const {
    const VehicleParameters& vehicle = drive_->plant().vehicle().parameters();
    PageHead head{what_.manoeuvre ? what_.manoeuvre->name : "Live drive",
                  vehicle.name + ", " + what_.ecu_text + ", in real time",
                  page_vehicle(vehicle),
                  {}};
    head.vehicle.roof_load_kg = load_kg_;
    std::string json = head_json(head);
    json.pop_back();
    return json +
           fmt::format(
               ",\"input\":{{\"speed_kmh\":{:.0f}}},\"driven\":{},\"heals_within_s\":{},\"faults\":{}}}",
               wish_.speed_mps * 3.6, !what_.manoeuvre,
               what_.sensors.noise ? fmt::format("{:.0f}", heals_within_s) : "null", live_faults_json());
}

std::string LiveSession::begin() {
    rows_.clear();
    news_.clear();
    add("drive", head());
    add("notice", quoted(over_ ? end_text(drive_->plant().truth(), drive_->manoeuvre()) : ""));
    add("fault", quoted(fault_text(drive_->fault())));
    add("paused", paused_ ? "true" : "false");
    add("brake_on_warning", brakes_on_warning_ ? "true" : "false");
    add("diagnosis", diagnosis_json(watch_->diagnosis()));
    add("events", events_json(drive_->loop().events()));
    add("judgement", judgement_json(drive_->loop().events()));
    if (!latest_row_.empty()) {
        rows_.push_back(latest_row_);
    }
    return news();
}

std::string LiveSession::news() {
    if (news_.empty() && rows_.empty()) {
        return {};
    }
    std::string message = "{" + news_;
    if (!rows_.empty()) {
        message += std::string{news_.empty() ? "" : ","} + "\"rows\":[";
        for (std::size_t row = 0U; row < rows_.size(); ++row) {
            message += (row > 0U ? "," : "") + rows_[row];
        }
        message += "]";
    }
    rows_.clear();
    news_.clear();
    return message + "}";
}

}  // namespace sil

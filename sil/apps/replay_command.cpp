#include "sil/apps/replay_command.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "sil/apps/command_line.hpp"
#include "sil/apps/drawing_script.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/files/file_io.hpp"
#include "sil/results/event_marks.hpp"
#include "sil/simulation/replay.hpp"
#include "sil/studies/drives/drive_csv.hpp"
#include "sil/studies/drives/drive_names.hpp"
#include "sil/studies/drives/drive_replay.hpp"
#include "sil/studies/drives/replay_csv.hpp"
#include "sil/studies/drives/replay_page.hpp"
#include "sil/studies/drives/replay_summary.hpp"
#include "sil/studies/drives/replay_table.hpp"
#include "sil/studies/drives/whole_folder.hpp"

namespace sil {
namespace {

volatile std::sig_atomic_t interruption = 0;

extern "C" void note_interruption(int) {
    interruption = 1;
}

bool is_interrupted() {
    return interruption != 0;
}

const std::vector<std::string>& replay_contents() {
    static const std::vector<std::string> names{"indices.csv", "warnings.csv", "diagnosis.csv",
                                                "events.gp",   "summary.json", "report.html",
                                                "replay.svg",  "replay.png"};
    return names;
}

DriveReplay replay_log(const std::vector<LoggedFrame>& log, const std::filesystem::path& file,
                       const rsi::Parameters& parameters) {
    try {
        return replay_drive(log, parameters, is_interrupted);
    } catch (const ReplayError& error) {
        throw std::runtime_error(error.line() > 0U
                                     ? fmt::format("{}:{}:1: {}", file.string(), error.line(), error.what())
                                     : fmt::format("{}: {}", file.string(), error.what()));
    }
}

// gnuplot belongs to the project's packages, so its absence is an error like any other.
void draw(const std::filesystem::path& folder) {
    const std::string script = drawing_script("sil/studies/drives/draw");
    if (!is_drawn(script, folder)) {
        throw std::runtime_error(
            fmt::format("{} failed (see above); with --no-pictures the replay does without it", script));
    }
}

class Replayer {
 public:
    explicit Replayer(const ReplayRequest& request)
        : request_{request},
          parameters_{load_calibration(request.parameters.string(), request.changes)},
          names_{drive_names(request.files)} {}

    std::vector<ReplayRow> run() {
        make_folder(request_.output);
        remove_file(request_.output / "table.csv");
        for (std::size_t index = 0U; index < request_.files.size(); ++index) {
            replay_or_tell(index);
        }
        write_file_atomically(request_.output / "table.csv", table_csv(rows_));
        fmt::print("{}", table_text(rows_));
        fmt::print("Results in {}\n", request_.output.string());
        std::fflush(stdout);
        if (!failed_.empty()) {
            throw std::runtime_error(fmt::format("{} of {} files could not be replayed (see above): {}",
                                                 failed_count_, request_.files.size(), failed_));
        }
        return rows_;
    }

 private:
    void replay_or_tell(std::size_t index) {
        const std::string file = request_.files[index].string();
        tell(fmt::format("[{}/{}] {}\n", index + 1U, request_.files.size(), file));
        try {
            rows_.push_back(replay_row(file, names_[index], replay_file(index)));
        } catch (const ReplayInterrupted&) {
            throw std::runtime_error(fmt::format(
                "interrupted at {}; there are whole results of the {} files before it, and no table", file,
                index));
        } catch (const std::exception& error) {
            tell(fmt::format("rsi-sil: {}\n", error.what()));
            rows_.push_back(failed_row(file, names_[index]));
            failed_ += (failed_.empty() ? "" : ", ") + file;
            ++failed_count_;
        }
    }

    DriveReplay replay_file(std::size_t index) {
        const std::filesystem::path& file = request_.files[index];
        WholeFolder folder{request_.output / names_[index], replay_contents()};
        ReplaySource source{names_[index], file.string(), "csv", request_.parameters.stem().string(), {}};
        DriveReplay replay;
        const std::string text = read_whole_file(file);
        if (is_candump_log(text)) {
            source.kind = "candump";
            const SiftedLog log = sift_candump_log(text);
            tell(log.left_out.text(file));
            replay = replay_log(log.frames, file, parameters_);
        } else {
            const Drive drive = parse_drive_csv(text, file);
            tell_ignored(drive);
            source.ignored_columns = drive.ignored_columns;
            replay = replay_drive(drive, parameters_, is_interrupted);
        }
        write(folder.path(), source, replay);
        folder.commit();
        return replay;
    }

    // Once for each set of columns: the files of one recorder all have the same.
    void tell_ignored(const Drive& drive) {
        if (drive.ignored_columns.empty() || drive.ignored_columns == reported_ignored_) {
            return;
        }
        reported_ignored_ = drive.ignored_columns;
        std::string names;
        for (const std::string& name : drive.ignored_columns) {
            names += (names.empty() ? "" : ", ") + name;
        }
        tell(fmt::format("  columns that a replay does not use: {}\n", names));
    }

    void write(const std::filesystem::path& folder, const ReplaySource& source, const DriveReplay& replay) {
        const std::string indices = indices_csv(replay);
        write_file_atomically(folder / "indices.csv", indices);
        write_file_atomically(folder / "report.html", replay_page(source, replay, parameters_, indices));
        write_file_atomically(folder / "warnings.csv", warnings_csv(replay));
        write_file_atomically(folder / "diagnosis.csv", diagnosis_csv(replay));
        write_event_marks(replay.events, static_stability_factor(parameters_),
                          fmt::format("{}, {}", source.drive, source.parameters), folder / "events.gp");
        write_file_atomically(folder / "summary.json", replay_summary_json(source, replay, parameters_));
        if (!request_.without_pictures) {
            draw(folder);
        }
        if (is_interrupted()) {
            throw ReplayInterrupted{};
        }
    }

    const ReplayRequest& request_;
    rsi::Parameters parameters_;
    std::vector<std::string> names_;
    std::vector<ReplayRow> rows_;
    std::vector<std::string> reported_ignored_;
    std::string failed_;
    std::size_t failed_count_{0U};
};

}  // namespace

std::vector<ReplayRow> run_replay(const ReplayRequest& request) {
    std::signal(SIGINT, note_interruption);
    std::signal(SIGTERM, note_interruption);
    return Replayer{request}.run();
}

void add_replay_command(CLI::App& app, ReplayRequest& request) {
    CLI::App* replay = app.add_subcommand("replay", "Send recorded drives through the firmware");
    replay->add_option("files", request.files, "Drives as CSV (docs/drives.md) or candump logs")->required();
    replay->add_option("--parameters", request.parameters, "Parameter file of the component (TOML)")
        ->required();
    replay
        ->add_option("--set", request.changes,
                     "KEY=VALUE in place of what the parameter file says; may be repeated")
        ->allow_extra_args(false);
    replay->add_option("--output", request.output, "Folder for the results")->required();
    replay->add_flag("--no-pictures", request.without_pictures, "Leave out the pictures");
    replay->callback([&request] { static_cast<void>(run_replay(request)); });
}

}  // namespace sil

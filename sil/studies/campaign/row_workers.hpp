// Row workers: threads that make the rows that a file lacks.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sil/studies/campaign/row_file.hpp"

namespace sil {

struct MadeRow {
    std::string line{};       // begins with the row's number
    double simulated_s{0.0};  // time that was driven for it, where that is counted
};

struct RowProgress {
    std::uint64_t finished{0U};  // rows in the file, those of earlier calls included
    std::uint64_t total{0U};
    std::uint64_t begun_with{0U};  // rows that were in the file already
    double elapsed_s{0.0};         // of this call
    double simulated_s{0.0};       // in this call
};

// Called after each finished row, by one thread at a time.
using RowListener = std::function<void(const RowProgress&)>;

// The number of the next row to make; nothing when there are no more.
using NextRow = std::function<std::optional<std::uint64_t>()>;
// Takes a row that was made; false: no more of them are wanted, not even of those that have been begun.
using RowTaker = std::function<bool(std::uint64_t number, const MadeRow& row)>;

struct RowWork {
    std::uint64_t total{0U};                              // rows
    unsigned jobs{1U};                                    // threads; fewer when the system gives no more
    std::function<MadeRow(std::uint64_t number)> make{};  // by several threads at a time
    // In its place, for rows that are made quicker together: all that `next` gives. By several threads at a
    // time.
    std::function<void(const NextRow& next, const RowTaker& take)> make_together{};
};

// Makes the rows, numbered from 0, that are missing and appends each to the file, which is sorted once all
// are there. Returns early, with every finished row kept, once `stop` is true or a row fails; of several
// failures throws the first.
RowProgress make_rows(RowFile& file, const RowWork& work, const std::atomic<bool>& stop,
                      const RowListener& listener);

// The same without a file: the lines of the rows from number `first` on, in their order. Those that were not
// made because `stop` became true are empty.
RowProgress make_lines(std::vector<std::string>& lines, std::uint64_t first, const RowWork& work,
                       const std::atomic<bool>& stop, const RowListener& listener);

}  // namespace sil

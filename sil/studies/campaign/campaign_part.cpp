// Campaign part: held in memory until it is whole.
#include "sil/studies/campaign/campaign_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "sil/files/file_io.hpp"
#include "sil/studies/campaign/campaign.hpp"
#include "sil/studies/campaign/campaign_folder.hpp"

namespace sil {
namespace {

constexpr std::string_view before_first = "# part of a campaign by rsi-sil: first ";
constexpr std::string_view before_count = ", count ";
constexpr std::string_view before_fingerprint = ", fingerprint ";

constexpr std::size_t longest_head = 200U;

bool take(std::string_view& rest, std::string_view expected) {
    const bool there = rest.substr(0U, expected.size()) == expected;
    rest.remove_prefix(there ? expected.size() : 0U);
    return there;
}

bool take(std::string_view& rest, std::uint64_t& number) {
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return error == std::errc{};
}

// As far as a head may reach.
std::string first_line(const std::filesystem::path& path) {
    const std::string text = read_beginning(path, longest_head);
    return text.substr(0U, text.find('\n'));
}

// Whether the very part is there already.
bool is_made(const std::filesystem::path& part, const PartHead& wanted) {
    if (!std::filesystem::exists(part)) {
        return false;
    }
    const std::string line = first_line(part);
    const std::optional<PartHead> there = part_head(line);
    if (!there) {
        throw InputError(
            fmt::format("{} is there and no part of a campaign; name another file", part.string()));
    }
    if (line != wanted.line()) {
        throw InputError(
            fmt::format("{} is another part: runs {} to {} of campaign {}, not runs {} to {} of {} "
                        "(settings, vehicle files "
                        "and program make the difference). Name another file, or remove this one",
                        part.string(), there->first, there->first + there->count - 1U, there->fingerprint,
                        wanted.first, wanted.first + wanted.count - 1U, wanted.fingerprint));
    }
    return true;
}

void check(const CampaignSettings& settings, std::uint64_t first, std::uint64_t count) {
    if (count == 0U || first >= settings.runs || count > settings.runs - first) {
        throw InputError(fmt::format(
            "runs {} to {} are not all of the campaign's {}; say how many there are in all: --runs N", first,
            first + count - 1U, settings.runs));
    }
}

}  // namespace

std::string PartHead::line() const {
    return fmt::format("{}{}{}{}{}{}", before_first, first, before_count, count, before_fingerprint,
                       fingerprint);
}

std::optional<PartHead> part_head(std::string_view line) {
    PartHead head;
    const bool good = take(line, before_first) && take(line, head.first) && take(line, before_count) &&
                      take(line, head.count) && take(line, before_fingerprint) && !line.empty() &&
                      head.count > 0U;
    head.fingerprint = line;
    return good ? std::optional{head} : std::nullopt;
}

std::vector<FoundPart> parts_of(const std::filesystem::path& folder) {
    std::vector<FoundPart> parts;
    if (!std::filesystem::is_directory(folder)) {
        return parts;
    }
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        if (entry.is_regular_file() && entry.path().extension() == ".csv") {
            if (const std::optional<PartHead> head = part_head(first_line(entry.path()))) {
                parts.push_back({entry.path(), *head});
            }
        }
    }
    std::sort(parts.begin(), parts.end(),
              [](const FoundPart& a, const FoundPart& b) { return a.head.first < b.head.first; });
    return parts;
}

RowProgress make_part(const CampaignWorld& world, std::uint64_t first, std::uint64_t count,
                      const std::filesystem::path& part, unsigned jobs, const std::atomic<bool>& stop,
                      const RowListener& listener) {
    check(world.settings(), first, count);
    const std::filesystem::path folder = part.has_parent_path() ? part.parent_path() : ".";
    begin_campaign_folder(folder, world.settings());
    const PartHead head{first, count, campaign_fingerprint(world.settings())};
    if (is_made(part, head)) {
        RowProgress progress;
        progress.total = progress.finished = progress.begun_with = count;
        return progress;
    }
    std::vector<std::string> lines;
    const RowProgress progress = make_lines(lines, first, campaign_work(world, count, jobs), stop, listener);
    if (progress.finished < progress.total) {
        return progress;
    }
    std::string text = head.line() + "\n" + row_header() + "\n";
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    write_file_atomically(part, text);
    return progress;
}

}  // namespace sil

#include "tests/quality/coding_rules/include_rules.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <utility>

namespace rsi_test {
namespace {

namespace fs = std::filesystem;

// One folder's rule. The first rule whose folder is a prefix of the file's path counts.
struct Rule {
    std::string folder;
    std::vector<std::string> project;  // folders of the project that it may include
    enum class Others { listed, standard, any } others;
    std::vector<std::string> listed;  // further headers, or prefixes that end in a slash
};

// Headers that exist without an operating system and that the component uses.
const std::vector<std::string> freestanding{"array",    "cfloat",   "climits",     "cstddef",    "cstdint",
                                            "limits",   "new",      "type_traits", "float.h",    "limits.h",
                                            "stddef.h", "stdint.h", "stdbool.h",   "stdalign.h", "iso646.h"};

// The project's folders as they stand in an include. The longest that fits is the one that counts.
const std::vector<std::string> component{"rsi/"};
const std::vector<std::string> ecu{"rsi/",
                                   "rsi/hal/",
                                   "rsi/can_dbc/",
                                   "rsi/ecu/access/",
                                   "rsi/ecu/xcp/",
                                   "rsi/ecu/monitoring/",
                                   "rsi/ecu/application/"};
const std::vector<std::string> images{"rsi/",
                                      "selftest/",
                                      "rsi/hal/",
                                      "rsi/can_dbc/",
                                      "rsi/ecu/access/",
                                      "rsi/ecu/xcp/",
                                      "rsi/ecu/monitoring/",
                                      "rsi/ecu/application/",
                                      "rsi/ecu/diagnosis/",
                                      "hal/",
                                      "images/"};

std::vector<std::string> together(std::vector<std::string> folders, const std::vector<std::string>& further) {
    folders.insert(folders.end(), further.begin(), further.end());
    return folders;
}

// Says which language the compiler must know, and nothing of the component.
const std::string language_check{"rsi/language.hpp"};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> all{
        {"firmware/rsi/numeric/matrix.hpp", {}, Rule::Others::listed, {"Eigen/"}},
        {"firmware/selftest/",
         {"rsi/", "selftest/"},
         Rule::Others::listed,
         together(freestanding, {"math.h", "string.h", "calibrations/"})},
        {"firmware/rsi/ecu/monitoring/", {"rsi/", "rsi/ecu/monitoring/"}, Rule::Others::standard, {}},
        {"firmware/rsi/ecu/access/", {"rsi/hal/", "rsi/ecu/access/"}, Rule::Others::standard, {}},
        {"firmware/rsi/ecu/xcp/",
         {"rsi/hal/", "rsi/ecu/access/", "rsi/ecu/xcp/"},
         Rule::Others::standard,
         {}},
        {"firmware/rsi/ecu/application/", ecu, Rule::Others::standard, {}},
        {"firmware/rsi/ecu/diagnosis/",
         {"rsi/", "rsi/hal/", "rsi/ecu/access/", "rsi/ecu/monitoring/", "rsi/ecu/application/",
          "rsi/ecu/diagnosis/"},
         Rule::Others::standard,
         {}},
        {"firmware/rsi/", component, Rule::Others::listed, freestanding},
        {"firmware/calibrations/", component, Rule::Others::listed, {}},
        {"can_dbc/", {"rsi/can_dbc/"}, Rule::Others::standard, {}},
        {"hal/interface/", {"rsi/hal/"}, Rule::Others::standard, {}},
        {"hal/", {"rsi/hal/", "hal/"}, Rule::Others::any, {}},
        {"firmware/images/", images, Rule::Others::any, {}},
        {"sil/", together(images, {"sil/"}), Rule::Others::any, {}},
        {"tests/", together(images, {"sil/", "tests/"}), Rule::Others::any, {}},
    };
    return all;
}

// The rooms that a room's CMake files may not name a path of; the top level and cmake/ put all of them
// together.
struct CMakeRule {
    std::string folder;
    std::vector<std::string> forbidden;
};

const std::vector<CMakeRule>& cmake_rules() {
    static const std::vector<CMakeRule> all{
        {"can_dbc/", {"firmware", "hal", "sil", "tests"}},
        {"hal/", {"firmware", "can_dbc", "sil", "tests"}},
        {"firmware/", {"sil", "tests"}},
        {"sil/", {"tests"}},
    };
    return all;
}

bool starts_with(const std::string& text, const std::string& beginning) {
    return text.compare(0, beginning.size(), beginning) == 0;
}

// The project's folder that a header is in, as it is written in an include; empty for all others.
std::string project_folder(const std::string& header) {
    static const std::vector<std::string> folders =
        together(images, {"rsi/ecu/", "firmware/", "can_dbc/", "sil/", "tests/"});
    std::string longest;
    for (const std::string& folder : folders) {
        if (starts_with(header, folder) && (folder.size() > longest.size())) {
            longest = folder;
        }
    }
    return longest;
}

// Standard headers of C++ have neither a folder nor an ending; those of C end in .h and are named here.
bool is_standard(const std::string& header) {
    static const std::vector<std::string> of_c{"assert.h", "errno.h",  "inttypes.h", "math.h",
                                               "stdio.h",  "stdlib.h", "string.h",   "time.h"};
    return (header.find_first_of("/.") == std::string::npos) ||
           (std::find(of_c.begin(), of_c.end(), header) != of_c.end()) ||
           (std::find(freestanding.begin(), freestanding.end(), header) != freestanding.end());
}

bool is_listed(const Rule& rule, const std::string& header) {
    return std::any_of(rule.listed.begin(), rule.listed.end(), [&header](const std::string& entry) {
        return (entry.back() == '/') ? starts_with(header, entry) : (header == entry);
    });
}

bool may_include_other(const Rule& rule, const std::string& header) {
    switch (rule.others) {
        case Rule::Others::listed:
            return is_listed(rule, header);
        case Rule::Others::standard:
            return is_standard(header);
        case Rule::Others::any:
            return true;
    }
    return false;
}

bool is_source(const fs::path& path) {
    static const std::vector<std::string> endings{".c", ".cc", ".cpp", ".h", ".hpp", ".inc", ".ipp"};
    return std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end();
}

bool is_cmake(const fs::path& path) {
    return path.filename() == "CMakeLists.txt" || path.extension() == ".cmake";
}

// The header that a line includes; empty when it includes none.
std::string included_by(const std::string& line) {
    const std::string blanks = " \t";
    std::size_t at = line.find_first_not_of(blanks);
    if ((at == std::string::npos) || (line[at] != '#')) {
        return {};
    }
    at = line.find_first_not_of(blanks, at + 1);
    if ((at == std::string::npos) || (line.compare(at, 7, "include") != 0)) {
        return {};
    }
    const std::size_t begin = line.find_first_of("<\"", at);
    const std::size_t end = (begin == std::string::npos) ? begin : line.find_first_of(">\"", begin + 1);
    return (end == std::string::npos) ? std::string{} : line.substr(begin + 1, end - begin - 1);
}

// Calls visit(path, line number, line) for each line of the sources and CMake files under `root`.
template <typename Visitor>
void visit_lines(const fs::path& root, const Visitor& visit) {
    for (const std::string top : {"can_dbc", "firmware", "hal", "sil", "tests"}) {
        if (!fs::exists(root / top)) {
            continue;
        }
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            if (!entry.is_regular_file() || !(is_source(entry.path()) || is_cmake(entry.path()))) {
                continue;
            }
            std::ifstream lines(entry.path());
            std::string line;
            for (int number = 1; std::getline(lines, line); ++number) {
                visit(fs::relative(entry.path(), root), number, line);
            }
        }
    }
}

// The project's file that an include in `path` names; empty for all others.
fs::path included_file(const fs::path& root, const fs::path& path, const std::string& header) {
    for (const fs::path& folder : {fs::path{}, fs::path{"firmware"}, fs::path{"hal/interface"},
                                   fs::path{"can_dbc/include"}, path.parent_path()}) {
        if (!header.empty() && fs::is_regular_file(root / folder / header)) {
            return (folder / header).lexically_normal();
        }
    }
    return {};
}

// The two folders beside each other that hold one file each; the first is empty when there are none.
std::pair<std::string, std::string> folders_beside(const fs::path& one, const fs::path& other) {
    const fs::path from = one.parent_path();
    const fs::path to = other.parent_path();
    const auto [a, b] = std::mismatch(from.begin(), from.end(), to.begin(), to.end());
    if (a == from.end() || b == to.end()) {
        return {};
    }
    fs::path common;
    std::for_each(from.begin(), a, [&common](const fs::path& part) { common /= part; });
    return {(common / *a).generic_string(), (common / *b).generic_string()};
}

using FolderUses =
    std::map<std::pair<std::string, std::string>, std::string>;  // user and used: first include

// The shortest way by which `from` uses `to`, as " -> from -> ... -> to"; empty when it does not.
std::string way(const FolderUses& uses, const std::string& from, const std::string& to) {
    std::vector<std::pair<std::string, std::string>> reached{{from, " -> " + from}};
    std::set<std::string> seen{from};
    for (std::size_t next = 0U; next < reached.size(); ++next) {
        const auto [folder, text] = reached[next];
        if (folder == to) {
            return text;
        }
        for (const auto& [pair, include] : uses) {
            if (pair.first == folder && seen.insert(pair.second).second) {
                reached.emplace_back(pair.second, text + " -> " + pair.second);
            }
        }
    }
    return {};
}

}  // namespace

std::string objection(const std::string& path, const std::string& header) {
    const auto rule = std::find_if(rules().begin(), rules().end(), [&path](const Rule& candidate) {
        return starts_with(path, candidate.folder);
    });
    if (rule == rules().end()) {
        return "the folder has no rule: add one to tests/quality/coding_rules/include_rules.cpp";
    }
    if (header.find("../") != std::string::npos) {
        return "include \"" + header + "\" by its path from the project, without ..";
    }
    if (header == language_check && starts_with(path, "firmware/rsi/")) {
        return {};
    }
    const std::string folder = project_folder(header);
    const bool allowed =
        folder.empty() ? may_include_other(*rule, header)
                       : std::find(rule->project.begin(), rule->project.end(), folder) != rule->project.end();
    return allowed ? std::string{} : rule->folder + " may not include " + header;
}

std::string cmake_objection(const std::string& path, const std::string& line) {
    const std::string code = line.substr(0, line.find('#'));
    for (const CMakeRule& rule : cmake_rules()) {
        if (!starts_with(path, rule.folder)) {
            continue;
        }
        for (const std::string& room : rule.forbidden) {
            // "room/..." or ".../room", but neither "room_library" nor the plain word.
            const std::regex names_it("(^|[^A-Za-z0-9_-])" + room + "/|/" + room + "($|[^A-Za-z0-9_.-])");
            if (std::regex_search(code, names_it)) {
                return "a CMake file of " + rule.folder + " may not name a path of " + room + "/";
            }
        }
    }
    return {};
}

std::vector<std::string> forbidden_includes(const std::string& root) {
    std::vector<std::string> found;
    visit_lines(root, [&found](const fs::path& file, int number, const std::string& line) {
        const std::string path = file.generic_string();
        const std::string header = is_cmake(file) ? std::string{} : included_by(line);
        const std::string why = is_cmake(file)   ? cmake_objection(path, line)
                                : header.empty() ? std::string{}
                                                 : objection(path, header);
        if (!why.empty()) {
            found.push_back(path + ":" + std::to_string(number) + ": " + why);
        }
    });
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::string> headers_without_user(const std::string& root) {
    std::map<std::string, bool> has_user;
    visit_lines(root, [&](const fs::path& file, int /*number*/, const std::string& line) {
        if (is_cmake(file) || *file.begin() == "tests") {
            return;
        }
        if (file.extension() == ".hpp" || file.extension() == ".h") {
            has_user.try_emplace(file.generic_string(), false);
        }
        const fs::path used = included_file(root, file, included_by(line));
        if (!used.empty() && fs::path{used}.replace_extension() != fs::path{file}.replace_extension()) {
            has_user[used.generic_string()] = true;
        }
    });
    std::vector<std::string> found;
    for (const auto& [header, user] : has_user) {
        if (!user) {
            found.push_back(header);
        }
    }
    return found;
}

std::vector<std::string> folder_circles(const std::string& root) {
    FolderUses uses;
    visit_lines(root, [&](const fs::path& file, int number, const std::string& line) {
        const fs::path used = included_file(root, file, included_by(line));
        const auto folders = folders_beside(file, used);
        if (!folders.first.empty()) {
            uses.try_emplace(folders, file.generic_string() + ":" + std::to_string(number));
        }
    });
    std::vector<std::string> found;
    for (const auto& [folders, include] : uses) {
        const std::string back = way(uses, folders.second, folders.first);
        if (!back.empty()) {
            found.push_back(include + ": folders use each other: " + folders.first + back);
        }
    }
    return found;
}

}  // namespace rsi_test

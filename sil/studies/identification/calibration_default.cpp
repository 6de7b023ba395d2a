#include "sil/studies/identification/calibration_default.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

#include "calibration_template.hpp"

namespace sil {

std::string_view key_in(std::string_view line) {
    const std::size_t end = line.find(" = ");
    return line.empty() || line.front() == '#' || end == std::string_view::npos ? std::string_view{}
                                                                                : line.substr(0U, end);
}

double calibration_default(std::string_view key) {
    std::istringstream lines{calibration_template};
    for (std::string line; std::getline(lines, line);) {
        if (key_in(line) == key) {
            return std::stod(line.substr(key.size() + 3U));
        }
    }
    throw std::logic_error("the calibration template lacks " + std::string{key});
}

}  // namespace sil

#include "sil/studies/faults/page_template.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

namespace sil {

std::string fill_template(std::string_view page, const std::map<std::string, std::string>& values) {
    std::string text;
    std::set<std::string> used;
    std::size_t position = 0U;
    for (std::size_t open = page.find("{{"); open != std::string_view::npos;
         open = page.find("{{", position)) {
        const std::size_t close = page.find("}}", open);
        if (close == std::string_view::npos) {
            throw std::invalid_argument("the template has a {{ without a }}");
        }
        const std::string name{page.substr(open + 2U, close - open - 2U)};
        const auto value = values.find(name);
        if (value == values.end()) {
            throw std::invalid_argument(fmt::format("the template asks for {}, which is not given", name));
        }
        text += page.substr(position, open - position);
        text += value->second;
        used.insert(name);
        position = close + 2U;
    }
    text += page.substr(position);
    for (const auto& [name, value] : values) {
        if (used.count(name) == 0U) {
            throw std::invalid_argument(fmt::format("the template does not ask for {}", name));
        }
    }
    return text;
}

}  // namespace sil

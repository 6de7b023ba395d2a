// Versions: which component, built from what and by what.
#pragma once

#include <string>

namespace sil {

struct Versions {
    std::string component;     // the project's version
    std::string git_revision;  // empty where the build knew none (a source archive)
    std::string compiler;
};

Versions built_versions();

}  // namespace sil

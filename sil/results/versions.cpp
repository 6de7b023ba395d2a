// Versions: what the build wrote into this program.
#include "sil/results/versions.hpp"

#include "git_revision.hpp"

namespace sil {

Versions built_versions() {
    return {RSI_COMPONENT_VERSION, RSI_GIT_REVISION, RSI_COMPILER};
}

}  // namespace sil

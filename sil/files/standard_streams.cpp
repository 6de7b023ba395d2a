#include "sil/files/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace sil {

void occupy_closed_streams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (::fcntl(stream, F_GETFD) < 0) {
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
        }
    }
}

int finish_output(std::string_view program) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
        return 0;
    }
    static_cast<void>(std::fprintf(stderr,
                                   "%.*s: not all of the output could be written; check where it goes to: is "
                                   "it closed, or is the disk full?\n",
                                   static_cast<int>(program.size()), program.data()));
    return 1;
}

}  // namespace sil

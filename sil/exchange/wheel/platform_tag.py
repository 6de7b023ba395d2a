"""Hook of hatchling: the wheel's tag, any Python 3 on Linux with a C library as new as the package's library needs."""

import pathlib
import platform
import re
import subprocess

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class PlatformTag(BuildHookInterface):
    def initialize(self, version, build_data):
        library = pathlib.Path(self.root, "rsi_component/librsi_judge.so")
        symbols = subprocess.check_output(["objdump", "--dynamic-syms", library], text=True)
        newest = max(map(int, re.findall(r"\bGLIBC_2\.(\d+)", symbols)))
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-manylinux_2_{newest}_{platform.machine()}"

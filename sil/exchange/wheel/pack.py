"""Packs the wheel of the Python package, for sil/exchange/wheel/build: pack.py DIR BUILD, BUILD being the folder in
which the target rsi_wheel was built. The same files give the same bytes."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[3]
HERE = PROJECT / "sil/exchange/wheel"
sys.path.insert(0, str(PROJECT / "cmake/environment"))

import file_io  # noqa: E402

# Their licences go with the wheel.
COMPILED_IN = ("libeigen3-dev", "libfmt-dev", "libtomlplusplus-dev", "libstdc++-12-dev")


def files(build):
    """{path in the folder that is packed: source}."""
    package = {path.name: path for path in (HERE / "rsi_component").iterdir() if path.is_file()}
    package["judge.py"] = PROJECT / "sil/judge/judge.py"
    package["librsi_judge.so"] = build / "sil/exchange/wheel/librsi_wheel.so"
    package |= {f"calibrations/{path.name}": path for path in (PROJECT / "firmware/calibrations").glob("*.toml")}
    others = {name: HERE / name for name in ("pyproject.toml", "platform_tag.py")}
    others |= {"LICENSE": PROJECT / "LICENSE", "version.h": PROJECT / "firmware/rsi/version.h"}
    others |= {f"licenses/{name}.txt": pathlib.Path("/usr/share/doc", name, "copyright") for name in COMPILED_IN}
    return {f"rsi_component/{name}": path for name, path in package.items()} | others


def main(output, build):
    with tempfile.TemporaryDirectory() as scratch:
        for name, path in files(build).items():
            target = pathlib.Path(scratch, name)
            if not path.is_file():
                sys.exit(f"sil/exchange/wheel/build: there is no {path}; run: sil/exchange/wheel/build")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, target)
        made = pathlib.Path(scratch, "made")
        command = [sys.executable, "-B", "-m", "hatchling", "build", "-t", "wheel", "-d", made]
        done = subprocess.run(command, cwd=scratch, capture_output=True, text=True, check=False)
        if done.returncode:
            sys.exit(f"{done.stdout}{done.stderr.strip()}\nsil/exchange/wheel/build: nothing was written")
        [wheel] = made.iterdir()
        try:
            output.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            sys.exit(f"sil/exchange/wheel/build: {output}: {error.strerror}; give another --output")
        file_io.write(output / wheel.name, wheel.read_bytes())
        print(output / wheel.name)


if __name__ == "__main__":
    main(*(pathlib.Path(word).resolve() for word in sys.argv[1:]))

"""Links and packs the FMUs, for sil/exchange/fmu/build: pack.py VEHICLE.toml CALIBRATION.toml DIR BUILD, BUILD being the folder in
which its targets were built."""

import dataclasses
import hashlib
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import uuid
import xml.sax.saxutils
import zipfile

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(PROJECT / "cmake/environment"))

import description
import file_io
import page
import structure

COMPILER = "/usr/bin/g++"
OPTIONS = ("-std=c++17", "-O2", "-fPIC", "-ffp-contract=off", "-fvisibility=hidden", "-fvisibility-inlines-hidden")
WINDOWS_COMPILER = "/usr/bin/x86_64-w64-mingw32-g++"
UNIT = "rsi_ecu.cpp"  # the only source to be compiled; it includes the others
INTERFACE = ("fmi2.cpp", "fmi3.cpp", "instance.cpp", "serial_state.cpp")
# Else two FMUs in a process might find each other's functions.
EXPORTED = "{ global: fmi2*; fmi3*; rsi_fmu_variables; local: *; };\n"


@dataclasses.dataclass
class Model:
    identifier: str
    name: str
    description: str
    serialises: bool
    archives: tuple  # within the build; the first one as a whole, the others as far as it needs them
    headers: tuple  # its comments are the descriptions of the parameters
    start_values: str = ""
    token: str = ""
    version: str = ""


ECU = Model("rsi_ecu", "Rollover-warning ECU component",
            "warns of a rollover before two wheels lift; steps every 10 ms, physical signals", True, ("exchange/fmu/libfmu_ecu.a",),
            (PROJECT / "firmware/rsi/rsi.h",))
VEHICLE = Model("rsi_vehicle", "Simulated vehicle", "14 degrees of freedom, with driver, road and sensors", False,
                ("exchange/fmu/libfmu_vehicle.a", *(f"world/{room}/libsil_{room}.a" for room in ("manoeuvres", "sensors", "vehicle"))),
                (PROJECT / "sil/world/vehicle/parameters.hpp",))


def run(*command):
    """Its output; after a failure ends the program with its message."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{done.stderr.strip()}\nsil/exchange/fmu/build: nothing was written")
    return done.stdout


def complete(model, kind, file, build):
    """Start values, and a token that another binary or another file changes."""
    values = run(build / "sil/exchange/fmu/fmu-start-values", kind, file)
    digest = hashlib.sha256(values.encode())
    model.archives = tuple(build / "sil" / archive for archive in model.archives)
    for archive in model.archives:
        digest.update(archive.read_bytes())
    model.version = re.search(r'RSI_VERSION "(.*)"', file_io.read(PROJECT / "firmware/rsi/version.h"))[1]
    model.description += f"; {kind} {file.stem}"
    model.token = "{" + str(uuid.UUID(bytes=digest.digest()[:16])) + "}"
    model.start_values = "\n".join([
        "// Written by sil/exchange/fmu/build.",
        '#include "sil/exchange/fmu/start_values.hpp"', "", "namespace fmu {", "",
        f'const char* const instantiation_token = "{model.token}";', "",
        f"const double start_values[] = {{\n{values}}};", "", "}  // namespace fmu", ""])


def link(model, folder):
    """The shared library in `folder`."""
    source, binary = folder / "start_values.cpp", folder / f"{model.identifier}.so"
    exported = folder / "exported"
    file_io.write(source, model.start_values)
    file_io.write(exported, EXPORTED)
    run(COMPILER, *OPTIONS, f"-I{PROJECT}", "-shared", "-s", "-Wl,-z,defs", f"-Wl,--version-script={exported}",
        "-o", binary, source, "-Wl,--whole-archive", model.archives[0], "-Wl,--no-whole-archive", *model.archives[1:])
    return binary


def sources_of_ecu(folder):
    """{path in the FMU: bytes} of all that UNIT needs, with the interface of both versions of FMI."""
    run(PROJECT / "firmware/export", folder)
    files = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix().removeprefix("eigen3/")
        around = name.startswith(("rsi/ecu/", "rsi/can_dbc/", "rsi/hal/"))
        if path.is_file() and not around and name.startswith(("rsi/", "Eigen/", "rsi_unit.cpp")):
            files[name] = path.read_bytes()
    wanted = [f"sil/exchange/fmu/{name}" for name in ("ecu_model.cpp", *INTERFACE)]
    for name in wanted:  # grows by what each file includes
        files[name] = (PROJECT / name).read_bytes()
        included = re.findall(r'^#include "(sil/[^"]+)"', files[name].decode(), re.MULTILINE)
        wanted += [file for file in included if file not in wanted]
    files["sil/exchange/fmu/start_values.cpp"] = ECU.start_values.encode()
    return files


def unit(version):
    other = f"fmi{5 - version}.cpp"
    includes = ["rsi_unit.cpp", "sil/exchange/fmu/ecu_model.cpp", *(f"sil/exchange/fmu/{name}" for name in INTERFACE if name != other),
                "sil/exchange/fmu/start_values.cpp"]
    return ("// All of the FMU: compile this source alone, with this folder on the include path. GCC or clang, C++17.\n"
            f"//     g++ {' '.join(OPTIONS)} -shared -I. {UNIT} -o rsi_ecu.so\n"
            "#define EIGEN_DONT_VECTORIZE\n\n" + "".join(f'#include "{name}"\n' for name in includes)).encode()


def build_description():
    options = xml.sax.saxutils.quoteattr(" ".join(OPTIONS))
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            '<fmiBuildDescription fmiVersion="3.0">\n'
            f'  <BuildConfiguration modelIdentifier="{ECU.identifier}" description="any platform with GCC or clang">\n'
            f'    <SourceFileSet name="all" language="C++17" compiler="gcc" compilerOptions={options}>\n'
            f'      <SourceFile name="{UNIT}"/>\n'
            '      <IncludeDirectory name="."/>\n'
            '    </SourceFileSet>\n'
            '  </BuildConfiguration>\n'
            '</fmiBuildDescription>\n').encode()


def files_of(model, version, binary, rows, sources):
    """{path in the FMU: bytes}."""
    own = sources if model is ECU else {}
    text = description.fmi2(model, rows, [UNIT] if own else []) if version == 2 else description.fmi3(model, rows)
    licence = (PROJECT / "LICENSE").read_bytes()
    if own:
        licence += b"\nThe headers in sources/Eigen are others': the Mozilla Public License 2.0, or what their heads say.\n"
    platform = "linux64" if version == 2 else "x86_64-linux"
    files = {"modelDescription.xml": text.encode(), f"binaries/{platform}/{binary.name}": binary.read_bytes(),
             "documentation/index.html": page.text_of(model, rows).encode(), "documentation/licenses/license.txt": licence}
    if own and version == 3:
        files["sources/buildDescription.xml"] = build_description()
    files |= {f"sources/{name}": content for name, content in own.items()}
    if own:
        files[f"sources/{UNIT}"] = unit(version)
    return files


def content_of(files):
    """An archive; the same bytes for the same files."""
    with io.BytesIO() as file:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in files.items():
                archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
        return file.getvalue()


def structure_of(packed, rows, version):
    """{path in the SSP: bytes}; both FMUs are of FMI 2, which SSP 1.0 knows."""
    files = {"SystemStructure.ssd": structure.text_of(rows[VEHICLE.identifier], rows[ECU.identifier], version).encode()}
    for model in (VEHICLE, ECU):
        name = f"{model.identifier}_fmi2.fmu"
        files[f"resources/{name}"] = content_of(packed[name])
    return files


def add_windows(packed, scratch):
    """DLLs of the ECU, by the FMUs' own sources."""
    for version, platform in ((2, "win64"), (3, "x86_64-windows")):
        files, folder = packed[f"{ECU.identifier}_fmi{version}.fmu"], scratch / platform
        for name, content in files.items():
            if name.startswith("sources/"):
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                file_io.write(folder / name, content)
        binary = folder / f"{ECU.identifier}.dll"
        run(WINDOWS_COMPILER, "-std=c++17", "-O2", "-ffp-contract=off", "-shared", "-static", "-s", f"-I{folder}/sources", "-o",
            binary, folder / "sources" / UNIT)
        files[f"binaries/{platform}/{binary.name}"] = binary.read_bytes()


def main(vehicle_file, calibration, output, build, windows=None):
    complete(ECU, "calibration", calibration, build)
    complete(VEHICLE, "vehicle", vehicle_file, build)
    packed, all_rows = {}, {}
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        sources = sources_of_ecu(scratch / "export")
        for model in (ECU, VEHICLE):
            binary = link(model, scratch)
            rows = description.table_of(binary)
            description.explain(rows, *model.headers)
            all_rows[model.identifier] = rows
            for version in (2, 3):
                packed[f"{model.identifier}_fmi{version}.fmu"] = files_of(model, version, binary, rows, sources)
        if windows is not None:
            add_windows(packed, scratch)
    packed["rollover_warning.ssp"] = structure_of(packed, all_rows, ECU.version)
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        sys.exit(f"sil/exchange/fmu/build: cannot make the folder {output}: {error.strerror}; give another --output")
    for name, files in packed.items():
        file_io.write(output / name, content_of(files))
        print(output / name)


if __name__ == "__main__":
    main(*(pathlib.Path(word) for word in sys.argv[1:]))

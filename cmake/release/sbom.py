"""The bill of materials of a release, as SPDX 2.3 in JSON.

Its files, and the Debian packages of which something is in them: libraries that a program loads, objects that the
linker took into an image, headers that the compiler read; and Mbed TLS, of whose sources a program is made. It is found
out from the programs, the linker's map and the compiler's lists of dependencies, not from a list kept by hand.
"""

import dataclasses
import datetime
import hashlib
import json
import pathlib
import re
import subprocess

MBEDTLS = pathlib.Path(__file__).resolve().parents[2] / "build/mbedtls"
LICENSES = {"libeigen3-dev": "MPL-2.0"}  # with EIGEN_MPL2_ONLY; of the others: /usr/share/doc/PACKAGE/copyright


class SbomError(Exception):
    pass


@dataclasses.dataclass(frozen=True)
class Build:
    """One program: its build folder, ninja's name for it, its copy in the release, and the linker's map if it is static."""

    folder: pathlib.Path
    target: str
    file: pathlib.Path
    map: pathlib.Path | None = None


def output_of(*command):
    finished = subprocess.run(command, capture_output=True, text=True, check=False)
    if finished.returncode != 0:
        raise SbomError(f"{' '.join(map(str, command))} failed: {finished.stderr.strip()}")
    return finished.stdout


def loaded(program):
    """The shared libraries that a program loads."""
    return set(re.findall(r"(/\S+) \(0x", output_of("ldd", program)))


def linked(map_file):
    """The libraries and objects of the system of which something is in an image."""
    text = map_file.read_text(errors="replace")
    members = text.split("\nDiscarded input sections")[0].split("\nMemory Configuration")[0]
    archives = set(re.findall(r"^(/\S+\.a)\(", members, re.M))
    return archives | set(re.findall(r"^LOAD (/\S+\.o)$", text, re.M))


def read_headers(build):
    """The files of the system that the compiler read for a program's objects."""
    inputs = set(output_of("ninja", "-C", build.folder, "-t", "inputs", build.target).splitlines())
    headers = set()
    known = set()
    wanted = False
    for line in output_of("ninja", "-C", build.folder, "-t", "deps").splitlines():
        if line and not line.startswith(" "):
            name = line.split(":")[0]
            wanted = name in inputs
            known |= {name} & inputs
        elif wanted and line.strip().startswith("/usr/"):
            headers.add(line.strip())
    missing = {name for name in inputs if name.endswith((".cpp.o", ".cpp.obj", ".cxx.o"))} - known
    if missing or not headers:
        raise SbomError(f"ninja does not know what {sorted(missing)[:1] or build.target} was made from; build it anew")
    return headers


def is_made_of_mbedtls(build):
    """Whether its sources are among the inputs of a program, or its code in the map of an image."""
    if build.map:
        return "libmbedtls_aes.a(" in build.map.read_text(errors="replace").split("\nDiscarded input sections")[0]
    return "/library/aes.c" in output_of("ninja", "-C", build.folder, "-t", "inputs", build.target)


def mbedtls():
    """Sources from cmake/environment/fetch_mbedtls."""
    number = (MBEDTLS / "version").read_text().strip()
    return {
        "SPDXID": identifier("Package", "mbedtls"),
        "name": "mbedtls",
        "versionInfo": number,
        "supplier": "Organization: Debian",
        "downloadLocation": "https://snapshot.debian.org/package/mbedtls/",
        "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": "Apache-2.0",
        "copyrightText": "Copyright The Mbed TLS Contributors",
        "externalRefs": [{
            "referenceCategory": "PACKAGE-MANAGER",
            "referenceType": "purl",
            "referenceLocator": f"pkg:deb/debian/mbedtls@{number}?arch=source",
        }],
    }


def packages_of(paths):
    """Debian package by path. A path may be known to dpkg with or without /usr."""
    candidates = {}
    for path in paths:
        real = str(pathlib.Path(path).resolve())
        for name in (path, real, real.removeprefix("/usr"), "/usr" + path):
            candidates.setdefault(name, set()).add(path)
    listing = subprocess.run(["dpkg-query", "--search", *sorted(candidates)], capture_output=True, text=True, check=False).stdout
    found = {}
    for line in listing.splitlines():
        packages, _, name = line.partition(": ")
        for path in candidates.get(name, ()):
            found[path] = packages.split(",")[0].split(":")[0]
    unknown = sorted(set(paths) - found.keys())
    if unknown:
        raise SbomError(f"no Debian package owns {unknown[0]}, which is part of the release")
    return set(found.values())


def compilers(build):
    """The compiler that CMake has found."""
    found = "".join(path.read_text() for path in build.folder.glob("CMakeFiles/*/CMakeC*Compiler.cmake"))
    paths = re.findall(r'^set\(CMAKE_(?:C|CXX)_COMPILER "(/.*)"\)$', found, re.M)
    if not paths:
        raise SbomError(f"{build.folder} does not say what compiler it used")
    return packages_of({str(pathlib.Path(path).resolve()) for path in paths})


def described(package):
    fields = output_of("dpkg-query", "--show", "--showformat=${Version}\t${Architecture}\t${source:Package}\t${Homepage}", package)
    number, architecture, source, homepage = fields.split("\t")
    text = {
        "SPDXID": identifier("Package", package),
        "name": package,
        "versionInfo": number,
        "supplier": "Organization: Debian",
        "downloadLocation": f"https://snapshot.debian.org/package/{source}/",
        "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": LICENSES.get(package, "NOASSERTION"),
        "copyrightText": "NOASSERTION",
        "externalRefs": [{
            "referenceCategory": "PACKAGE-MANAGER",
            "referenceType": "purl",
            "referenceLocator": f"pkg:deb/debian/{package}@{number.replace('+', '%2B').replace(':', '%3A')}?arch={architecture}",
        }],
    }
    if homepage:
        text["homepage"] = homepage
    return text


def identifier(kind, name):
    return f"SPDXRef-{kind}-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def file_entry(number, name, content):
    return {
        "SPDXID": f"SPDXRef-File-{number}",
        "fileName": f"./{name}",
        "checksums": [{"algorithm": "SHA1", "checksumValue": hashlib.sha1(content).hexdigest()},
                      {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()}],
        "licenseConcluded": "NOASSERTION",
        "copyrightText": "NOASSERTION",
    }


def related(element, relation, other, comment=None):
    entry = {"spdxElementId": element, "relationshipType": relation, "relatedSpdxElement": other}
    return entry | ({"comment": comment} if comment else {})


def document(folder, version, seconds, files, builds):
    """The JSON text for the files of a release folder."""
    names = [path.relative_to(folder).as_posix() for path in files]
    entries = [file_entry(number, name, path.read_bytes()) for number, (name, path) in enumerate(zip(names, files), 1)]
    of_file = {name: entry["SPDXID"] for name, entry in zip(names, entries)}
    whole = identifier("Package", "rsi")
    packages = set()
    made_of_mbedtls = []
    relations = [related("SPDXRef-DOCUMENT", "DESCRIBES", whole)]
    relations += [related(whole, "CONTAINS", entry["SPDXID"]) for entry in entries]
    for build in builds:
        file = of_file[build.file.relative_to(folder).as_posix()]
        parts = packages_of(linked(build.map) if build.map else loaded(build.file))
        headers = packages_of(read_headers(build))
        tools = compilers(build)
        packages |= parts | headers | tools
        relations += [related(file, "STATIC_LINK" if build.map else "DYNAMIC_LINK", identifier("Package", part))
                      for part in sorted(parts)]
        relations += [related(file, "DEPENDS_ON", identifier("Package", package), "compiled with its headers")
                      for package in sorted(headers)]
        relations += [related(identifier("Package", tool), "BUILD_TOOL_OF", file) for tool in sorted(tools)]
        if is_made_of_mbedtls(build):
            made_of_mbedtls.append(related(file, "STATIC_LINK", identifier("Package", "mbedtls"), "made of its sources"))
    eigen = next(iter(packages_of(["/usr/include/eigen3/Eigen/Core"])))
    packages.add(eigen)
    relations += [related(of_file[name], "COPY_OF", identifier("Package", eigen), "one of its headers")
                  for name in names if name.startswith("sources/eigen3/")]
    relations += made_of_mbedtls
    sha1 = sorted(entry["checksums"][0]["checksumValue"] for entry in entries)
    release = {
        "SPDXID": whole,
        "name": "rsi",
        "versionInfo": version,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": True,
        "packageVerificationCode": {"packageVerificationCodeValue": hashlib.sha1("".join(sha1).encode()).hexdigest()},
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": "MIT",
        "copyrightText": "NOASSERTION",
        "primaryPackagePurpose": "FIRMWARE",
    }
    content = {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": folder.name,
        "documentNamespace": f"https://spdx.org/spdxdocs/{folder.name}-{release['packageVerificationCode']['packageVerificationCodeValue']}",
        "creationInfo": {
            "created": datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
            "creators": ["Tool: cmake/release/sbom.py"],
        },
        "packages": [release, *map(described, sorted(packages)), *([mbedtls()] if made_of_mbedtls else [])],
        "files": entries,
        "relationships": relations,
    }
    return json.dumps(content, indent=1) + "\n"

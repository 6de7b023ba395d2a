"""Is sbom.spdx.json in the folder a bill of materials by SPDX 2.3, and does it tell the truth about the folder?"""

import hashlib
import json
import pathlib
import sys

FOLDER = pathlib.Path(sys.argv[1])
NOT_LISTED = {"./sbom.spdx.json", "./SHA256SUMS"}  # they are made from the list
PARTS = {"libeigen3-dev", "libnewlib-arm-none-eabi", "gcc-arm-none-eabi", "libstdc++6", "libfmt9", "libc6", "mbedtls"}
problems = []


def wants(element, where, *names):
    for name in names:
        if element.get(name) in (None, "", []):
            problems.append(f"{where} has no {name}")


document = json.loads((FOLDER / "sbom.spdx.json").read_text())
wants(document, "the document", "spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo", "packages",
      "files", "relationships")
wants(document.get("creationInfo", {}), "creationInfo", "created", "creators")
if document.get("spdxVersion") != "SPDX-2.3" or document.get("dataLicense") != "CC0-1.0":
    problems.append("the document is not by SPDX 2.3")

packages = document.get("packages", [])
for package in packages:
    wants(package, package.get("name", "a package"), "SPDXID", "name", "versionInfo", "downloadLocation", "filesAnalyzed"
          if package.get("filesAnalyzed") else "externalRefs")
    if package.get("filesAnalyzed"):
        wants(package, package["name"], "packageVerificationCode")
problems += [f"there is no package {name}" for name in sorted(PARTS - {package.get("name") for package in packages})]

listed = set()
for file in document.get("files", []):
    name = file.get("fileName", "a file")
    wants(file, name, "SPDXID", "fileName", "checksums")
    listed.add(name)
    checksums = {entry["algorithm"]: entry["checksumValue"] for entry in file.get("checksums", [])}
    content = (FOLDER / name).read_bytes() if (FOLDER / name).is_file() else None
    if content is None:
        problems.append(f"{name} is not there")
        continue
    for algorithm in ("SHA1", "SHA256"):
        if checksums.get(algorithm) != hashlib.new(algorithm, content).hexdigest():
            problems.append(f"{name}: another {algorithm}")
there = {f"./{path.relative_to(FOLDER).as_posix()}" for path in FOLDER.rglob("*") if path.is_file()} - NOT_LISTED
problems += [f"{name} is not in the bill of materials" for name in sorted(there - listed)]

identifiers = [element.get("SPDXID") for element in [document, *packages, *document.get("files", [])]]
if len(set(identifiers)) != len(identifiers):
    problems.append("two elements have the same SPDXID")
relations = document.get("relationships", [])
for relation in relations:
    wants(relation, "a relationship", "spdxElementId", "relationshipType", "relatedSpdxElement")
    for end in ("spdxElementId", "relatedSpdxElement"):
        if relation.get(end) not in identifiers:
            problems.append(f"a relationship names {relation.get(end)}, which is not there")
connected = {relation.get(end) for relation in relations for end in ("spdxElementId", "relatedSpdxElement")}
problems += [f"nothing relates to {name}" for name in identifiers if name not in connected]

for problem in problems:
    print(problem, file=sys.stderr)
sys.exit(1 if problems else 0)

"""The committed inputs of a target: one archive, and the same inputs always give the same bytes."""

import io
import pathlib
import sys
import zipfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "cmake/environment"))

import file_io  # noqa: E402

_FOLDER = pathlib.Path(__file__).resolve().parent / "corpus"


def path(target):
    return _FOLDER / f"{target}.zip"


def read(target):
    """Inputs by name; none if nothing is committed yet."""
    if not path(target).exists():
        return {}
    with zipfile.ZipFile(path(target)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def write(target, inputs):
    """Names sorted, no times, not compressed: another version of zlib would give other bytes, and Git compresses anyway."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_STORED) as archive:
        for name in sorted(inputs):
            entry = zipfile.ZipInfo(name)
            entry.create_system = 3
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, inputs[name])
    _FOLDER.mkdir(exist_ok=True)
    file_io.write(path(target), content.getvalue())


def unpack(target, folder):
    """The inputs as files, in order of their names."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    files = []
    for name, content in sorted(read(target).items()):
        file = folder / name
        file.write_bytes(content)
        files.append(file)
    return files

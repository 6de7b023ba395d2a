#!/usr/bin/python3
"""The archives of committed inputs."""

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import corpus  # noqa: E402

TARGETS = sorted(path.stem for path in pathlib.Path(__file__).resolve().parent.glob("*.cpp"))


class Archive(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def written(self, inputs):
        corpus.write(self.folder / "target", inputs)
        return (self.folder / "target.zip").read_bytes()

    def test_the_order_of_adding_changes_no_byte(self):
        self.assertEqual(self.written({"a": b"1", "b": b""}), self.written({"b": b"", "a": b"1"}))

    def test_unpacked_inputs_are_those_written(self):
        inputs = {"b": b"\x00\xff", "a_crash": b"", "c": b"text\n"}
        self.written(inputs)
        files = corpus.unpack(self.folder / "target", self.folder / "unpacked")
        self.assertEqual([file.name for file in files], sorted(inputs))
        self.assertEqual({file.name: file.read_bytes() for file in files}, inputs)

    def test_committed_archives_are_as_this_writes_them(self):
        for target in TARGETS:
            with self.subTest(target):
                inputs = corpus.read(target)
                self.assertTrue(inputs)
                self.assertEqual(self.written(inputs), corpus.path(target).read_bytes())


if __name__ == "__main__":
    unittest.main()

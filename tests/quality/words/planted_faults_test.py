"""Sound words raise no complaint; each planted fault raises its own."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import words

FILES = {
    "firmware/a.cpp": "// The level of one sample.\n"
                      "// Which clock does it use? What is a frame worth?\n"
                      "// Levels are kept\n// of both sides.\n"
                      "int counter{0};  // of the newest frame\n"
                      "const char* url{\"http://x\"};  // soft\n"
                      "void f() { refuse(\"the level {} is no number: correct it\"); }\n"
                      "TEST(Level, RisesWithTheForce) {}\nTEST(ALevel, OfNothingIsTold) {}\n",
    "sil/a.py": '"""Reads levels.\n\nUse: a.py\n"""\n# One level a line.\nLEVEL = "#1 what it is"\n',
    "sil/run": "#!/bin/bash\n# Runs the system.\necho ${#list[@]} '# What a list has'\n",
    "sil/a.sql": "-- One row a run.\nSELECT 1;\n",
    "sil/CMakeLists.txt": "# The programs.\nadd_executable(a)\n",
    "sil/a.toml": "# The vehicle.\nname = \"large\"\n",
    "sil/a.js": "/* Draws the page. */\nconst a = `what`;\n",
    "docs/page.md": "# Page\n## What a run shows\nA run shows two lines.\n`A` of them.\n\n- An item.\n\n| a | b |\n|---|---|\n| Why? | What to do |\n"
                    "\n```\n# What the shell sees\n```\n",
    "CHANGELOG.md": "# Changes\n## [2]\n### Added\n- Added a level,\n  with a unit.\n## [1]\nWhat was. Nobody knows.\n- Levels.\n",
}


class PlantedFaults(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.project = pathlib.Path(temporary.name)
        for name, text in FILES.items():
            file = self.project / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def expect(self, name, before, after, place, *parts):
        file = self.project / name
        text = file.read_text()
        self.assertIn(before, text)
        file.write_text(text.replace(before, after, 1))
        found = [str(fault) for fault in words.check(self.project)]
        file.write_text(text)
        self.assertEqual(len(found), 1, found)
        for part in (f"{name}:{place}: ", "; write ", *parts):
            self.assertIn(part, found[0])

    def run_check(self, *options):
        return subprocess.run([HERE / "check", "--project", self.project, *options], capture_output=True, text=True,
                              check=False)

    def test_sound_words_raise_none(self):
        self.assertEqual([str(fault) for fault in words.check(self.project)], [])

    def test_a_clause_as_a_noun_in_a_comment_of_every_language(self):
        for name, before, after, place in (
                ("firmware/a.cpp", "// The level of", "// What", 1), ("firmware/a.cpp", "worth?", "worth? What one costs.", 2),
                ("firmware/a.cpp", "// of the newest frame", "// what the newest frame says", 5),
                ("sil/a.py", "Reads levels", "What reads levels", 1), ("sil/a.py", "# One level", "# What stands", 5),
                ("sil/run", "# Runs", "# What runs", 2), ("sil/a.sql", "-- One", "-- What one", 1),
                ("sil/CMakeLists.txt", "# The", "# What the", 1), ("sil/a.toml", "# The", "# What the", 1),
                ("sil/a.js", "Draws", "What draws", 1)):
            with self.subTest(after):
                self.expect(name, before, after, place, "begins with 'what'" if "// what" in after else "begins with 'What'")

    def test_every_word_that_begins_such_a_clause(self):
        for word in words.CLAUSES:
            with self.subTest(word):
                self.expect("firmware/a.cpp", "The level", word.capitalize(), 1, word.capitalize(), words.CLAUSES[word])

    def test_a_clause_as_a_noun_in_a_message(self):
        self.expect("firmware/a.cpp", "the level {} is", "What is {} here is", 7, "begins with 'What'")

    def test_a_clause_as_a_noun_on_a_page(self):
        for before, after, place in (("A run shows two", "What a run shows are two", 3), ("- An item", "- Whose item", 6),
                                     ("| What to do |", "| Where not |", 10), ("two lines.", "two lines.\nSo it ends.", 4)):
            with self.subTest(after):
                self.expect("docs/page.md", before, after, place, "begins with '")

    def test_a_clause_as_the_name_of_a_test(self):
        self.expect("firmware/a.cpp", "RisesWithTheForce", "WhatRises", 8, "test begins with 'what'")
        self.expect("sil/a.py", "LEVEL =", "def test_of_all(): 0  #", 6, "test begins with 'of'")

    def test_a_person_for_a_signal(self):
        for name, before, after, place in (
                ("firmware/a.cpp", "one sample", "one witness", 1), ("firmware/a.cpp", "it is no number", "nobody", 7),
                ("firmware/a.cpp", "one sample", "a sensor that is accused", 1), ("sil/a.py", "levels", "levels, whoever asks", 1),
                ("docs/page.md", "two lines", "a sensor that is\ntold to stop", 3), ("docs/page.md", "| What to do |", "| Nobody |", 10)):
            with self.subTest(after):
                if before in FILES[name]:
                    self.expect(name, before, after, place)
        self.expect("firmware/a.cpp", "the level {} is no", "the level {} is known to nobody, no", 7, "'nobody'", "'no client'")

    def test_a_banned_name(self):
        for after, better in (("witness", "reference"), ("take_out", "invalidate"), ("AccusedSensor", "set"), ("told_", "reported")):
            with self.subTest(after):
                self.expect("firmware/a.cpp", "int counter", f"int {after}", 5, f'"{after}"', better)
        self.expect("firmware/a.cpp", "RisesWithTheForce", "TakesOutASensor", 8, "TakesOutASensor", "invalidate")

    def test_a_banned_name_of_a_file(self):
        (self.project / "sil/account.cpp").write_text("")
        self.assertEqual([fault.instead for fault in words.check(self.project)], ["console_summary"])

    def test_an_entry_without_a_verb(self):
        self.expect("CHANGELOG.md", "Added a level", "A level", 4, "entry", "a verb first")

    def test_an_entry_of_three_lines(self):
        self.expect("CHANGELOG.md", "with a unit.", "with a unit\n  and a range.", 4, "entry", "at most 2 lines")

    def test_the_command_tells_and_fails(self):
        self.assertEqual(self.run_check().returncode, 0)
        (self.project / "firmware/a.cpp").write_text("// What a level is.\n// It has a unit.\n")
        done = self.run_check()
        self.assertEqual(done.returncode, 1)
        self.assertIn("words: firmware/a.cpp:1: begins with 'What': \"What a level is.\"; write name the thing", done.stderr)
        self.assertEqual(self.run_check(self.project / "firmware").returncode, 1)
        self.assertEqual(self.run_check(self.project / "sil").returncode, 0)


if __name__ == "__main__":
    unittest.main()

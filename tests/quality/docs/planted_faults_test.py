"""A sound page raises no complaint; each planted fault raises its own."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import documentation
import sources

PAGE = """# Page
The level is 0.92<!--=level--> after 20<!--=hold--> ms, over three<!--=cars--> vehicles and
two<!--=rows--> frames; 99.72<!--=share--> % of them, 1,234<!--=cell--> in all. Equation (23), Fig. 7, Cortex-M7, 0x120, 2009, from 0 to 1.
See [below](#the-end), [firmware](../firmware/level.hpp) and `firmware/level.hpp`; `tests/run unit`, `level.hpp`.

<!-- figures: advice -->
Drive at 60 km/h.

```
tests/run unit            # 3 of 4
tests/run --quick
build/release/sil/rsi-sil replay firmware/*.hpp --output DIR
cmake --build --preset release --target known_target
```
## The end
A cycle of 10 ms.

<!-- sources
level: cars/a.toml warning.on
hold: firmware/level.hpp hold_s * 1000
cars: cars/*.toml count
rows: firmware/level.hpp count /^row/
share: docs/reports/r.md /in all \\| ([\\d.]+)/
cell: docs/reports/r.md row all files column 3
-->
"""

FILES = {
    "README.md": "# Project\nSee [page](docs/page.md#the-end).\n",
    "CHANGELOG.md": "# Changes\n## [2]\n[page](docs/page.md) `firmware/level.hpp` (was in `sil/old.hpp`) "
                    "`tests/run --quick`\n## [1]\n`firmware/old.hpp`\n",
    "docs/page.md": PAGE,
    "docs/reports/r.md": "# Report\n| in all | 99.718 |\n| **all files** | 7 | 1,234 (at most) |\n",
    "firmware/level.hpp": "hold_s = 0.02F;\nrow 1\nrow 2\n",
    "firmware/rsi/rsi_outputs.h": " *   INDEX(name, unit)\n    INDEX(energy, \"-\")\n",
    "docs/theory.md": "# Theory\n```\nenergy: E\n```\n",
    "tests/rsi/indices_test.cpp": "EXPECT_EQ(outputs.energy, 1.0F);\n",
    "firmware/rsi/rsi.h": "#define RSI_SAMPLE_TIME_S 0.01F\n",
    "cars/a.toml": "[warning]\non = 0.92\n",
    "cars/b.toml": "",
    "docs/architecture.md": "# Architecture\n## Folders\n```\n"
                            "cars/            one file a car\n"
                            "docs/            pages; reports/ is written\n"
                            "firmware/        what is delivered\n"
                            "  rsi/           the component\n"
                            "sil/\n"
                            "  run            the first command\n"
                            "  apps/ vehicles/\n"
                            "                 programs, and a file a vehicle\n"
                            "tests/           unit/\n```\n",
    "docs/drives.md": "# Vehicle\n`name`.\n## `[mass]`\n| key | meaning |\n|---|---|\n"
                            "| `sprung_kg` `m_s` | `h` |\n",
    "sil/vehicles/large_suv.toml": 'name = "car"\n[mass]\nsprung_kg = 1.0\n',
    "sil/run": "# docs/page.md says more\n",
    "cars/c.toml": "",
    "sil/apps/a.cpp": 'add_subcommand("replay"); "--output"',
    "CMakePresets.json": '{"configurePresets": [{"name": "release"}]}',
    "tests/unit/CMakeLists.txt": "add_custom_target(known_target)",
    "tests/run": "#!/bin/sh\n# --quick\necho '  unit   what it is'\n",
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
        (self.project / "tests/run").chmod(0o755)

    def check(self):
        # The everyday figures are those of the real project.
        return [problem for problem in documentation.check(self.project)[0] if "everyday.txt" not in problem]

    def plant(self, before, after, name="docs/page.md"):
        file = self.project / name
        text = file.read_text()
        self.assertIn(before, text)
        file.write_text(text.replace(before, after, 1))

    def expect(self, *parts):
        found = self.check()
        self.assertEqual(len(found), 1, found)
        for part in parts:
            self.assertIn(part, found[0])

    def test_a_sound_page_raises_none(self):
        self.assertEqual(self.check(), [])

    def test_the_command_tells_and_fails(self):
        self.plant("0.92<", "0.93<")
        done = subprocess.run([HERE / "check", "--project", self.project], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("docs: docs/page.md:2: stale figure: 0.93", done.stderr)

    def test_a_stale_figure(self):
        for before, after in (("0.92<", "0.93<"), ("20<", "21<"), ("three<", "four<"), ("99.72<", "99.73<"), ("1,234<", "1,235<")):
            with self.subTest(before):
                self.plant(before, after)
                self.expect("docs/page.md:", "stale figure", after.strip("<"))
                self.plant(after, before)

    def test_a_figure_whose_source_has_changed(self):
        for name, before, after in (("cars/a.toml", "0.92", "0.9"), ("firmware/level.hpp", "0.02F", "0.03F"),
                                    ("firmware/level.hpp", "row 2", "line 2"), ("docs/reports/r.md", "99.718", "99.71")):
            with self.subTest(name):
                self.plant(before, after, name)
                self.expect("stale figure", name)
                self.plant(after, before, name)
        (self.project / "cars/c.toml").unlink()
        self.expect("stale figure: three", "two")

    def test_a_figure_without_a_source(self):
        for text in ("It takes 7 steps.", "It takes 0.3 s.", "It has -4.5 deg.", "Some 27,000 of them.", "It has 3 dB.",
                     "All 100 % of it.", "At 2x the rate.", "Over four scenes.", "Ten recorded fields.",
                     "Within half of that.", "It has halved.", "Three quarters of it.", "A tenth of it.",
                     "One third of it.", "Present for a second.", "It lasts about one minute.", "A second after it.",
                     "Two\nseconds.", "Three samples.",
                     "It is twice as long.", "A hundred of them."):
            with self.subTest(text):
                self.plant("## The end\n", f"## The end\n{text}\n")
                self.expect("unguarded figure")
                self.plant(f"## The end\n{text}\n", "## The end\n")

    def test_words_that_are_no_quantity(self):
        self.plant("## The end\n", "## The end\nA second reader, the third one; a cycle of waiting. Do not call twice: "
                   "one takes two.\n")
        self.assertEqual(self.check(), [])

    def test_a_quantity_in_words_with_a_source(self):
        self.plant("## The end\n", "## The end\nIt is half<!--=part--> of it.\n")
        self.plant("hold: ", "part: firmware/part.hpp part\nhold: ")
        (self.project / "firmware/part.hpp").write_text("part = 0.5F;\n")
        self.assertEqual(self.check(), [])
        (self.project / "firmware/part.hpp").write_text("part = 0.6F;\n")
        self.expect("stale figure: half", "0.60")

    def test_a_definition_frees_words_and_no_number(self):
        self.plant("## The end\n", "## The end\n<!-- figures: definition -->\nHalf the width.\n\n")
        self.assertEqual(self.check(), [])
        self.plant("Half the width.", "Half the width, 7 m.")
        self.expect("unguarded figure: 7")

    def test_figures_of_others_without_a_name_or_for_a_whole_section(self):
        for kind in ("standard", "hardware"):
            for after in ("", ", whole section", ", whole section, ISO 1"):
                with self.subTest(kind + after):
                    self.plant("figures: advice", f"figures: {kind}{after}")
                    self.expect(f"figures: {kind} holds for one paragraph")
                    self.plant(f"figures: {kind}{after}", "figures: advice")
        self.plant("figures: advice", "figures: standard, ISO 1")
        self.assertEqual(self.check(), [])

    def test_a_version_of_the_project_in_code(self):
        self.plant("tests/run --quick\n", "tests/run --quick\nfind_package(rsi 0.2 REQUIRED)\n")
        self.expect("docs/page.md:12", "a version of this project")

    def test_a_line_that_is_a_list_item_by_accident(self):
        for text in ("These are `A\n- a_y` moves.", "The sum of A\n+ B moves.", "The product of A\n* B moves.",
                     "1. These `A\n- B`.",
                     "- The sum of A\n  + B."):
            with self.subTest(text):
                self.plant("## The end\n", f"## The end\n{text}\n\n")
                self.expect("docs/page.md:17", "begins like an item of a list")
                self.plant(f"## The end\n{text}\n\n", "## The end\n")
        self.plant("## The end\n", "## The end\n- One:\n  - an item.\n- Another\n  one.\n\n1. First.\n2. Second.\n\n")
        self.assertEqual(self.check(), [])

    def test_the_newest_changes(self):
        for before, after, complaint in (("[page](docs/page.md)", "[page](docs/gone.md)", "dead link"),
                                         ("`firmware/level.hpp`", "`firmware/gone.hpp`", "no such path"),
                                         ("tests/run --quick", "tests/run --slow", "no option --slow")):
            with self.subTest(complaint):
                self.plant(before, after, "CHANGELOG.md")
                self.expect("CHANGELOG.md:3", complaint)
                self.plant(after, before, "CHANGELOG.md")

    def test_advice_ends_with_its_paragraph(self):
        self.plant("60 km/h.\n\n", "60 km/h.\n\nFor 8 s.\n\n")
        self.expect("unguarded figure: 8")

    def test_a_kind_of_free_figure_that_does_not_exist(self):
        self.plant("figures: advice", "figures: guess")
        found = self.check()
        self.assertTrue(any("guess is none of" in line for line in found), found)

    def test_a_mark_without_a_source_or_without_a_figure(self):
        self.plant("level: cars/a.toml warning.on\n", "")
        self.expect("no source level")
        self.plant("hold: ", "level: cars/a.toml warning.on\nhold: ")
        self.plant("10 ms.", "10 ms<!--=level-->.")
        self.expect("does not stand behind a figure")

    def test_a_source_that_gives_nothing(self):
        for before, after in (("warning.on", "warning.off"), ("a.toml warning", "z.toml warning"), ("count /^row", "count /^raw"),
                              ("cars/*.toml", "cars/*.json"), ("hold_s", "held_s"), ("/in all", "/in none"), ("column 3", "column 4"), ("row all", "row any")):
            with self.subTest(after):
                self.plant(before, after)
                self.assertEqual(len(self.check()), 1)
                self.plant(after, before)

    def test_a_source_that_guards_nothing(self):
        self.plant("hold: ", "other: cars/*.toml count\nhold: ")
        self.expect("other guards nothing")

    def test_a_dead_link_and_a_dead_anchor(self):
        self.plant("../firmware/level.hpp)", "../firmware/gone.hpp)")
        self.expect("dead link", "gone.hpp")
        self.plant("gone.hpp)", "level.hpp)")
        self.plant("(#the-end)", "(#the-beginning)")
        self.expect("dead anchor", "the-beginning")
        self.plant("(#the-beginning)", "(#the-end)")
        self.plant("docs/page.md#the-end", "docs/page.md#end", "README.md")
        self.expect("README.md:2", "dead anchor")

    def test_a_dead_link_in_a_report(self):
        self.plant("# Report\n", "# Report\n[gone](../gone.md)\n", "docs/reports/r.md")
        self.expect("docs/reports/r.md:2", "dead link")

    def test_a_path_of_a_report_that_does_not_exist(self):
        for text in ("| `firmware/gone.cpp` | 7 |", "| firmware/gone.cpp | 7 |"):
            with self.subTest(text):
                self.plant("# Report\n", f"# Report\n{text}\n", "docs/reports/r.md")
                self.expect("docs/reports/r.md:2", "no such path: firmware/gone.cpp")
                self.plant(f"# Report\n{text}\n", "# Report\n", "docs/reports/r.md")

    def test_a_path_that_does_not_exist(self):
        for before, after in (("`firmware/level.hpp`", "`firmware/gone.hpp`"), ("`level.hpp`", "`gone.hpp`"),
                              ("firmware/*.hpp", "firmware/*.hxx")):
            with self.subTest(after):
                self.plant(before, after)
                self.expect("no such path" if "/" in after else "no file is called")
                self.plant(after, before)

    def test_a_command_that_does_not_exist(self):
        for before, after, complaint in (
            ("tests/run unit   ", "tests/run units   ", "no group units"), ("tests/run unit   ", "tests/walk unit   ", "no such path"),
            ("--quick", "--slow", "no option --slow"), ("rsi-sil replay", "rsi-sil repeat", "no command repeat"),
            ("--output DIR", "--outputs DIR", "no option --outputs"), ("known_target", "unknown_target", "target unknown_target"),
            ("--preset release", "--preset debug", "no preset debug"),
        ):
            with self.subTest(after):
                self.plant(before, after)
                self.expect(complaint)
                self.plant(after, before)

    def test_a_key_that_its_page_does_not_name(self):
        self.plant("sprung_kg = 1.0", "sprung_kg = 1.0\nunsprung_kg = 1.0", "sil/vehicles/large_suv.toml")
        self.expect("docs/drives.md", "unsprung_kg")

    def test_a_key_that_its_file_does_not_have(self):
        for before, after, key in (("`[mass]`", "`[mass]` and `[weight]`", "weight"),
                                   ("| `sprung_kg` ", "| `sprung_kg`, `unsprung_kg` ", "unsprung_kg")):
            with self.subTest(key):
                self.plant(before, after, "docs/drives.md")
                self.expect("docs/drives.md", f"has no {key}")
                self.plant(after, before, "docs/drives.md")

    def test_an_index_without_an_equation(self):
        self.plant('INDEX(energy, "-")', 'INDEX(energy, "-")\n    INDEX(force, "-")', "firmware/rsi/rsi_outputs.h")
        self.plant("outputs.energy", "outputs.energy + outputs.force", "tests/rsi/indices_test.cpp")
        self.expect("docs/theory.md", "no equation of `force`", "firmware/rsi/rsi_outputs.h")

    def test_an_index_without_a_test(self):
        self.plant('INDEX(energy, "-")', 'INDEX(energy, "-")\n    INDEX(force, "-")', "firmware/rsi/rsi_outputs.h")
        self.plant("energy: E", "energy: E\nforce: F", "docs/theory.md")
        self.expect("tests/rsi", "no test of `force`", "firmware/rsi/rsi_outputs.h")

    def test_a_folder_that_the_list_lacks(self):
        (self.project / "firmware/images").mkdir()
        (self.project / "firmware/images/main.cpp").write_text("")
        self.expect("docs/architecture.md", "lacks firmware/images/")
        self.plant("  rsi/           the component", "  rsi/ images/   the component, an image", "docs/architecture.md")
        self.assertEqual(self.check(), [])

    def test_a_folder_of_the_list_that_is_not_there(self):
        for before, after, path in (("  rsi/  ", "  rsi/ hal/  ", "firmware/hal/"), ("unit/", "unit/, system/", "tests/system/"),
                                    ("  run  ", "  walk  ", "sil/walk"), ("reports/ is", "report/ is", "docs/report/")):
            with self.subTest(path):
                self.plant(before, after, "docs/architecture.md")
                self.expect("docs/architecture.md:", f"there is no {path}")
                self.plant(after, before, "docs/architecture.md")

    def test_a_source_that_names_a_page_which_does_not_exist(self):
        self.plant("docs/page.md", "docs/pages.md", "sil/run")
        self.expect("sil/run:1", "docs/pages.md")

    def test_a_line_that_is_too_long(self):
        self.plant("# Project\n", "# Project\n" + "word " * 25 + "\n", "README.md")
        self.expect("README.md:2", "columns")

    def test_a_readme_that_is_too_long(self):
        self.plant("# Project\n", "# Project\n" + "\n" * 120, "README.md")
        self.expect("README.md", "lines")

    def test_a_page_that_is_too_long(self):
        self.plant("# Page\n", "# Page\n" + "word word\n" * 2001)
        self.expect("docs/page.md", "words")

    def test_refresh_writes_the_figures_anew_and_follows_a_moved_file(self):
        self.plant("0.92", "0.85", "cars/a.toml")
        self.plant("99.718", "1234.5", "docs/reports/r.md")
        (self.project / "cars/c.toml").unlink()
        (self.project / "firmware/rsi/level.hpp").write_text(FILES["firmware/level.hpp"].replace("0.02F", "0.04F"))
        (self.project / "firmware/level.hpp").unlink()
        documentation.refresh(self.project)
        found = self.check()
        text = (self.project / "docs/page.md").read_text()
        for part in ("0.85<!--=level-->", "40<!--=hold-->", "two<!--=cars-->", "1234.50<!--=share-->", "hold: firmware/rsi/level.hpp"):
            self.assertIn(part, text)
        self.assertFalse([line for line in found if "stale" in line], found)
        self.assertTrue(all("firmware/level.hpp" in line or "firmware/*.hpp" in line for line in found), found)


class Figures(unittest.TestCase):
    def test_values_are_shown_as_the_page_shows_them(self):
        for value, like, text in ((3.0, "two", "three"), (3.0, "Two", "Three"), (0.4567, "0.1", "0.5"), (12345.0, "1", "12,345"),
                                  (1234.0, "9,999", "1,234"), (25.0, "two", "25"), (0.5, "+0.10", "+0.50")):
            self.assertEqual(sources.shown(value, like), text)

    def test_a_rounded_figure_agrees(self):
        self.assertTrue(sources.agree("0.45", 0.454))
        self.assertFalse(sources.agree("0.45", 0.456))
        self.assertTrue(sources.agree("19", 19.0))
        self.assertFalse(sources.agree("nineteen", 18.0))


if __name__ == "__main__":
    unittest.main()

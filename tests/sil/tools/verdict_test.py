"""The verdict on a folder of logs: one answer, kept; drives, calibration, warnings and their sides; reasons where there is none."""

import csv
import io
import re
import types
import unittest.mock

import numpy

import drive_support
import support

import bus_log_writers
import drive_facts
import drive_pictures
import foreign_recorder
import mapping_answers
import verdict_text

DATA = support.PROJECT / "sil/vehicles/data/large_suv.toml"
MANOEUVRES = {"a-step.blf": "step-steer", "slalom.asc": "slalom", "slow.candump": "slow-ramp"}


class Folder(drive_support.WithDrives):
    """Logs of a foreign recorder in a folder."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.frames = {"turn.mf4": list(foreign_recorder.frames(cls.run_folder))}
        for name, manoeuvre in MANOEUVRES.items():
            folder = cls.run_folder.parent / manoeuvre
            support.call(cls.program, "run", manoeuvre, "--in-process", "--vehicle", support.PROJECT / "sil/vehicles/large_suv.toml",
                         "--parameters", support.CALIBRATION, "--output", folder)
            cls.frames[name] = list(foreign_recorder.frames(folder))

    def setUp(self):
        super().setUp()
        self.drives = self.folder / "logs"
        self.drives.mkdir()
        self.output = self.folder / "output"

    def record(self, *names):
        for name in names:
            self.written(name.rpartition(".")[2], self.frames[name]).rename(self.drives / name)

    def arguments(self, *options):
        return ["verdict", self.drives, "--dbc", foreign_recorder.DBC, "--program", self.program, "--output", self.output, *options]

    def verdict(self, *options):
        return self.logs(*self.arguments(*options))

    def test_from_logs_to_a_verdict_with_one_answer(self):
        self.record(*self.frames)
        (self.drives / "broken.blf").write_bytes(b"LOGG" + bytes(200))
        (self.drives / "notes.txt").write_text("dry road", encoding="utf-8")
        asked = self.unanswered(*self.arguments())
        mapping = self.output / "mapping.toml"
        turn = re.search(r"was the turn at (\S+) s of (\S+) to the left or to the right\? Run it again with --answer left or ", asked)
        self.assertIn('sign = "?"', mapping.read_text(encoding="utf-8"))
        manoeuvre = MANOEUVRES[turn[2]]
        row = next(row for row in foreign_recorder.rows(self.run_folder.parent / manoeuvre) if row["time_s"] >= float(turn[1]))
        # The unit of the roll angle is no question of sides: its place is named.
        side = "left" if row["yaw_rate_degps"] > 0.0 else "right"
        said = self.unanswered(*self.arguments("--answer", side))
        text = mapping.read_text(encoding="utf-8")
        line = 1 + text.splitlines().index(next(line for line in text.splitlines() if line.startswith('unit = "?"')))
        self.assertIn(f"  {mapping}:{line}: unit = \"?\"", said)
        mapping.write_text(text.replace('unit = "?"', 'unit = "rad"\nfactor = 0.0001\nlag_ms = 30\n#'), encoding="utf-8")
        said = self.verdict("--vehicle-data", DATA)
        self.assertNotIn("?", "".join(line for line in mapping.read_text(encoding="utf-8").splitlines() if line[:1] not in "#"))
        written = (self.output / "verdict.md").read_text(encoding="utf-8")
        self.assertIn(written, said)
        # The right side, the calibration of the drives, and what it is checked with.
        self.assertRegex(written, r"## turn\.mf4\n\n(- .*\n)*- 1 turn, 1 to the left and 0 to the right: left 1\.\d to 3\.0 s\n")
        self.assertRegex(written, r"- warned of rolling over to the right at 1\.\d\d s; verdict: warning\n"
                                  r"- \[report\]\(replays/turn/report\.html#1\.\d+\)")
        self.assertRegex(written, r"## slow\.candump\n\n(- .*\n)*- 2 turns, 1 to the left and 1 to the right: left .*, right .*\n")
        self.assertRegex(written, r"- slalom: within, ")
        self.assertIn("of a warning near lift-off it is not known without wheel loads", written)
        self.assertIn("## Doubts of identify about the calibration\n\n- without wheel loads ", written)
        self.assertNotIn("identify doubts: ", written)
        for name in ("ramp-slow", "dynamic-a-step"):
            self.assertIn(f"replays/{name}/report.html", written)
        self.assertRegex(written, r"- broken\.blf: .*broken\.blf: .*\n- notes\.txt: |- notes\.txt: .*\n- broken\.blf: ")
        self.assertIn(f"Calibration: {self.output}/validation/identification/calibration.toml", written)
        # The commands that it shows do the same.
        steps = re.findall(r"(?m)^\$ sil/tools/logs (drive .*turn\.mf4.*)", said)
        made = (self.output / "drives/turn.csv").read_bytes()
        self.logs(*steps[0].split()[:-1], self.folder / "again.csv")
        self.assertEqual((self.folder / "again.csv").read_bytes(), made)
        page = (self.output / "verdict.html").read_text(encoding="utf-8")
        links = re.findall(r'href="([^"#]+)', page)
        self.assertEqual(len(links), len(self.frames))
        for link in links:
            self.assertTrue((self.output / link).is_file(), link)
        self.assertEqual(page.count("<svg"), 2 * len(self.frames))
        self.assertIn("squares: warnings", page)
        support.call("/usr/bin/python3", "-B", support.PROJECT / "tests/sil/page/screens.py", self.output / "verdict.html")

    def test_oddities_are_said_once(self):
        """The DBC file's lines, and what of a log was left out, by a draft and by a verdict on two logs."""
        odd = self.folder / "odd.dbc"
        odd.write_bytes(foreign_recorder.DBC.read_bytes() + b'CM_ SG_ 1027 Gone "nothing";\n')
        self.record("turn.mf4", "slalom.asc")
        damaged = self.folder / "damaged.candump"
        bus_log_writers.write_candump(damaged, iter(self.frames["turn.mf4"]))
        damaged.write_bytes(damaged.read_bytes() + b"(99.000000) can0 XYZ#00\n")
        said = self.logs("draft", "--dbc", odd, "--log", damaged, "--output", self.folder / "drafted.toml")
        self.assertEqual((said.count("1 odd line;"), said.count("damaged.candump: left out: 1 damaged part")), (1, 1), said)
        damaged.rename(self.drives / damaged.name)
        (self.drives / "mapping.toml").write_text(foreign_recorder.MAPPING, encoding="utf-8")
        arguments = self.arguments("--parameters", "large_suv")
        arguments[arguments.index(foreign_recorder.DBC)] = odd
        odd.write_bytes(odd.read_bytes() + b'CM_ SG_ 1027 Too "nothing";\n')
        said = self.logs(*arguments)
        written = (self.output / "verdict.md").read_text(encoding="utf-8")
        self.assertEqual(written.count("2 odd lines;"), 1)
        self.assertEqual(said.replace(written, "").count("2 odd lines;"), 1)
        self.assertEqual(written.count("1 damaged part"), 1)

    def test_a_mapping_beside_the_logs_is_taken(self):
        self.record("turn.mf4")
        (self.drives / "mapping.toml").write_text(foreign_recorder.MAPPING, encoding="utf-8")
        said = self.verdict("--parameters", "large_suv")
        self.assertFalse((self.output / "mapping.toml").exists())
        expected = next(row for row in csv.reader(self.replay(self.original).splitlines()) if row[1] == "warning")
        self.assertIn(f"warned of rolling over to the {expected[2]} at {float(expected[0]):.2f} s", said)
        self.assertNotIn("not your vehicle's", said)
        self.assertIn("not your vehicle's", self.verdict())
        self.refused(f"{self.drives}: no calibration without a slow ramp and a dynamic drive", *self.arguments("--vehicle-data", DATA))
        self.assertIn("not finished", (self.output / "verdict.md").read_text(encoding="utf-8"))

    def test_two_drives_calibrate_and_none_is_left_to_check_with(self):
        self.record("slow.candump", "a-step.blf")
        for old, new in (("slow.candump", "ramp.candump"), ("a-step.blf", "dynamic 1.blf")):
            (self.drives / old).rename(self.drives / new)
        (self.drives / "mapping.toml").write_text(foreign_recorder.MAPPING, encoding="utf-8")
        said = self.verdict("--vehicle-data", DATA)
        self.assertIn("no further drive is left to check the calibration with", said)
        self.assertIn(f"Calibration: {self.output}/identification/calibration.toml", said)
        self.assertIn("(replays/dynamic%201/report.html)", said)
        self.assertNotIn("$ mv", said)

    def test_the_reason_is_said_where_there_is_no_verdict(self):
        self.refused(f"{self.drives}: has no log that can be read with a DBC file", *self.arguments())
        self.record("turn.mf4")
        self.refused("--parameters lorry: there is no such file, nor a calibration of that name; there are ",
                     *self.arguments("--parameters", "lorry"))
        self.refused(f"{self.drives / 'data.toml'}: cannot be read: ", *self.arguments("--vehicle-data", self.drives / "data.toml"))
        file = self.folder / "file"
        file.touch()
        self.refused(f"{file / 'below'}: cannot be written: ", *self.arguments("--output", file / "below"))
        (self.output / "replays").mkdir(parents=True)
        self.refused(f"{self.output / 'replays'}: exists, and is not of an earlier verdict; ", *self.arguments())
        self.refused(f"{self.folder / 'none'}: is no folder", "verdict", self.folder / "none")
        self.assertEqual(support.subprocess.run([support.PROJECT / "sil/run", "--logs"], capture_output=True, check=False).returncode, 2)


class Answers(support.WithFolder):
    def table(self, name, roll):
        """Two seconds straight, then a turn; the roll angle follows it with this sign."""
        lines = ["time [s],lateral acceleration [m/s^2],roll rate [deg/s],roll angle [deg],yaw rate [deg/s],speed [km/h]"]
        for number in range(600):
            turn = max(0.0, numpy.sin((number - 200) / 60.0))
            rate = 0.0 if not turn else roll * 5.0 * numpy.cos((number - 200) / 60.0)
            lines.append(f"{number / 100},{-4.0 * turn},{rate},{3.0 * roll * turn},{12.0 * turn},72")
        file = self.folder / f"{name}.csv"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return file

    def test_the_log_that_agrees_with_the_others_is_asked_about(self):
        logs = [self.table("banked", -1.0), self.table("first", 1.0), self.table("second", 1.0)]
        signals = self.folder / "mapping.toml"
        with unittest.mock.patch("sys.stdout", io.StringIO()):
            mapping_answers.write_draft(None, logs, signals)
            self.assertIn(f"{mapping_answers.ASKED_OF}first.csv\n", signals.read_text(encoding="utf-8"))
            drafted = signals.read_text(encoding="utf-8")
            found = {}
            for side in ("left", "right"):
                signals.write_text(drafted, encoding="utf-8")
                mapping_answers.answer(signals, side)
                found[side] = {entry.quantity: entry.sign for entry in mapping_answers.mapping.Mapping(signals).entries}
            self.assertRaisesRegex(mapping_answers.LogError, "has the answer right already", mapping_answers.answer, signals, "left")
        self.assertEqual(found["left"], {"lateral_acceleration": -1, "roll_rate": 1, "roll_angle": 1, "yaw_rate": 1, "speed": 1})
        self.assertEqual(found["right"], {"lateral_acceleration": 1, "roll_rate": -1, "roll_angle": -1, "yaw_rate": -1, "speed": 1})

    def test_no_more_logs_are_drafted_than_are_needed(self):
        logs = [self.table(f"log {number}", 1.0) for number in range(5)]
        straight = self.folder / "straight.csv"
        straight.write_text("\n".join(logs[0].read_text(encoding="utf-8").splitlines()[:150]) + "\n", encoding="utf-8")
        with unittest.mock.patch("sys.stdout", io.StringIO()) as shown:
            mapping_answers.write_draft(None, [straight, *logs], self.folder / "mapping.toml")
        self.assertEqual(re.findall(r"looking at .*/(.*)\.csv", shown.getvalue()), ["straight", "log 0", "log 1", "log 2"])

    def test_a_person_is_asked_until_the_answer_is_one(self):
        for typed, expected in (("perhaps\nY\n", "left"), ("no\n", "right"), ("", None)):
            terminal = io.StringIO(typed)
            terminal.isatty = lambda: True
            with unittest.mock.patch("sys.stdin", terminal), unittest.mock.patch("sys.stdout", io.StringIO()) as shown:
                if expected:
                    self.assertEqual(mapping_answers.asked("left? ", "open"), expected)
                else:
                    self.assertRaisesRegex(mapping_answers.Unanswered, "open", mapping_answers.asked, "left? ", "open")
            self.assertEqual(shown.getvalue(), "left? " * max(typed.count("\n"), 1))

    def test_an_optional_question_leaves_its_table_out(self):
        signals = self.folder / "mapping.toml"
        signals.write_text('[roll_rate]\nsignal = "A.B"\n\n[bank_angle]\nsignal = "A.C"\nsign = "?"  # why\n\n[yaw_rate]\n'
                           'signal = "A.D"\n', encoding="utf-8")
        with unittest.mock.patch("sys.stdout", io.StringIO()) as shown:
            mapping_answers.answer(signals, None)
        self.assertIn("left out: bank_angle; ", shown.getvalue())
        self.assertEqual([entry.quantity for entry in mapping_answers.mapping.Mapping(signals).entries], ["roll_rate", "yaw_rate"])


class Facts(support.WithFolder):
    @staticmethod
    def drive(lateral, **others):
        columns = {"lateral_acceleration": numpy.array(lateral, dtype=float), **others}
        return types.SimpleNamespace(columns=columns, times_us=10_000 * numpy.arange(len(lateral)))

    def test_turns_have_the_side_of_the_yaw_rate(self):
        lateral = numpy.concatenate([numpy.zeros(200), numpy.full(300, 4.0), numpy.zeros(100), numpy.full(200, -5.0), numpy.zeros(100)])
        found = drive_facts.turns(self.drive(lateral))
        self.assertEqual([turn.side for turn in found], ["left", "right"])
        self.assertAlmostEqual(found[1].start_s, 6.0, delta=0.2)
        self.assertAlmostEqual(found[1].end_s, 8.0, delta=0.2)
        self.assertEqual([turn.side for turn in drive_facts.turns(self.drive(lateral, yaw_rate=-lateral))], ["right", "left"])
        self.assertEqual(drive_facts.turns(self.drive(0.4 * lateral[:550])), [])
        self.assertTrue(drive_facts.is_to_both_sides(self.drive(lateral)))
        self.assertFalse(drive_facts.is_to_both_sides(self.drive(lateral[:550])))
        self.assertIn("largest lateral acceleration 5.00 m/s^2 at 6.00 s", drive_facts.facts(self.drive(lateral))[0])

    def test_slow_and_quick_drives_are_told_apart(self):
        ramp = numpy.concatenate([numpy.zeros(100), numpy.linspace(0.0, 6.0, 600), numpy.linspace(6.0, 0.0, 60)])
        step = numpy.concatenate([numpy.zeros(100), numpy.linspace(0.0, 3.5, 30), numpy.full(200, 3.5)])
        for lateral, expected in ((ramp, "ramp"), (-ramp, "ramp"), (step, "dynamic"), (0.5 * ramp, ""), (0.3 * step, "")):
            self.assertEqual(drive_facts.purpose(self.drive(lateral)), expected)

    def test_names_are_text_in_the_page(self):
        page = verdict_text.page("# Verdict\n\n## <img src=x>[report](javascript:1)\n\n- [report](replays/a%20b/report.html#1.5)\n", {})
        self.assertIn("<h2>&lt;img src=x&gt;[report](javascript:1)</h2>", page)
        self.assertIn('<ul>\n<li><a href="replays/a%20b/report.html#1.5">report</a></li>\n</ul>', page)

    def test_the_path_is_that_of_speed_and_yaw_rate(self):
        lateral = numpy.full(3601, 1.75)
        for side in (1.0, -1.0):
            drive = self.drive(lateral, yaw_rate=numpy.full(3601, side * 10.0), speed=numpy.full(3601, 36.0))
            across, ahead, unknown_s = drive_pictures.path(drive)
            radius_m = 10.0 / numpy.radians(10.0)
            self.assertAlmostEqual(float(across[1800]), -side * 2.0 * radius_m, delta=0.2)  # half round, to the left by the left turn
            self.assertAlmostEqual(float(ahead[900]), radius_m, delta=0.2)
            self.assertAlmostEqual(float(across[-1]), 0.0, delta=0.2)
            self.assertEqual(unknown_s, 0.0)
        drive.columns["speed"][100:200] = numpy.nan
        self.assertAlmostEqual(drive_pictures.path(drive)[2], 1.0)
        self.assertIn("without 1.0 s that are not known", drive_pictures.pictures(drive, []))
        self.assertIn("No path: the log has no speed, or no yaw rate.", drive_pictures.pictures(self.drive(lateral), []))

    def test_pictures_mark_warnings_and_stay_small(self):
        lateral = 5.0 * numpy.sin(numpy.arange(200_000) / 90.0)
        lateral[500:900] = numpy.nan
        drive = self.drive(lateral, yaw_rate=lateral, speed=numpy.full(len(lateral), 30.0))
        plain, marked = (drive_pictures.pictures(drive, warnings) for warnings in ([], [("3.5", "left"), ("1900", "right")]))
        self.assertEqual((plain.count("--vermilion"), marked.count("--vermilion")), (0, 4))  # on the path, and over time
        self.assertLess(len(marked), 40_000)
        standing = self.drive(numpy.zeros(1), yaw_rate=numpy.zeros(1), speed=numpy.zeros(1))
        self.assertEqual(drive_pictures.pictures(standing, []).count("<svg"), 2)

if __name__ == "__main__":
    support.main()

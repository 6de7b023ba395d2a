"""A sound argument raises no complaint; each planted fault raises its own."""

import json
import pathlib
import stat
import sys
import tempfile
import unittest
import unittest.mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import argument as argument_module
import evidence
import trace as tool

REQUIREMENTS = """
[[hazard]]
id = "HZ-1"
malfunction = "is silent"
situation = "anywhere"
severity = "S3"
exposure = "E2"
controllability = "C2"
reasons = "as it is"

[[goal]]
id = "SG-1"
text = "It is received"
hazards = ["HZ-1"]
safe_state = "unavailable"
time = "50 ms"

[[requirement]]
id = "SR-1"
theme = "Hearing"
text = "hear"
goals = ["SG-1"]
code = ["ear.cpp"]
tests = ["Ear.Hears*", "tests/run rsi"]
limit = "only loud sounds"

[[requirement]]
id = "SR-2"
theme = "Hearing"
text = "hear soft sounds"
goals = ["SG-1"]
assumptions = ["AS-1"]
tests = ["Ear.HearsSoftSounds"]
open = "it does not"

[[assumption]]
id = "AS-1"
on = "vehicle"
text = "there is air"
because = "no sound without"
"""

FAILURE_MODES = """
[[failure_mode]]
id = "FM-1"
direction = "received"
signals = ["Sound.Loudness", "*.Crc"]
mode = "too loud"
effect = "pain"
detection = "limit"
reaction = "closed"
hazards = ["HZ-1"]
requirements = ["SR-1"]

[[failure_mode]]
id = "FM-2"
direction = "sent"
signals = ["Answer.Word"]
mode = "wrong"
effect = "confusion"
detection = "none"
reaction = "none"
hazards = ["HZ-1"]
requirements = ["SR-2"]
"""

PAGE = """# Page
See SR-1.
"""

SIGNALS = {"Sound.Loudness": "received", "Sound.Crc": "received", "Answer.Word": "sent"}


class PlantedFaults(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.project = pathlib.Path(temporary.name)
        (self.project / "ear.cpp").touch()
        (self.project / "tests").mkdir()
        run = self.project / "tests/run"
        run.touch()
        run.chmod(run.stat().st_mode | stat.S_IXUSR)
        self.docs = self.project / "docs"
        for folder in ("safety", "reports/safety"):
            (self.docs / folder).mkdir(parents=True)
        self.write("safety/requirements.toml", REQUIREMENTS)
        self.write("safety/failure_modes.toml", FAILURE_MODES)
        self.write("safety.md", PAGE)
        self.tests = {"Ear.HearsLoudSounds": "rsi", "Mouth.Speaks": "rsi"}
        self.signals = dict(SIGNALS)
        self.codes = []
        self.judge(write=True)

    def write(self, name, text):
        (self.docs / name).write_text(text)

    def judge(self, write=False):
        found = evidence.Evidence(self.project, self.tests, {"rsi"}, self.signals, self.codes, {"Ear.HearsLoudSounds": "tests/ear_test.cpp"})
        return tool.judge(self.docs, found, write)[0]

    def plant(self, name, before, after):
        text = (self.docs / name).read_text()
        self.assertIn(before, text)
        self.write(name, text.replace(before, after))

    def plant_requirement(self, before, after):
        self.plant("safety/requirements.toml", before, after)

    def plant_failure_mode(self, before, after):
        self.plant("safety/failure_modes.toml", before, after)

    def expect(self, *parts):
        problems = self.judge()
        self.assertEqual(len(problems), 1, problems)
        for part in parts:
            self.assertIn(part, problems[0])

    def test_a_sound_argument_raises_none(self):
        self.assertEqual(self.judge(), [])

    def test_tests_are_linked_to_their_file(self):
        self.assertIn("rsi: [Ear.Hears*](../../../tests/ear_test.cpp)", (self.docs / "reports/safety/trace.md").read_text())

    def test_the_state_counts_every_kind(self):
        page = (self.docs / "reports/safety/trace.md").read_text()
        self.assertIn("2 safety requirements: 0 verified, 1 verified within a stated limit, 1 open", page)

    def test_a_requirement_without_a_test(self):
        self.plant_requirement('tests = ["Ear.Hears*", "tests/run rsi"]\n', "")
        self.expect("SR-1 has no test")

    def test_an_unknown_test(self):
        self.plant_requirement("Ear.Hears*", "Ear.HearsNothing")
        self.expect("SR-1", "Ear.HearsNothing")

    def test_a_pattern_that_stands_for_everything(self):
        self.plant_requirement("Ear.Hears*", "*")
        self.expect("SR-1", "verified by *")

    def test_a_disabled_test_does_not_count(self):
        listing = {"tests": [{"name": "Ear.HearsLoudSounds", "properties": [{"name": "DISABLED", "value": True}]}]}
        self.tests = evidence.tests_of(json.dumps(listing))
        self.expect("Ear.Hears*")

    def test_an_unknown_group(self):
        self.plant_requirement("tests/run rsi", "tests/run nowhere")
        self.expect("SR-1", "tests/run nowhere")

    def test_an_unknown_command(self):
        self.plant_requirement("tests/run rsi", "tests/walk")
        self.expect("SR-1", "tests/walk")

    def test_a_requirement_without_code(self):
        self.plant_requirement('code = ["ear.cpp"]\n', "")
        self.expect("SR-1 names no code")

    def test_an_unknown_file(self):
        self.plant_requirement("ear.cpp", "nose.cpp")
        self.expect("SR-1", "nose.cpp")

    def test_a_signal_without_failure_mode(self):
        self.signals["Sound.Pitch"] = "received"
        self.expect("Sound.Pitch", "no failure mode")

    def test_a_whole_frame_does_not_stand_for_its_signals(self):
        self.plant_failure_mode("Answer.Word", "Answer.*")
        self.expect("Answer.Word", "no failure mode")

    def test_an_unknown_signal(self):
        self.plant_failure_mode('"Sound.Loudness"', '"Sound.Loudness", "Sound.Colour"')
        self.expect("FM-1", "Sound.Colour")

    def test_a_signal_of_the_other_direction(self):
        self.plant_failure_mode('"Answer.Word"', '"Answer.Word", "Sound.Loudness"')
        self.expect("FM-2", "Sound.Loudness", "sent")

    def test_an_awaited_signal_may_be_missing_until_it_comes(self):
        last = FAILURE_MODES.split("[[failure_mode]]")[-1].replace("FM-2", "FM-3").replace("Answer.Word", "Answer.Tone")
        self.write("safety/failure_modes.toml", f'{FAILURE_MODES}[[failure_mode]]{last}awaited = "soon"\n')
        self.judge(write=True)
        self.assertEqual(self.judge(), [])
        self.signals["Answer.Tone"] = "sent"
        self.expect("FM-3", "take `awaited` away")

    def test_an_unknown_direction(self):
        self.plant_failure_mode('"sent"', '"hidden"')
        self.assertIn("FM-2 has the direction hidden; there are received, sent, platform", self.judge())

    def test_a_part_of_the_platform_is_no_signal(self):
        last = FAILURE_MODES.split("[[failure_mode]]")[-1].replace("FM-2", "FM-3").replace("Answer.Word", "clock")
        self.write("safety/failure_modes.toml", f"{FAILURE_MODES}[[failure_mode]]{last.replace('sent', 'platform')}")
        self.judge(write=True)
        self.assertEqual(self.judge(), [])
        self.assertIn("| FM-3 | clock |", (self.docs / "reports/safety/failure_modes.md").read_text())

    def test_a_diagnostic_code_without_failure_mode(self):
        self.codes = ["silenced"]
        self.expect("'silenced' is in no failure mode")

    def test_an_unknown_diagnostic_code(self):
        self.plant_failure_mode('detection = "limit"', 'detection = "limit"\ncodes = ["silenced", "blind"]')
        self.judge(write=True)
        self.assertEqual(self.judge(), [], "no code can be sent yet")
        self.codes = ["silenced"]
        self.expect("FM-1", "'blind'")

    def test_a_requirement_without_goal(self):
        self.plant_requirement('goals = ["SG-1"]\nassumptions', "goals = []\nassumptions")
        self.expect("SR-2 serves no goal")

    def test_an_open_requirement_that_is_verified(self):
        self.tests["Ear.HearsSoftSounds"] = "rsi"
        self.expect("SR-2 is open", "take `open` away")

    def test_an_identifier_that_is_there_twice(self):
        self.plant_requirement('id = "SR-2"', 'id = "SR-1"')
        self.assertIn("SR-1 is there twice", self.judge())

    def test_an_identifier_of_the_wrong_form(self):
        self.plant_failure_mode('id = "FM-2"', 'id = "FM2"')
        self.assertTrue(any("'FM2'" in problem for problem in self.judge()))

    def test_a_goal_that_does_not_exist(self):
        self.plant_requirement('goals = ["SG-1"]\nassumptions', 'goals = ["SG-1", "SG-9"]\nassumptions')
        self.expect("SR-2 names SG-9")

    def test_a_hazard_without_a_goal(self):
        self.plant_requirement("[[goal]]", REQUIREMENTS.split("[[goal]]")[0].replace("HZ-1", "HZ-2") + "[[goal]]")
        self.expect("HZ-2 is not used")

    def test_an_assumption_that_nothing_relies_on(self):
        self.plant_requirement('assumptions = ["AS-1"]\n', "")
        self.expect("AS-1 is not used")

    def test_a_failure_mode_without_an_answer(self):
        self.plant_failure_mode('requirements = ["SR-2"]\n', "")
        self.expect("FM-2 is answered by no requirement")

    def test_a_missing_and_an_unknown_key(self):
        self.plant_failure_mode('mode = "wrong"', 'mood = "wrong"')
        self.assertIn("FM-2 has no mode", self.judge())
        self.assertIn("FM-2 has the unknown key mood", self.judge())

    def test_a_generated_page_that_is_out_of_date(self):
        for name in ("trace.md", "hazards.md", "failure_modes.md"):
            with self.subTest(name):
                self.plant(f"reports/safety/{name}", "# ", "# Old ")
                self.expect(name, "--document")
                self.judge(write=True)

    def test_a_page_that_is_missing(self):
        (self.docs / "reports/safety/trace.md").unlink()
        self.expect("trace.md", "--document")

    def test_a_state_that_is_out_of_date(self):
        self.plant("reports/safety/trace.md", "1 open", "0 open")
        self.expect("trace.md", "--document")

    def test_a_page_that_names_what_does_not_exist(self):
        self.plant("safety.md", "See SR-1", "See SR-77")
        self.expect("safety.md names SR-77")

    def test_a_class_that_does_not_exist(self):
        self.plant_requirement('"S3"', '"S9"')
        self.assertRaisesRegex(argument_module.ArgumentError, "HZ-1: S9", self.judge)

    def test_tests_that_are_not_built(self):
        listing = json.dumps({"tests": [{"name": "ear_test_NOT_BUILT"}]})
        self.assertRaisesRegex(evidence.EvidenceError, "ear_test", evidence.tests_of, listing)

    def test_the_build_that_is_complete_is_taken(self):
        def collect(project, build):
            if build.name not in built:
                raise evidence.EvidenceError(f"{build.name} is not built")
            return build.name

        with unittest.mock.patch.object(evidence, "collect", collect):
            for built in (("release", "dev"), ("release",), ("dev",)):
                self.assertEqual(tool.evidence_of(pathlib.Path("/project"), None), built[0])
            self.assertEqual(tool.evidence_of(pathlib.Path("/project"), pathlib.Path("/project/build/dev")), "dev")
            built = ()
            self.assertRaisesRegex(evidence.EvidenceError, "release is not built", tool.evidence_of, pathlib.Path("/project"), None)

    def test_names_are_those_without_parameters(self):
        for name in ("Ear.Hears", "All/Ear.Hears/Loud  # GetParam() = 3", "Ear.Hears/0", "All/Ear.Hears/a_b"):
            self.assertEqual(evidence.plain_name(name), "Ear.Hears")
        self.assertEqual(evidence.plain_name("codec_drift_x"), "codec_drift_x")
        self.assertEqual(evidence.plain_name("Ear/0.Hears"), "Ear.Hears")


if __name__ == "__main__":
    unittest.main()

"""rsi-sil show: a finished run, or a replayed drive, served to a browser; what is no such folder is refused with a sentence.

Use: show_test.py RSI_SIL
"""
import contextlib
import http.client
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

from live_program import LIMIT_S, PROJECT

sys.path.insert(0, str(PROJECT / "tests/sil/page"))
from browser import browser  # noqa: E402

PROGRAM = sys.argv.pop(1)
CALIBRATION = PROJECT / "firmware/calibrations/large_suv.toml"
PLACE = '<script id="recording" type="application/json">'


@contextlib.contextmanager
def shown(folder):
    """The port on which the folder is served; ended by SIGINT, which must be no failure."""
    process = subprocess.Popen([PROGRAM, "show", folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        yield int(re.search(r"http://127\.0\.0\.1:(\d+)/", process.stdout.readline()).group(1))
        process.send_signal(signal.SIGINT)
        assert process.wait(LIMIT_S) == 0, process.stderr.read()
    finally:
        process.kill()
        process.communicate()


class Show(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.run_folder = cls.scratch / "run"
        subprocess.run([PROGRAM, "run", "j-turn-110", "--in-process", "--vehicle", PROJECT / "sil/vehicles/large_suv.toml",
                        "--parameters", CALIBRATION, "--output", cls.run_folder], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([PROGRAM, "replay", cls.run_folder / "signals.csv", "--parameters", CALIBRATION, "--output",
                        cls.scratch / "replayed", "--no-pictures"], check=True, capture_output=True)

    def refusal(self, folder):
        result = subprocess.run([PROGRAM, "show", folder], capture_output=True, text=True, timeout=LIMIT_S, check=False)
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        return result.stderr

    def page_of(self, name, text):
        folder = self.scratch / name
        folder.mkdir()
        (folder / "report.html").write_text(text, encoding="utf-8")
        return folder

    def test_plays_a_run_and_a_replay(self):
        with browser() as tab:
            for folder in (self.run_folder, self.scratch / "replayed/signals"):
                with shown(folder) as port:
                    tab.open(f"http://127.0.0.1:{port}/#1.7")
                    self.assertEqual(tab.run("document.body.dataset.mode"), "replay")
                    warned = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["warning_time_s"]
                    shown_at = tab.run("Number(document.querySelector('[data-event=warning]').dataset.value)")
                    self.assertEqual(shown_at, warned)
                    self.assertEqual(tab.run("document.getElementById('lamp-text').textContent"), "warning, right side")
            self.assertEqual(tab.complaints, [])

    def test_serves_one_page_and_drives_nothing(self):
        with shown(self.run_folder) as port:
            upgrade = {"Connection": "Upgrade", "Upgrade": "websocket", "Sec-WebSocket-Version": "13",
                       "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==", "Origin": f"http://127.0.0.1:{port}"}
            for target, headers, status in (("/", {}, 200), ("/signals.csv", {}, 404), ("/", {"Host": "evil.example"}, 403),
                                            ("/drive", upgrade, 404)):
                connection = http.client.HTTPConnection("127.0.0.1", port, timeout=LIMIT_S)
                connection.request("GET", target, headers=headers)
                answer = connection.getresponse()
                self.assertEqual(answer.status, status, target)
                answer.read()
                connection.close()

    def test_only_the_recording_of_a_page_is_used(self):
        text = (self.run_folder / "report.html").read_text(encoding="utf-8")
        folder = self.page_of("changed", text.replace("<body", "<script>document.title = 'intruder'</script><body"))
        with shown(folder) as port:
            connection = http.client.HTTPConnection("127.0.0.1", port, timeout=LIMIT_S)
            connection.request("GET", "/")
            served = connection.getresponse().read().decode()
            connection.close()
        self.assertEqual(served, text)

    def test_other_folders_are_refused(self):
        self.assertIn("is no folder", self.refusal(self.scratch / "nothing"))
        self.assertIn("is no folder", self.refusal(self.run_folder / "signals.csv"))
        (self.scratch / "empty").mkdir()
        self.assertIn("there is no report.html; a run or a replay of this version leaves one",
                      self.refusal(self.scratch / "empty"))
        self.assertIn("choose one of " + str(self.scratch / "replayed/signals"), self.refusal(self.scratch / "replayed"))
        self.assertIn("holds no run", self.refusal(self.page_of("other", "<html></html>")))
        self.assertIn("holds no run", self.refusal(self.page_of("live", f"{PLACE}null</script>")))
        self.assertIn("is damaged", self.refusal(self.page_of("cut", f'{PLACE}{{"columns":[</script>')))
        self.assertIn("is damaged", self.refusal(self.page_of("foreign", f"{PLACE}[1]</script>")))


if __name__ == "__main__":
    unittest.main(verbosity=1)

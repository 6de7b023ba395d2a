"""A picture that contradicts the words below it is not taken."""
import pathlib
import unittest

import picture_words

README = pathlib.Path(__file__).resolve().parents[3] / "README.md"
TEXT = "![A truck with two wheels in the air, the warning lamp with its side](a.png)\n\n*Load it. Warned 0.25 s before; load the roof (as here).*\n\n"
SEEN = {"gaps_m": {"left": 0.2, "right": 0.0}, "state": "warning", "side": "right", "lead_s": 0.251, "roof_load_kg": 150,
        "slider_deg": 360, "steering_deg": 360.0, "empty_share": 0.0}


class PictureWords(unittest.TestCase):
    def contradictions(self, **changes):
        return picture_words.contradictions(picture_words.words(TEXT), {**SEEN, **changes})

    def test_right_words_are_not_contradicted(self):
        self.assertEqual(self.contradictions(), [])
        self.assertEqual(self.contradictions(gaps_m={"left": 0.0, "right": 0.3}, side="left"), [])

    def test_each_contradiction_is_said(self):
        for changes, said in (({"gaps_m": {"left": 0.02, "right": 0.0}}, "two wheels in the air: the gaps are "),
                              ({"state": "ready", "side": "none"}, "warning lamp with its side: it shows ready"),
                              ({"lead_s": 0.131}, "0.25 s before: the lead is 0.131 s"), ({"lead_s": None}, "0.25 s before: "),
                              ({"roof_load_kg": 0}, "load the roof (as here): "), ({"slider_deg": 0}, "the slider is at 0 deg"),
                              ({"empty_share": 0.6}, "60 % of the time axis are empty")):
            found = self.contradictions(**changes)
            self.assertEqual(len(found), 1, found)
            self.assertTrue(found[0].startswith(said), found)

    def test_readmes_words_are_those_that_are_compared(self):
        words = picture_words.words(README.read_text(encoding="utf-8"))
        for part in ("two wheels in the air", "warning lamp with its side", "load the roof (as here"):
            self.assertIn(part, words)


if __name__ == "__main__":
    unittest.main(verbosity=1)

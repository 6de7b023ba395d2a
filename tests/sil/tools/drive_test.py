"""Drives of foreign logs: every container and a foreign DBC file give the warnings of the run; what is wrong is told."""

import support

import bus_log_writers
import bus_logs
import foreign_recorder
from own_mapping import OWN_DBC, OWN_MAPPING


class Drive(support.WithRun):
    def mapping(self, text=foreign_recorder.MAPPING):
        file = self.folder / "mapping.toml"
        file.write_text(text, encoding="utf-8")
        return file

    def written(self, kind, frames):
        file = self.folder / f"recorded.{kind}"
        getattr(bus_log_writers, f"write_{kind}")(file, iter(frames))
        return file

    def drive(self, *logs, dbc=foreign_recorder.DBC, mapping=None):
        """The drive of these logs, and what was said."""
        file = self.folder / "made" / "drive.csv"
        file.parent.mkdir(exist_ok=True)
        said = self.logs("drive", *logs, "--dbc", dbc, "--mapping", mapping or self.mapping(), "--output", file)
        return file, said

    def test_every_container_with_its_own_dbc_gives_the_warnings_of_the_run(self):
        warnings = self.replay(self.original)
        self.assertIn("warning,right", warnings)
        frames = list(bus_logs.BusLog(self.original).frames())
        for kind in ("blf", "asc", "mf4", "candump"):
            drive, said = self.drive(self.written(kind, frames), dbc=OWN_DBC, mapping=self.mapping(OWN_MAPPING))
            self.assertEqual(self.replay(drive), warnings, kind)
            self.assertIn("none missing", said)

    def test_a_foreign_dbc_gives_them_through_its_mapping(self):
        warnings = self.replay(self.original)
        for kind in ("blf", "asc", "mf4", "candump"):
            drive, said = self.drive(self.written(kind, foreign_recorder.frames(self.run_folder)))
            self.assertEqual(self.replay(drive), warnings, kind)
            self.assertRegex(said, r"speed +WHEELSPEED\.VehSpd +20 ")


if __name__ == "__main__":
    support.main()

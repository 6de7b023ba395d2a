"""Drives of what others have decoded already: a CSV with other names and units, an MF4 of signals."""

import datetime
import re

import drive_support
import support

import foreign_recorder
import mapping_answers

COLUMNS = {"Ay [G]": ("lateral_acceleration_mps2", 1 / foreign_recorder.G_MPS2),
           "RollVel [rad/s]": ("roll_rate_degps", 1 / foreign_recorder.DEGREES),
           "Phi (deg)": ("roll_angle_deg", -1.0), "v": ("speed_mps", 3.6), "psi_p_degps": ("yaw_rate_degps", 1.0),
           "Az_mps2": ("vertical_acceleration_mps2", 1.0), "delta_deg": ("steering_wheel_angle_deg", 1.0)}
UNITS = ["ms", "G", "rad/s", "deg", "km/h", "deg/s", "m/s^2", "deg", "-"]
MAPPING = """\
[time]
signal = "t"
unit = "ms"
[lateral_acceleration]
signal = "Ay [G]"
[roll_rate]
signal = "RollVel [rad/s]"
[roll_angle]
signal = "Phi (deg)"
sign = -1
[speed]
signal = "v"
unit = "km/h"
[yaw_rate]
signal = "psi_p_degps"
[vertical_acceleration]
signal = "Az_mps2"
[steering_wheel_angle]
signal = "delta_deg"
"""
WITHOUT_TIME = MAPPING.split("[lateral")[0]


class Tables(drive_support.WithDrives):
    def table(self, separator=",", comma=False, before="", units=None, change=lambda line: line):
        lines = [separator.join(["t", *COLUMNS, "remark"])] + ([separator.join(units)] if units else [])
        for row in foreign_recorder.rows(self.run_folder):
            fields = [f"{row['time_s'] * 1000:.1f}"] + [f"{row[source] * factor:.6f}" for source, factor in COLUMNS.values()]
            lines.append(separator.join([field.replace(".", ",") if comma else field for field in fields] + ["good"]))
        file = self.folder / "table.csv"
        file.write_text(before + "".join(change(line) + "\n" for line in lines), encoding="utf-8")
        return file

    def test_a_csv_gives_the_warnings_of_the_run(self):
        warnings = self.replay(self.original)
        for arguments in ({}, {"separator": ";", "comma": True}, {"separator": "\t"}, {"before": "Recorder 3\nVehicle: 7, load: "
                                                                                                 "none\n"},
                          {"units": UNITS}):
            drive, said = self.drive(self.table(**arguments), dbc=None, mapping=self.mapping(MAPPING))
            self.assertEqual(self.replay(drive), warnings, arguments)
            self.assertIn("304 rows over 3.03 s; none missing", said)

    def recorded_by(self, head, separator=",", comma=False, quoted=False, last="", between=lambda number: ""):
        """The run as another recorder's file: `head` stands before the rows, the columns are those of COLUMNS."""
        lines = []
        for number, row in enumerate(foreign_recorder.rows(self.run_folder)):
            fields = [f"{row['time_s']:.3f}"] + [f"{row[source] * factor:.6f}" for source, factor in COLUMNS.values()]
            fields = [field.replace(".", ",") if comma else f'"{field}"' if quoted else field for field in fields]
            lines.append(between(number) + separator.join(fields) + last + "\n")
        file = self.folder / "recorded.csv"
        file.write_text(head + "".join(lines), encoding="cp1252")
        return file

    def drafted(self, file, names):
        """The draft's mapping, answered with these signals and their signs; also that it was not far from that."""
        draft = self.folder / "drafted.toml"
        draft.unlink(missing_ok=True)
        self.logs("draft", "--log", file, "--output", draft)
        text = draft.read_text(encoding="utf-8")
        time = re.search(r'^\[time\]\nsignal = "(.*)"$', text, re.MULTILINE)[1]
        found = [name for name in names.values() if f'"{name}"' in text]
        mapping = f'[time]\nsignal = "{time}"\nunit = "s"\n' + "".join(
            f'[{quantity}]\nsignal = "{name}"\n' + ("sign = -1\n" if quantity == "roll_angle" else "")
            for quantity, name in names.items())
        return found, mapping

    def expect_drive(self, file, mapping):
        drive, _ = self.drive(file, dbc=None, mapping=self.mapping(mapping))
        self.assertEqual(self.replay(drive), self.replay(self.original))

    QUANTITIES = ("lateral_acceleration", "roll_rate", "roll_angle", "speed", "yaw_rate", "vertical_acceleration",
                  "steering_wheel_angle")
    ENGLISH = ("Lateral Acceleration", "Roll Rate", "Roll Angle", "Ground Speed", "Yaw Rate", "Vertical Acceleration", "Steer Angle")
    SHORT_UNITS = ("G", "rad/s", "deg", "km/h", "deg/s", "m/s^2", "deg")

    def test_remarks_of_laps_between_the_rows(self):
        names = [f"{name} ({unit})" for name, unit in zip(self.ENGLISH, self.SHORT_UNITS)]
        file = self.recorded_by("# RaceRender Data: made by a test\n# Space: 1 MB, 2 files\n" + '"Time",'
                                + ",".join(f'"{name}"' for name in names) + "\n",
                                between=lambda number: f"# Lap {number // 100}: 00:00:01.000\n" if number % 100 == 50 else "")
        found, mapping = self.drafted(file, dict(zip(self.QUANTITIES, names)))
        self.assertEqual(found, names)
        self.expect_drive(file, mapping)

    def test_names_below_other_lines_and_units_below_the_names(self):
        head = ('"Format","A test",,,"Workbook",""\n"Venue","Road",,,"Time","10:00"\n"Sample Rate","100.000",,,"Duration","3.04"\n'
                '"Driver","A",,,,,,\n"Segment","B","C","D","E","F","G","H"\n\n'
                + ",".join(f'"{name}"' for name in ("Time", *self.ENGLISH)) + "\n"
                + ",".join(f'"{unit}"' for unit in ("s", *self.SHORT_UNITS)) + '\n"","","","","","","",""\n\n')
        file = self.recorded_by(head, quoted=True)
        found, mapping = self.drafted(file, dict(zip(self.QUANTITIES, self.ENGLISH)))
        self.assertEqual(found, list(self.ENGLISH))
        self.expect_drive(file, mapping)

    def test_names_with_unit_range_and_rate(self):
        head = '"Interval"|"s"|0|0|1,' + ",".join(f'"{name}"|"{unit}"|-3.0|3.0|25'
                                                  for name, unit in zip(self.ENGLISH, self.SHORT_UNITS)) + "\n"
        file = self.recorded_by(head)
        found, mapping = self.drafted(file, dict(zip(self.QUANTITIES, self.ENGLISH)))
        self.assertEqual(found, list(self.ENGLISH))
        self.expect_drive(file, mapping)

    def test_a_german_table(self):
        names = ("Querbeschleunigung", "Wankrate", "Wankwinkel", "Fahrzeuggeschwindigkeit", "Gierrate", "Vertikalbeschleunigung",
                 "Lenkradwinkel")
        head = ("Messung vom 3. Mai, Fahrer: A, Wagen: leer\n" + ";".join(("Zeit", *names)) + ";\n"
                + ";".join(("s", "g", "rad/s", "\u00b0", "km/h", "\u00b0/s", "m/s\u00b2", "\u00b0")) + ";\n")
        file = self.recorded_by(head, separator=";", comma=True, last=";")
        found, mapping = self.drafted(file, dict(zip(self.QUANTITIES, names)))
        self.assertEqual(found, list(names))
        self.expect_drive(file, mapping)

    def test_a_file_without_a_quantity_is_refused(self):
        draft = self.folder / "none.toml"

        def refused(expected, text):
            file = self.folder / "other.csv"
            file.write_text(text, encoding="utf-8")
            self.refused(f"{file}{expected}", "draft", "--log", file, "--output", draft)
            self.assertFalse(draft.exists())

        refused(": none of its 3 signals has the name of a quantity of a drive; ", "time_s,alpha,beta\n0.0,1,2\n0.1,1,2\n")
        refused(":1: no line of the first 200 names columns of which rows of numbers follow", "a,b\nc,d\n")
        refused(":1: no line of the first 200 names columns of which rows of numbers follow", "0,1\n2,3\n")
        refused(":1: no line of the first 200 names columns of which rows of numbers follow", "some words\n")
        refused(": holds frames (TRC), so your DBC file is needed: --dbc FILE", ";$FILEVERSION=1.1\n1) 0.1 Rx 0120 1 00\n")
        refused(": holds frames (CSV of frames), so your DBC file is needed: --dbc FILE",
                "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n100,00000120,false,Rx,0,1,00,\n")

    def test_time_before_a_trigger_is_negative(self):
        table = self.table(change=lambda line: re.sub(r"^[\d.]+", lambda time: f"{float(time[0]) - 1000.0:.1f}", line))
        drive, _ = self.drive(table, dbc=None, mapping=self.mapping(MAPPING))
        self.assertEqual([row["time_s"] for row in self.rows(drive)][:2], ["-1.000000", "-0.990000"])
        self.assertEqual([line.split(",")[1:] for line in self.replay(drive).splitlines()],
                         [line.split(",")[1:] for line in self.replay(self.original).splitlines()])

    def test_times_of_day_are_seconds_and_need_no_answer(self):
        names = ("Querbeschleunigung in g", "Wankrate in rad/s", "Wankwinkel / \u00b0", "v_Fzg in km/h", "Gierrate in \u00b0/s",
                 "Hochbeschleunigung in m/s\u00b2", "Lenkradwinkel in \u00b0")
        plain = self.recorded_by(";".join(("Zeit", *names)) + "\n", separator=";", comma=True)
        rows = plain.read_text(encoding="cp1252").split("\n", 1)[1]
        warnings = self.replay(self.original)
        # Two seconds before midnight, also with the day.
        for title, day, next_day in (("Zeit", None, None), ("Uhrzeit", "", ""), ("Datum und Uhrzeit", "31.12.2025 ", "01.01.2026 "),
                                     ("Timestamp", "2025-12-31T", "2026-01-01T")):
            def time_of_day(found, day=day, next_day=next_day):
                time_s = float(found[0].replace(",", ".")) + 86_398.0
                of_day = time_s % 86_400
                text = f"{int(of_day) // 3600:02}:{int(of_day) // 60 % 60:02}:{of_day % 60:06.3f}".replace(".", ",")
                return (next_day if time_s > of_day else day) + text

            file = self.folder / "clock.csv"
            file.write_text(";".join((title, *names)) + "\n" + (rows if day is None else re.sub(r"(?m)^[\d,]+", time_of_day, rows)),
                            encoding="utf-8")
            draft = self.folder / "drafted.toml"
            draft.unlink(missing_ok=True)
            self.logs("draft", "--log", file, "--output", draft)
            text = draft.read_text(encoding="utf-8")
            self.assertIn(f'[time]\nsignal = "{title}"\nunit = "s"', text)
            self.assertNotIn('unit = "?"', text)
            mapping_answers.answer(draft, "left")
            drive, _ = self.drive(file, dbc=None, mapping=draft)
            rows_of_day = self.replay(drive).splitlines()
            self.assertEqual(rows_of_day[-1].split(",")[1:], warnings.splitlines()[-1].split(",")[1:], title)
            self.assertEqual(len(self.rows(drive)), 304)

    def test_the_line_of_units_is_read(self):
        mapping = self.mapping(MAPPING.replace('unit = "km/h"\n', ""))
        drive, _ = self.drive(self.table(units=UNITS), dbc=None, mapping=mapping)
        self.assertEqual(self.rows(drive)[0]["speed_kmh"], "110")

    def test_an_mf4_of_signals_gives_the_warnings_of_the_run(self):
        import asammdf
        import numpy

        rows = list(foreign_recorder.rows(self.run_folder))
        times = numpy.array([row["time_s"] for row in rows])
        mdf = asammdf.MDF(version="4.10")
        mdf.header.start_time = datetime.datetime.fromtimestamp(0, datetime.timezone.utc)
        for name, (source, factor) in COLUMNS.items():
            mdf.append([asammdf.Signal(numpy.array([row[source] * factor for row in rows]), times, name=name, unit=name[-2:-1])])
        mdf.append([asammdf.Signal(numpy.array([b"driving"] * len(rows)), times, name="Mode", encoding="utf-8")])
        file = self.folder / "signals.mf4"
        mdf.save(file)
        mdf.close()
        units = MAPPING.replace(WITHOUT_TIME, "").replace('"Ay [G]"', '"Ay [G]"\nunit = "g"')
        for ending, unit in (("[rad/s]", "rad/s"), ("(deg)", "deg"), ("degps", "deg/s"), ("mps2", "m/s^2"), ("ta_deg", "deg")):
            units = units.replace(f'{ending}"', f'{ending}"\nunit = "{unit}"')
        drive, _ = self.drive(file, dbc=None, mapping=self.mapping(units))
        self.assertEqual(self.replay(drive), self.replay(self.original))
        drafted = self.folder / "drafted.toml"
        self.logs("draft", "--log", file, "--output", drafted)
        self.assertIn('signal = "Ay [G]"', drafted.read_text(encoding="utf-8"))
        for wrong, expected in (("Ay [G", "has no such channel; close to it: Ay [G]"), ("Mode", None)):
            mapping = self.mapping(units.replace('"Ay [G]"', f'"{wrong}"'))
            if expected:
                self.assertIn(expected, self.drive_refused(f"{mapping}:2: lateral_acceleration.signal is '{wrong}', but {file} "
                                                           "", file, dbc=None,
                                                           mapping=mapping))
            else:
                self.drive_refused(f"{file}: Mode has no value, only texts, such as 'driving', and {mapping}:2 maps it",
                                   file, dbc=None, mapping=mapping)

    def test_bad_tables_are_refused_with_the_place(self):
        mapping = self.mapping(MAPPING)
        good = self.table()

        def refused(expected, change, text=MAPPING):
            file = self.table()
            lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
            file.write_text("".join(change(lines)), encoding="utf-8")
            return self.drive_refused(f"{file}{expected}", file, dbc=None, mapping=self.mapping(text))

        def at_100(line):
            return lambda lines: lines[:99] + [line(lines[99])] + lines[100:]

        refused(":100: 8 fields, but line 1 names 9 columns", at_100(lambda line: line.replace(",good", "")))
        refused(":100: the time is 'noon', which is neither a number nor a time of day; ", at_100(lambda _: "noon,0,0,0,0,0,0,0,\n"))
        refused(":100: the time runs back from 0.970000 s to 0.000000 s: ", at_100(lambda _: "0,0,0,0,0,0,0,0,\n"))
        refused(":305: the last line has no line end: the file was cut off; ",
                lambda lines: lines[:-1] + [lines[-1].rstrip("\n")])
        refused(":1: there are no rows below the header", lambda lines: lines[:1])
        refused(":1: no line of the first 200 has a column 't', which the mapping's [time] names; ",
                lambda lines: ["a,b,c\n"] + lines[1:])
        refused(":1: two columns are called 'v'; ", lambda lines: [lines[0].replace("psi_p_degps", "v")] + lines[1:],
                MAPPING.replace("psi_p_degps", "v"))
        refused(": the file is empty; ", lambda lines: [])
        refused(": Ay [G] has no value, only texts, such as 'nil', and ",
                lambda lines: lines[:1] + [",".join([line.split(",")[0], "nil", *line.split(",")[2:]]) for line in lines[1:]])
        no_time = self.mapping(MAPPING.replace(WITHOUT_TIME, ""))
        self.drive_refused(f"{no_time}:1: there is no table [time], and {good} is a CSV; ", good, dbc=None, mapping=no_time)
        misspelt = self.mapping(MAPPING.replace("Ay [G]", "ay"))
        self.drive_refused(f"{misspelt}:5: lateral_acceleration.signal is 'ay', but {good} has no such column; ", good, dbc=None,
                           mapping=misspelt)
        with_bus = self.mapping(MAPPING + "bus = 1\n")
        self.drive_refused(f"{with_bus}:20: steering_wheel_angle.bus is for logs of frames; ",
                           self.table(), dbc=None, mapping=with_bus)
        frames = self.written("blf", foreign_recorder.frames(self.run_folder))
        self.drive_refused(f"{frames}: holds frames (BLF), so your DBC file is needed: --dbc FILE", frames, dbc=None,
                           mapping=self.mapping(MAPPING))
        frames = self.written("mf4", foreign_recorder.frames(self.run_folder))
        self.drive_refused(f"{frames}: holds frames (MF4), so your DBC file is needed: --dbc FILE", frames, dbc=None,
                           mapping=self.mapping(MAPPING))
        self.assertTrue(mapping.exists())


if __name__ == "__main__":
    support.main()

"""DBC files with odd lines: those are left out or mended, counted and named; all the rest is read."""

import contextlib
import io
import time

import support

import dbc_file
import dbc_signals

HEAD = 'VERSION ""\n\nNS_ :\n\tCM_\n\tVAL_\n\nBS_:\n\nBU_: ECU\n\n'
MESSAGE = ('BO_ 36 KIN: 8 ECU\n SG_ Ay : 7|16@0- (0.001,0) [-20|20] "m/s^2" ECU\n SG_ Yaw : 23|16@0- (0.01,0) [-300|300] "deg/s" '
           "ECU\n\n")
SOUND = {"KIN.Ay", "KIN.Yaw"}
FIRST_LINE = HEAD.count("\n") + MESSAGE.count("\n") + 1


class DbcFile(support.WithFolder):
    def read(self, content):
        """The names of a file's signals, and what was said of it."""
        file = self.folder / "odd.dbc"
        file.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            database = dbc_signals.Database([file])
        return database, said.getvalue()

    def odd(self, lines, expected, names=SOUND):
        """Reads a good file with these lines in it; `expected` counts lines from the first of them."""
        database, said = self.read(HEAD + MESSAGE + lines + "\n" + "BO_ 37 LAST: 1 ECU\n SG_ B : 0|8@1+ (1,0) [0|0] \"\" ECU\n")
        self.assertEqual(set(database.signals), names | {"LAST.B"}, lines)
        self.assertIn(f"odd.dbc: {expected.count('line {')} odd line", said, lines)
        self.assertIn(expected.format(*range(FIRST_LINE, FIRST_LINE + 10)), said)
        return database

    def test_a_file_without_odd_lines_is_read_in_silence(self):
        database, said = self.read("\ufeff" + HEAD + MESSAGE)
        self.assertEqual((set(database.signals), said), (SOUND, ""))

    def test_statements_about_nothing_are_left_out(self):
        left_out = "line {}: it is about {}: left out"
        no_signal, no_message = "a signal Gone, which message 36 has not", "message 99, which is not there"
        # A strict parser refuses the last line of each.
        end = "\nVAL_ 36 Gone 0 \"off\";"
        for statement, about in (("CM_ SG_ 36 Gone \"text\";", no_signal), ("CM_ BO_ 99 \"text\";", no_message),
                                 ("SIG_VALTYPE_ 99 Ay : 1;", no_message), ("SG_MUL_VAL_ 36 Ay Gone 0-3;", no_signal),
                                 ("VAL_ 99 Ay 0 \"off\" 1 \"on\";", no_message), ("CM_ SG_ 36 Gone \"more\nlines\";", no_signal)):
            _, said = self.read(HEAD + MESSAGE + statement + end)
            self.assertIn("odd.dbc: 2 odd lines; " + left_out.format(FIRST_LINE, about), said)
            self.assertIn(left_out.format(FIRST_LINE + 1 + statement.count("\n"), no_signal), said)

    def test_odd_lines_that_a_parser_takes_in_silence_are_said(self):
        other = "BO_ 40 OTHER: 2 ECU\n"
        for lines, expected, names in (
                ('CM_ SG_ 36 Gone "text";', "line {0}: it is about a signal Gone, which message 36 has not: left out", set()),
                (other + ' SG_ C : 8|9@1+ (1,0) [0|0] "" ECU', "line {1}: signal C reaches beyond the 2 bytes of its message",
                 {"OTHER.C"}),
                (other + ' SG_ C : 8|9@0+ (1,0) [0|0] "" ECU', "line {1}: signal C reaches beyond the 2 bytes", {"OTHER.C"}),
                (other + ' SG_ C : 7|8@0+ (1,0) [0|0] "" ECU\n SG_ C : 8|8@1+ (1,0) [0|0] "" ECU',
                 "line {2}: a second signal C in its message: left out", {"OTHER.C"}),
                ('BO_ 36 AGAIN: 8 ECU\n SG_ C : 0|8@1+ (1,0) [0|0] "" ECU',
                 f"line {{0}}: message AGAIN has the identifier 36 of the message in line {FIRST_LINE - 4}: both are read", {"AGAIN.C"}),
                ('BO_ 40 KIN: 8 ECU\n SG_ C : 0|8@1+ (1,0) [0|0] "" ECU', "line {0}: a second message KIN: of signals", {"KIN.C"})):
            self.odd(lines, expected, SOUND | names)

    def test_broken_statements_are_left_out(self):
        for lines, expected in (
                ('CM_ SG_ 36 "no name";', "line {0}: a signal's comment without the signal's name"),
                ('CM_ 36 "no kind";', "line {0}: this is no comment"),
                ('CM_ SG_ 36 Ay "never closed', "line {0}: this is no comment"),
                ("VAL_ 36 Ay 0 off 1 on;", "line {0}: these are no texts of values"),
                (' SG_ Broken : 0|8@1+ (1,0 [0|1] "" ECU', "line {0}: this is no signal"),
                (' SG_ Nothing : 0|0@1+ (1,0) [0|1] "" ECU', "line {0}: signal Nothing of 0 bits"),
                (' SG_ Ay : 0|8@1+ (0.1.0,0) [0|1] "" ECU', "line {0}: this is no signal"),
                ('BA_DEF_ BO_ "Kind" ENUM "a","b";\nBA_DEF_DEF_ "Kind" "a";\nBA_ "Kind" BO_ 36 7;\nVAL_ 9 x 0 "x";',
                 "line {2}: attribute Kind has no value number 7: left out; line {3}: it is about message 9"),
                ('BA_ "NotDefined" BO_ 36 7;\nVAL_ 9 x 0 "x";', "line {0}: no attribute NotDefined is defined: left out; line {1}: "),
                ("<<<<<<< HEAD", "line {0}: this is no statement of a DBC file"),
                ("BO_ 3000000000 Wide: 8 ECU\n SG_ C : 0|8@1+ (1,0) [0|1] \"\" ECU",
                 "line {0}: message Wide's identifier 3000000000 has more than 29 bits: left out; line {1}: a signal without its "
                 "message"),
                ("BO_ x Name: 8 ECU", "line {0}: 'x' is no identifier")):
            self.odd(lines, expected)
        database, said = self.read((HEAD + MESSAGE).replace("BS_:", "BS_: 500000 : 1,2"))
        self.assertEqual(set(database.signals), SOUND)
        self.assertIn("odd.dbc: 1 odd line; line 7: the bit timing is not needed: left out", said)

    def test_lines_of_one_possible_meaning_are_mended(self):
        database = self.odd('BO_ 316476583 CAMERA: 8 ECU\n SG_ A : 0|8@1+ (1,0) [0|1] "" ECU\nCM_ SG_ 316476583 A "text";',
                            "line {0}: message CAMERA's identifier 316476583 has more than 11 bits, but not bit 31 that should "
                            "say so: read as one of 29", SOUND | {"CAMERA.A"})
        camera = next(message for message in database.messages if message.name == "CAMERA")
        self.assertEqual((camera.frame_id, camera.is_extended_frame, camera.signals[0].comment), (316476583, True, "text"))
        # Names that are no words, numbers without a zero, ranges that are no numbers, a semicolon that is missing.
        lines = ('BO_ 38 2017_\u00e4: 8 ECU\n SG_ 0_R\u00e4der M : 0|8@1+ (1,0) [-1.#IND|x] "km/h" ECU\n'
                 ' SG_ Gierrate-1 m3 : 8|16@1+ (.25,-.5) [0|1] "Grad/s" ECU\nVAL_ 38 0_R\u00e4der 1 "on"\n')
        for encoding in ("utf-8", "cp1252"):
            database, said = self.read((HEAD + MESSAGE + lines).encode(encoding))
            self.assertEqual(said, "")
            self.assertEqual(set(database.signals), SOUND | {"2017_\u00e4.0_R\u00e4der", "2017_\u00e4.Gierrate-1"})
            message = database.messages[1]
            self.assertEqual(message.decode(bytes([3, 244, 1, 0, 0, 0, 0, 0])), {"0_R\u00e4der": 3, "Gierrate-1": 124.5})
            self.assertEqual(str(message.decode(bytes([1, 0, 0, 0, 0, 0, 0, 0]), allow_truncated=True)["0_R\u00e4der"]), "on")

    def test_j1939_and_floats_are_known_beside_odd_lines(self):
        database = self.odd('BO_ 2566844926 CCVS: 8 ECU\n SG_ F : 0|32@1- (1,0) [0|0] "" ECU\nSIG_VALTYPE_ 2566844926 F : 1;\n'
                            'BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN","reserved","J1939PG";\n'
                            'BA_ "VFrameFormat" BO_ 2566844926 3;\nVAL_ 36 Gone 0 "x";', "line {5}: it is about a signal Gone",
                            SOUND | {"CCVS.F"})
        message = next(message for message in database.messages if message.name == "CCVS")
        self.assertEqual((message.protocol, message.signals[0].is_float), ("j1939", True))
        self.assertEqual(message.frame_id, 2566844926 & ~(1 << 31))

    def test_a_message_that_the_parser_refuses_costs_that_message(self):
        blocks = dbc_file.DbcFile("".join(f'BO_ {number} M{number}: 8 ECU\n SG_ A : 0|8@1+ (1,0) [0|1] "" ECU\n'
                                          for number in range(1, 9))).blocks
        blocks[4].lines.append("an unforeseen line")
        odd = []
        messages = dbc_signals.sorted_out(blocks, odd)
        self.assertEqual([message.name for message in messages], ["M1", "M2", "M3", "M4", "M6", "M7", "M8"])
        self.assertEqual([line for line, _ in odd], [9])
        self.assertIn("message M5 cannot be understood (", odd[0].what)

    def test_huge_numbers_cost_neither_time_nor_memory(self):
        for lines, expected in (
                (' SG_ C : 400000000|8@1+ (1,0) [0|1] "" ECU', "line {0}: signal C of 8 bits from bit 400000000 on: left out"),
                (' SG_ C : 0|400000000@1+ (1,0) [0|1] "" ECU', "line {0}: signal C of 400000000 bits from bit 0 on: left out"),
                (' SG_ C : 600|8@1+ (1,0) [0|1] "" ECU\nVAL_ 9 x 0 "x";', "line {0}: signal C of 8 bits from bit 600 on: left out; "
                                                                          "line {1}: "),
                (' SG_ C m9999999999 : 0|8@1+ (1,0) [0|1] "" ECU', "line {0}: this is no signal"),
                (' SG_ C : 0|8@1+ (1e400000000,0) [0|1] "" ECU', "line {0}: this is no signal"),
                ("SG_MUL_VAL_ 36 Ay Yaw 0-400000000;", "line {0}: signal Ay on more than 65536 pages: left out"),
                ("BO_ 50 Long: 4000000000 ECU", "line {0}: message Long of 4000000000 bytes: left out")):
            started_s = time.process_time()
            self.odd(lines, expected)
            self.assertLess(time.process_time() - started_s, 2.0)

    def test_a_long_bad_file_takes_no_time(self):
        count = 1000
        bad = "".join(f'BO_ {number} M{number}: 8 ECU\n SG_ A : 0|8@1+ (1,0) [0|1] "" ECU\n SG_ B : 0|8@1+ (1,0 [0|1]\n'
                      f'CM_ SG_ {number} C "never closed\n' for number in range(count))
        started_s = time.process_time()
        database, said = self.read(HEAD + bad)
        self.assertLess(time.process_time() - started_s, 5.0)
        self.assertEqual(len(database.messages), count)
        self.assertIn(f"odd.dbc: {2 * count} odd lines; line 13: this is no signal", said)
        self.assertIn(f"; and {2 * count - 3} more", said)


if __name__ == "__main__":
    support.main()

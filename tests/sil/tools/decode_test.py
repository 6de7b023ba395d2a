"""Decoded logs, read back by the libraries: numbers with their units, enumerations as texts, what is missing as NaN."""

import json
import math
import subprocess

import asammdf
import cantools
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from mcap.reader import make_reader

import drive_support
import support

import bus_logs
import foreign_recorder
from own_mapping import OWN_DBC


def messages_of(file):
    """The messages of an MCAP by topic: time and fields. They are decoded by what the file itself says of them."""
    pool, kinds, messages = descriptor_pool.DescriptorPool(), {}, {}
    with file.open("rb") as stream:
        for schema, channel, message in make_reader(stream).iter_messages():
            if schema.id not in kinds:
                described = descriptor_pb2.FileDescriptorSet.FromString(schema.data)
                pool.Add(described.file[0])
                kinds[schema.id] = message_factory.GetMessageClass(pool.FindMessageTypeByName(schema.name))
            fields = kinds[schema.id].FromString(message.data)
            messages.setdefault(channel.topic, []).append((message.log_time, fields))
    return messages


class Decode(drive_support.WithDrives):
    def decoded(self, *arguments):
        folder = self.folder / "decoded"
        said = self.logs("decode", *arguments, "--output", folder)
        return asammdf.MDF(folder / "signals.mf4"), messages_of(folder / "run.mcap"), said

    def expected(self, log, dbc):
        """The values of every signal by a library alone, by message and name."""
        database, values = cantools.database.load_file(dbc), {}
        for frame in bus_logs.BusLog(log).frames():
            try:
                message = database.get_message_by_frame_id(frame.identifier)
            except KeyError:
                continue
            for name, value in message.decode(frame.data).items():
                values.setdefault((message.name, name), []).append((frame.time_s, value))
        return values

    def test_a_run_is_decoded_beside_its_log(self):
        before = {file.name for file in self.run_folder.iterdir()}
        said = self.logs("decode", self.run_folder)
        self.assertEqual({file.name for file in self.run_folder.iterdir()} - before, {"signals.mf4", "run.mcap"})
        self.assertIn(f"{self.original}: 304 Imu, ", said)
        self.assertIn("304 frames are not in the DBC file: 0x7F0", said)
        mdf, messages = asammdf.MDF(self.run_folder / "signals.mf4"), messages_of(self.run_folder / "run.mcap")
        expected = self.expected(self.original, OWN_DBC)
        groups = {group.channel_group.acq_name: index for index, group in enumerate(mdf.groups)}
        compared_texts = set()
        for (message, name), values in expected.items():
            signal = mdf.get(name, group=groups[message])
            topic = messages[f"/{message}"]
            self.assertEqual(len(signal.samples), len(values))
            self.assertEqual(len(topic), len(values))
            rows = zip(values, signal.samples.tolist(), signal.timestamps, topic)
            for (time_s, value), read, time_read, (log_time, fields) in rows:
                self.assertAlmostEqual(time_read, time_s, places=6)
                self.assertEqual(log_time, round(time_s * 1e6) * 1000)
                shown = getattr(fields, name)
                if isinstance(read, bytes):
                    compared_texts.add(str(value))
                    self.assertEqual((read.decode("utf-8"), shown), (str(value), str(value)), name)
                elif isinstance(value, (int, float)):
                    self.assertEqual((read, shown), (value, value), name)
                else:
                    self.assertTrue(math.isnan(read) and math.isnan(shown), name)
        self.assertLessEqual({"unavailable", "ready", "warning", "right", "none"}, compared_texts)
        self.assertEqual(mdf.get("RollRate", group=groups["Imu"]).unit, "deg/s")
        with (self.run_folder / "run.mcap").open("rb") as stream:
            channels = {channel.topic: channel for channel in make_reader(stream).get_summary().channels.values()}
        self.assertEqual(json.loads(channels["/Imu"].metadata["units"])["RollRate"], "deg/s")
        self.assertEqual(channels["/Imu"].message_encoding, "protobuf")

    def test_decoded_logs_do_not_outlive_their_run(self):
        folder = self.folder / "again"
        vehicle = support.PROJECT / "sil/vehicles/large_suv.toml"
        command = [self.program, "run", "j-turn-110", "--in-process", "--vehicle", vehicle, "--parameters", support.CALIBRATION,
                   "--output", folder]
        support.call(*command)
        self.logs("decode", folder)
        first = (folder / "run.mcap").read_bytes()
        self.logs("decode", folder)
        self.assertEqual((folder / "run.mcap").read_bytes(), first)
        finished = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, timeout=600)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertFalse((folder / "signals.mf4").exists() or (folder / "run.mcap").exists(), "they are of the earlier run")

    def test_foreign_logs_with_pages_and_calendar_times(self):
        start_s = 1_700_000_000.25
        frames = foreign_recorder.frames(self.run_folder, start_s)
        frames.append(frames[0]._replace(time_s=frames[-1].time_s + 0.01, data=frames[0].data[:3]))
        mdf, messages, _ = self.decoded(self.written("blf", frames), "--dbc", foreign_recorder.DBC)
        self.assertAlmostEqual(mdf.header.start_time.timestamp(), start_s, places=6)
        yaw = mdf.get("GierRate")
        self.assertEqual((len(yaw.samples), yaw.unit, yaw.timestamps[0]), (152, "\u00b0/s", 0.0))
        gear = mdf.get("GearSelector")
        self.assertEqual(set(gear.samples.tolist()), {b"D"})
        self.assertEqual({topic: len(found) for topic, found in messages.items()},
                         {"/ESP_Dynamics": 305, "/CLUSTER_3_Page_0": 152, "/CLUSTER_3_Page_1": 152, "/CLUSTER_3_Page_2": 61,
                          "/WHEELSPEED": 61, "/ATTITUDE": 304})
        self.assertEqual(messages["/WHEELSPEED"][0][0], 1_700_000_000_250_000_000)
        self.assertEqual(messages["/ESP_Dynamics"][0][1].QualityOfSensors, "Good")
        cut = messages["/ESP_Dynamics"][-1][1]
        self.assertEqual((cut.LatAcc_Raw, cut.QualityOfSensors, math.isnan(cut.VertAcc)), (0.0, "", True))

    def test_senders_and_like_names_stay_apart(self):
        dbc = self.folder / "alike.dbc"
        dbc.write_text('VERSION ""\nNS_ :\nBS_:\nBU_: N\nBO_ 5 M: 2 N\n SG_ Lat_Acc : 0|8@1+ (1,0) [0|0] "" N\n'
                       ' SG_ LatAcc : 8|8@1+ (1,0) [0|0] "" N\n', encoding="utf-8")
        log = self.folder / "alike.log"
        log.write_text("(0.000000) can0 005#0102\n(0.010000) can1 005#0304\n", encoding="ascii")
        mdf, messages, _ = self.decoded(log, "--dbc", dbc)
        self.assertEqual({topic: (found[0][1].Lat_Acc, found[0][1].LatAcc) for topic, found in messages.items()},
                         {"/M": (1.0, 2.0), "/M_on_bus_can1": (3.0, 4.0)})
        self.assertEqual([group.channel_group.acq_name for group in mdf.groups], ["M", "M_on_bus_can1"])
        log.write_text("(5.000000) can0 005#0102\n(0.010000) can0 005#0304\n", encoding="ascii")
        self.refused(f"{log}: the time runs back from 5.000000 s to 0.010000 s: ", "decode", log, "--dbc", dbc, "--output",
                     self.folder)

    def test_frames_of_the_parameter_group_stand_in_for_an_identifier_that_is_not_there(self):
        dbc = self.folder / "group.dbc"
        dbc.write_text('VERSION ""\nNS_ :\nBS_:\nBU_: N\n' + "".join(
            f'BO_ {identifier | 1 << 31} {name}: 1 N\n SG_ Of{name} : 0|8@1+ (1,0) [0|0] "" N\n'
            for identifier, name in ((0x18F00903, "Absent"), (0x18F00A03, "Present"))), encoding="utf-8")
        log = self.folder / "group.log"
        log.write_text("(0.0000000) can0 0CF00917#01\n(0.010000) can0 18F00A03#02\n(0.020000) can0 18F00A17#03\n"
                       "(0.030000) can0 109#04\n", encoding="ascii")
        _, messages, said = self.decoded(log, "--dbc", dbc)
        self.assertEqual({topic: len(found) for topic, found in messages.items()}, {"/Absent": 1, "/Present": 1})
        self.assertIn("no frame has the identifier 0x18F00903 of Absent: those of its J1939 parameter group 61449 are taken, from "
                      "source address 0x17", said)
        self.assertIn("2 frames are not in the DBC file: 0x109, 0x18F00A17", said)

    def test_overlapping_signals_are_decoded_one_by_one(self):
        dbc = self.folder / "overlaps.dbc"
        dbc.write_text('VERSION ""\nNS_ :\nBS_:\nBU_: N\nBO_ 5 M: 2 N\n SG_ Both : 0|16@1+ (1,0) [0|0] "" N\n'
                       ' SG_ Second : 8|8@1+ (1,0) [0|0] "" N\n SG_ Beyond : 12|8@1+ (1,0) [0|0] "" N\n', encoding="utf-8")
        log = self.folder / "overlaps.log"
        log.write_text("(0.000000) can0 005#0102\n", encoding="ascii")
        mdf, messages, _ = self.decoded(log, "--dbc", dbc)
        fields = messages["/M"][0][1]
        self.assertEqual((fields.Both, fields.Second, mdf.get("Both").samples[0]), (513.0, 2.0, 513.0))

    def test_errors_are_reported(self):
        self.refused(f"{self.original}: is no folder of a run, so say where the results go: --output DIR",
                     "decode", self.original)
        self.refused(f"{self.folder}: has no candump.log; ", "decode", self.folder)
        self.refused(f"{self.original}: has no frame that {foreign_recorder.DBC} knows; ", "decode", self.original, "--dbc",
                     foreign_recorder.DBC, "--output", self.folder / "none")
        self.assertEqual(list((self.folder / "none").iterdir()), [])
        log = self.folder / "run.mcap"
        log.write_bytes(self.original.read_bytes())
        self.refused(f"{log}: the result would take its place; ", "decode", log, "--output", self.folder)
        self.refused(f"{self.folder / 'none.blf'}: there is no such folder or log",
                     "decode", self.folder / "none.blf", "--output", self.folder)


if __name__ == "__main__":
    support.main()

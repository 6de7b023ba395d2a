"""A session of XCP with the ECU, by pyxcp and an A2L."""

import contextlib
import io
import logging
import struct
import time

import can
import key_file
import pyxcp.config
import pyxcp.master
import pyxcp.types
from a2l_objects import KINDS
from cryptography.hazmat.primitives.ciphers import algorithms
from cryptography.hazmat.primitives.cmac import CMAC
from log_error import LogError
from pyxcp.daq_stim import DaqList, DaqProcessor
from pyxcp.transport.base import FrameAcquisitionPolicy, FrameCategory

TEST_KEY = key_file.TEST_KEYS["calibration"]
CALIBRATION = 0x01  # the resource; measurement is unlocked with it
ECU, MASTER = 0x01, 0x02
WORKING, REFERENCE = 0, 1
LONGEST_CHANGE_S = 4.0  # of a vehicle; what it prepares takes two
STAMP_S = 1e-4
STAMPS = 65536
MEANINGS = {"ERR_ACCESS_LOCKED": "the key is wrong; after several wrong ones wait, longer each time",
            "ERR_RES_TEMP_NOT_ACCESS": "it does not answer now: a delay after wrong keys, or a memory that is busy",
            "ERR_PAGE_NOT_VALID": "the working page is refused", "ERR_ACCESS_DENIED": "it has no memory to store in"}


class Samples(FrameAcquisitionPolicy):
    """Keeps what is measured, frame by frame."""

    def __init__(self):
        super().__init__()
        self.frames, self.overloads = [], 0

    def feed(self, category, counter, timestamp, payload):
        if category == FrameCategory.DAQ:
            self.frames.append(bytes(payload))
        elif category == FrameCategory.EVENT and len(payload) > 0 and payload[0] == 0x06:
            self.overloads += 1

    def finalize(self):
        pass


class Session:
    """Connected and unlocked within its `with` block. `interface`: python-can's name of a channel, or a bus."""

    def __init__(self, a2l, interface, key=TEST_KEY):
        self.a2l, self.key, self.samples = a2l, key, Samples()
        can = {"can_id_master": a2l.command_identifier, "can_id_slave": a2l.answer_identifier}
        bus = None if isinstance(interface, str) else interface
        if bus is None:
            can |= {"interface": "socketcan", "channel": interface, "bitrate": 500000}
        application = pyxcp.config.create_application_from_config({"Transport": {"CAN": can}}, log_level=logging.CRITICAL)
        application.general.disable_error_handling = True  # it would end the process at a refusal
        application.transport.timeout = 2.0
        logging.disable(logging.CRITICAL)
        pyxcp.config.set_application(application)
        self.xcp = pyxcp.master.Master("can", config=application, policy=self.samples, transport_layer_interface=bus)

    def __enter__(self):
        try:
            with contextlib.redirect_stdout(io.StringIO()):  # pyxcp's thoughts about the interface
                self.xcp.__enter__()
        except can.CanError as error:
            raise LogError(f"the interface cannot be used: {error}; --interface names another, --in-process needs none") from None
        try:
            self.xcp.connect()
        except pyxcp.types.XcpTimeoutError:
            raise LogError("no answer to CONNECT: is the ECU on this interface, does it answer XCP (rsi-ecu --xcp)?") from None
        self.xcp.setMta(self.a2l.epk_at)
        epk = self.xcp.fetch(len(self.a2l.epk)).decode(errors="replace")
        if epk != self.a2l.epk:
            raise LogError(f"the A2L is of another version: it says \"{self.a2l.epk}\", the ECU \"{epk}\"")
        return self

    def __exit__(self, *_):
        try:
            self.xcp.disconnect()
        except pyxcp.types.XcpTimeoutError:
            pass  # it has gone; there is nothing to end
        self.xcp.close()

    def unlock(self):
        """pyxcp's own cond_unlock stops after twelve bytes of a seed."""
        answer = self.asked(self.xcp.getSeed, 0, CALIBRATION)
        seed = bytes(answer.seed)
        while len(seed) < 16:
            seed += bytes(self.asked(self.xcp.getSeed, 1, CALIBRATION).seed)
        code = CMAC(algorithms.AES(self.key))
        code.update(seed)
        key = code.finalize()
        for at in range(0, 16, 6):
            self.asked(self.xcp.unlock, 16 - at, key[at:at + 6])

    def asked(self, command, *arguments):
        """Its answer; a refusal as LogError."""
        try:
            return command(*arguments)
        except pyxcp.types.XcpResponseError as error:
            name = str(error.args[0]) if error.args else str(error)
            raise LogError(f"the ECU refuses {command.__name__}: {name}: {MEANINGS.get(name, 'see the standard')}") from None

    def object(self, name):
        if name not in self.a2l.objects:
            raise LogError(f"the A2L has no {name}")
        return self.a2l.objects[name]

    def read(self, name):
        entry = self.object(name)
        return entry.decoded(self.xcp.shortUpload(struct.calcsize(entry.form), entry.address))

    def show(self, page):
        """Which page read() reads."""
        self.asked(self.xcp.setCalPage, MASTER, 0, page)

    def encoded(self, name, text):
        entry = self.object(name)
        if not entry.is_parameter:
            raise LogError(f"{name} is an output; it cannot be written")
        return entry.encoded(text)

    def download(self, words):
        """Bytes by the names of parameters."""
        for name, data in words.items():
            self.xcp.setMta(self.object(name).address)
            self.asked(self.xcp.download, data)

    def write(self, changes):
        """Several are taken over at once: in between the ECU works with the reference page. The previous values."""
        words = {name: self.encoded(name, text) for name, text in changes.items()}
        before = {name: self.read(name) for name in changes}
        if self.asked(self.xcp.getCalPage, ECU, 0) != WORKING:
            raise LogError("the ECU works with the reference page, where nothing is written; `calibrate use working` selects the other")
        single = len(changes) == 1
        try:
            if not single:
                self.asked(self.xcp.setCalPage, ECU, 0, REFERENCE)
            self.download(words)
            refused = self.taken_over(single)
        except BaseException:  # after any exception, an interrupt too: not with half of the values, nor on the other page
            self.put_back(before, single)
            raise
        if refused != "none":
            self.put_back(before, single)
            raise LogError(f"refused for {refused}; all values are as they were. Its range: firmware/rsi/parameters.hpp")
        end = time.monotonic() + LONGEST_CHANGE_S
        while self.read("change_pending") == "yes":
            if time.monotonic() > end:
                raise LogError("the change is not taken over; does the ECU run?")
        return before

    def taken_over(self, single):
        """The field that is refused, or none."""
        try:
            if not single:
                self.xcp.setCalPage(ECU, 0, WORKING)
        except pyxcp.types.XcpResponseError:
            pass  # the page is refused: the field is named below
        return self.read("refused_parameter")

    def put_back(self, before, single):
        self.download({name: self.encoded(name, str(value)) for name, value in before.items()})
        if not single:
            self.asked(self.xcp.setCalPage, ECU, 0, WORKING)

    def use(self, page):
        """`working` or `reference`: the ECU works with it."""
        self.asked(self.xcp.setCalPage, ECU, 0, REFERENCE if page == "reference" else WORKING)

    def reset(self):
        self.asked(self.xcp.copyCalPage, 0, REFERENCE, 0, WORKING)

    def store(self):
        self.asked(self.xcp.setRequest, 0x01, 0)

    def differences(self):
        """Differences of the working page from the reference page: name to both values."""
        parameters = [name for name, entry in self.a2l.objects.items() if entry.is_parameter]
        working = {name: self.read(name) for name in parameters}
        self.show(REFERENCE)
        reference = {name: self.read(name) for name in parameters}
        self.show(WORKING)
        return {name: (reference[name], working[name]) for name in parameters if reference[name] != working[name]}

    def measure(self, names, wait):
        """Calls `wait` while it measures; times in seconds and a list of values for each name. Only whole samples count."""
        entries = [self.object(name) for name in names]
        lists = [DaqList(name="all", event_num=0, stim=False, enable_timestamps=True, priority=0, prescaler=1,
                         measurements=[(entry.name, entry.address, 0, KINDS[entry.form]) for entry in entries])]
        processor = DaqProcessor(lists)
        processor.xcp_master = self.xcp
        processor.set_parameters = lambda _parameters: None
        self.asked(processor.setup)
        self.samples.frames, self.samples.overloads = [], 0
        self.asked(processor.start)
        wait()
        self.asked(processor.stop)
        return self._assembled(entries, lists[0].measurements_opt)

    def _assembled(self, entries, parts):
        """From frames to samples. pyxcp joins neighbours into one entry, so a value is found by its address."""
        places = {}
        for number, part in enumerate(parts):
            at = 1 + (2 if number == 0 else 0)
            for entry in part.entries:
                for byte in range(entry.length):
                    places[entry.address + byte] = (number, at + byte)
                at += entry.length
        times, columns, sample, clock, last = [], {entry.name: [] for entry in entries}, {}, 0, None
        for frame in self.samples.frames:
            if frame[0] == 0:
                sample = {}
            sample[frame[0]] = frame
            if len(sample) < len(parts) or frame[0] != len(parts) - 1:
                continue
            stamp, = struct.unpack("<H", sample[0][1:3])
            clock += 0 if last is None else (stamp - last) % STAMPS
            last = stamp
            times.append(clock * STAMP_S)
            for entry in entries:
                data = bytearray()
                for byte in range(struct.calcsize(entry.form)):
                    number, at = places[entry.address + byte]
                    data.append(sample[number][at])
                columns[entry.name].append(entry.number(bytes(data)))
        return times, columns

"""Writes decoded signals, group by group: as an MF4, and as an MCAP that Foxglove, PlotJuggler and Rerun open."""

import datetime
import json
import re

import numpy
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from mcap.writer import CompressionType, Writer

from bus_log_writers import FIRST_CALENDAR_TIME_S, RECORDS

DIGITS = 24  # bytes of a number that has no text


class Mf4Writer:
    """Every group of signals with a clock of its own. A text is a channel of texts, a missing number NaN."""

    def __init__(self, file):
        import asammdf  # takes a second, and others do not need it

        self._signal, self._file = asammdf.Signal, file
        self._mdf = asammdf.MDF(version="4.10")
        self._groups = {}
        self._start_us = None

    def take(self, group, time_us, values, signals):
        if self._start_us is None:
            is_calendar = time_us >= FIRST_CALENDAR_TIME_S * 1_000_000
            self._start_us = time_us if is_calendar else 0
            epoch = datetime.datetime.fromtimestamp(0, datetime.timezone.utc)
            self._mdf.header.start_time = epoch + datetime.timedelta(microseconds=self._start_us)
        if group not in self._groups:
            self._groups[group] = {"index": None, "rows": [], "names": list(values), "signals": signals}
        rows = self._groups[group]["rows"]
        rows.append((time_us, values))
        if len(rows) == RECORDS:
            self._add(group)

    def _add(self, name):
        group = self._groups[name]
        times = numpy.array([time_us - self._start_us for time_us, _ in group["rows"]]) / 1.0e6
        columns = [self._column([values[signal] for _, values in group["rows"]], group["signals"][signal])
                   for signal in group["names"]]
        if group["index"] is None:
            group["index"] = len(self._mdf.groups)
            self._mdf.append([self._signal(column, times, name=signal, unit=self._unit(group, signal, column), encoding="utf-8",
                                           comment=self._comment(group, signal))
                              for signal, column in zip(group["names"], columns)], acq_name=name, comment=name)
        else:
            self._mdf.extend(group["index"], [(times, None)] + [(column, None) for column in columns])
        group["rows"] = []

    @staticmethod
    def _unit(group, signal, column):
        return "" if column.dtype.kind == "S" else (group["signals"][signal].unit or "").strip("-")

    @staticmethod
    def _comment(group, signal):
        return " ".join((group["signals"][signal].comment or "").split())

    @staticmethod
    def _column(values, signal):
        if isinstance(values[0], str):
            longest = max([DIGITS] + [len(str(text).encode("utf-8")) for text in signal.choices.values()])
            return numpy.array([value.encode("utf-8") for value in values], dtype=f"S{longest}")
        return numpy.array(values, dtype="f8")

    def finish(self):
        for name, group in self._groups.items():
            if group["rows"]:
                self._add(name)
        self._mdf.save(self._file, compression=2)
        self._mdf.close()


class McapWriter:
    """A topic for every group. Messages are protobuf: of the encodings that describe themselves, the one that all three read."""

    def __init__(self, file):
        self._writer = Writer(file, compression=CompressionType.ZSTD)
        self._writer.start(profile="", library="sil/tools/logs")
        self._topics = {}
        self._pool = descriptor_pool.DescriptorPool()

    def take(self, group, time_us, values, signals):
        if group not in self._topics:
            self._topics[group] = self._topic(group, values, signals)
        channel, kind = self._topics[group]
        message = kind(**{field_name(name): value for name, value in values.items()})
        self._writer.add_message(channel, log_time=time_us * 1000, publish_time=time_us * 1000, data=message.SerializeToString())

    def _topic(self, group, values, signals):
        identifier = re.sub(r"\W", "_", group)
        file = descriptor_pb2.FileDescriptorProto(name=f"{identifier}.proto", package="can", syntax="proto3")
        description = file.message_type.add(name=identifier)
        kinds = descriptor_pb2.FieldDescriptorProto
        for number, (name, value) in enumerate(values.items(), 1):
            description.field.add(name=field_name(name), json_name=name, number=number, label=kinds.LABEL_OPTIONAL,
                                  type=kinds.TYPE_STRING if isinstance(value, str) else kinds.TYPE_DOUBLE)
        self._pool.Add(file)
        schema = self._writer.register_schema(name=f"can.{identifier}", encoding="protobuf",
                                              data=descriptor_pb2.FileDescriptorSet(file=[file]).SerializeToString())
        units = {name: signals[name].unit for name in values if signals[name].unit}
        channel = self._writer.register_channel(topic=f"/{identifier}", message_encoding="protobuf", schema_id=schema,
                                                metadata={"units": json.dumps(units, ensure_ascii=False)})
        return channel, message_factory.GetMessageClass(self._pool.FindMessageTypeByName(f"can.{identifier}"))

    def finish(self):
        self._writer.finish()


def field_name(name):
    return re.sub(r"\W", "_", name)

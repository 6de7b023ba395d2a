"""Calibrations, the component, and its answers to a time series."""

from __future__ import annotations

import ctypes
import os
import pathlib
import typing
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from . import interface, judge, rows
from .refused import Refused

if typing.TYPE_CHECKING:
    from .truth import Truth

_SHIPPED = pathlib.Path(__file__).resolve().parent / "calibrations"
CALIBRATIONS: list[str] = sorted(path.stem for path in _SHIPPED.glob("*.toml"))
"""Names of the calibrations that come with the package: those of the project's simulated vehicles."""

NEEDED = ("lateral_specific_force_mps2", "roll_rate_radps")
STATES = ("unavailable", "ready", "advisory", "warning")
SIDES = ("none", "left", "right")
_ROOM = 4096  # for a refusal


def version() -> str:
    """Version of the component."""
    return interface.version()


def inputs() -> dict[str, str]:
    """Inputs of the component, with their meanings. `run` needs lateral_specific_force_mps2 and roll_rate_radps."""
    return dict(interface.fields(interface.INPUT))


def outputs() -> dict[str, str]:
    """Outputs of the component, with units and meanings: codes (int32) and numbers (float32)."""
    return interface.fields(interface.CODE) | interface.fields(interface.NUMBER)


def indices() -> dict[str, str]:
    """Indices under their names in a calibration's `warning_indicator`, with the output that each reads."""
    return dict(interface.fields(interface.INDEX))


def parameters() -> list[str]:
    """Names of a calibration's parameters."""
    return list(interface.parameters().names or ())


class Calibration(Mapping[str, "float | str"]):
    """Parameters of the component: accepted, and not to be changed. A mapping of their names to numbers and words."""

    def __init__(self, values: npt.NDArray[np.void], name: str) -> None:
        self._values = values
        self.name = name

    @classmethod
    def load(cls, source: str | os.PathLike[str], **changes: float | str) -> Calibration:
        """Reads a calibration file of the project (TOML), or one of CALIBRATIONS by its name.

        `changes`: values in place of the file's, such as `warning_on=1.05` or `warning_indicator="published"`.
        Raises Refused, with file, line and field, for what the component would refuse.
        """
        path = pathlib.Path(source)
        if path.suffix == "" and len(path.parts) == 1 and not path.exists():
            rows.known("calibration", str(source), CALIBRATIONS)
            path = _SHIPPED / f"{source}.toml"
        texts = [f"{name}={value}" for name, value in changes.items()]
        values, refusal = np.zeros(1, interface.parameters()), ctypes.create_string_buffer(_ROOM)
        words = (ctypes.c_char_p * len(texts))(*(text.encode() for text in texts))
        if not interface.library().component_load(
            os.fsencode(path), len(texts), words, values.ctypes.data, refusal, _ROOM
        ):
            raise Refused(refusal.value.decode(errors="replace"))
        return cls(values, path.stem)

    @property
    def address(self) -> int:
        return self._values.ctypes.data

    def __getitem__(self, name: str) -> float | str:
        if name not in parameters():
            raise KeyError(name)
        value = self._values[name][0]
        choices = interface.fields(interface.SELECTION).get(name)
        return float(value) if choices is None else choices.split(", ")[value]

    def __iter__(self) -> typing.Iterator[str]:
        return iter(parameters())

    def __len__(self) -> int:
        return len(parameters())

    def __repr__(self) -> str:
        return f"<Calibration {self.name}>"


class Score(typing.NamedTuple):
    """Largest thresholds, powers of 1.01, at which an index warns of a drive; 0: at none.

    With two-wheel lift-off: with the falling side, in force as it happens, and 0.1 s and 0.2 s before. Without: at all.
    """

    threshold: float
    threshold_100ms: float
    threshold_200ms: float
    lead_s: float | None  # with the threshold at 1


class Run:
    """Answers of the component to a time series of n rows.

    time_s:      float64, shape (n,)
    outputs:     structured, shape (n,), a field for each of rsi.outputs(); outputs["rsi"] is float32 of shape (n,)
    calibration: of the component
    """

    def __init__(
        self,
        calibration: Calibration,
        time_s: npt.NDArray[np.float64],
        answers: npt.NDArray[np.void],
        risks: npt.NDArray[np.void],
    ) -> None:
        self.calibration = calibration
        self.time_s = time_s
        self.outputs = answers
        self._risks = risks

    def __len__(self) -> int:
        return len(self.time_s)

    def __getitem__(self, output: str) -> npt.NDArray[typing.Any]:
        """An output, shape (n,): float32, or int32 of a code."""
        rows.known("output", output, outputs())
        return self.outputs[output]

    def states(self) -> npt.NDArray[np.str_]:
        """State of the warning in words, shape (n,): "unavailable", "ready", "advisory", "warning"."""
        return np.take(np.array(STATES), self["state"])

    def sides(self) -> npt.NDArray[np.str_]:
        """Side that the warning names, shape (n,): "none", "left", "right"."""
        return np.take(np.array(SIDES), self["side"])

    def level(self, index: str) -> npt.NDArray[np.float32]:
        """Level of one of rsi.indices(), float32 of shape (n,): 0 without risk, 1 where it says "warn", NaN: none."""
        return typing.cast("npt.NDArray[np.float32]", self._risks["level"][:, _place(index)])

    def judge(self, truth: Truth) -> judge.Judgement:
        """Judges the component's own warning, by the rules of the simulation and of replayed drives."""
        truth.belongs_to(self.time_s)
        return judge.judgement(
            self.time_s,
            self["state"].copy(),
            self["side"].copy(),
            truth.load_transfer_ratio,
            truth.two_wheel_lift_s,
            truth.falling_side,
        )

    def score(self, index: str, truth: Truth) -> Score:
        """Largest thresholds at which an index, behind the component's own warning states, warns of this drive."""
        truth.belongs_to(self.time_s)
        found = interface.library().component_index_score(
            self._course(index), truth.lift_s_or_nan, judge.SIDES[truth.falling_side]
        )
        return Score(
            found.threshold,
            found.threshold_100ms,
            found.threshold_200ms,
            None if np.isnan(found.lead_s) else found.lead_s,
        )

    def lead_s(self, index: str, threshold: float, truth: Truth) -> float | None:
        """Lead of such a warning over two-wheel lift-off, in s; None: it does not warn, or nothing lifts."""
        truth.belongs_to(self.time_s)
        lead_s = interface.library().component_index_lead_s(
            self._course(index), threshold, truth.lift_s_or_nan, judge.SIDES[truth.falling_side]
        )
        return None if np.isnan(lead_s) else float(lead_s)

    def alarms(self, index: str, threshold: float) -> bool:
        """Whether such a warning begins at all."""
        return bool(interface.library().component_index_alarms(self._course(index), threshold))

    def alarm_threshold(self, index: str) -> float:
        """The largest threshold at which it does; 0: at none."""
        return float(interface.library().component_alarm_threshold(self._course(index)))

    def _course(self, index: str) -> interface.Course:
        return interface.Course(
            self.calibration.address, len(self), self.time_s.ctypes.data, self._risks.ctypes.data, _place(index)
        )


def _samples(series: Mapping[str, npt.ArrayLike], count: int) -> npt.NDArray[np.void]:
    samples = np.empty(count, interface.inputs())
    for name in series:
        rows.known("input", name, inputs())
    for name in inputs():
        with np.errstate(over="ignore"):  # infinite: not available, as for the firmware
            samples[name] = rows.series(name, series[name], count) if name in series else np.nan
    return samples


def _place(index: str) -> int:
    rows.known("index", index, indices())
    return list(indices()).index(index)


class Component:
    """One component, stepped every 10 ms. It keeps what it has learnt from one call to the next."""

    def __init__(self, calibration: Calibration) -> None:
        self.calibration = calibration
        self._storage = np.zeros(interface.size_of_component() // 8 + 1, np.uint64)
        self.reset()

    def reset(self) -> None:
        """Forgets everything."""
        interface.library().component_start(self._storage.ctypes.data, self.calibration.address)

    def step(self, **values: float) -> dict[str, float | int]:
        """One step of 10 ms. `values`: of rsi.inputs(); one that is left out is not available. Returns all outputs."""
        samples = _samples({name: [value] for name, value in values.items()}, 1)
        answer = self._steps(samples)[0][0]
        return {name: answer[name].item() for name in outputs()}

    def run(self, time_s: npt.ArrayLike, **series: npt.ArrayLike) -> Run:
        """Steps through a time series; goes on from the step before.

        time_s: shape (n,), rows 0.01 s apart. `series`: of rsi.inputs(), each of shape (n,); one that is left out is
        not available. Raises Refused for another rate, and says how to resample: nothing is resampled here.
        """
        times = rows.times(time_s)
        samples = _samples(series, len(times))
        missing = [name for name in NEEDED if name not in series]
        if missing:
            raise Refused(
                f"{missing[0]} is missing: without it the component is unavailable; give it, NaN where it is not known"
            )
        answers, risks = self._steps(samples)
        return Run(self.calibration, times, answers, risks)

    def _steps(self, samples: npt.NDArray[np.void]) -> tuple[npt.NDArray[np.void], npt.NDArray[np.void]]:
        answers = np.zeros(len(samples), interface.outputs())
        risks = np.zeros((len(samples), len(indices())), interface.RISK)
        interface.library().component_steps(
            self._storage.ctypes.data,
            self.calibration.address,
            len(samples),
            samples.ctypes.data,
            answers.ctypes.data,
            risks.ctypes.data,
        )
        return answers, risks


def run(calibration: Calibration, time_s: npt.ArrayLike, **series: npt.ArrayLike) -> Run:
    """A time series through a component that starts with it; as Component.run."""
    return Component(calibration).run(time_s, **series)

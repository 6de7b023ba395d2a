"""Learns the weights of the firmware's linear forecast from driven runs and writes them as its header.

Use: weights.py PROGRAM CHOSEN HEADER

CHOSEN is a folder of a campaign with traces, of the half that is chosen on; only its true load transfers and the sensors'
signals are used, not what the firmware predicts. Called by sil/studies/predictors/run --weights.
"""

import pathlib
import sys

import numpy as np

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path += [str(PROJECT / folder) for folder in ("sil/judge", "sil/page", "cmake/environment")]

import judge  # noqa: E402
import learners  # noqa: E402
import recorded_runs  # noqa: E402
import file_io  # noqa: E402

HEADER = """// Written by sil/studies/predictors/run --weights; do not edit.
#pragma once

#include <array>

namespace rsi {{

// A row for each signal, as in ForecastMatrix, a number for each lag.
inline constexpr std::array<std::array<float, {lags}>, {rows}> forecast_weights{{{{
{lines}
}}}};

}}  // namespace rsi
"""
LAGS = 3


def header(weights):
    rows = [weights[k:k + LAGS] for k in range(0, len(weights), LAGS)]
    lines = ["    {{" + ", ".join(f"{weight:.3f}F" for weight in row) + "}}," for row in rows]
    return HEADER.format(rows=len(rows), lags=LAGS, lines="\n".join(lines))


def main(arguments):
    program, chosen, path = map(pathlib.Path, arguments)
    judge.use(program)
    forecast = learners.learned(learners.FORECAST, recorded_runs.load(chosen))
    file_io.write(path, header(np.asarray(forecast.weights())))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""Pictures of a drive for a page: its path beside its lateral acceleration, as SVG with the colours of sil/page/style.css."""

import html
import math
import pathlib
import re

import numpy

STYLE = pathlib.Path(__file__).resolve().parents[1] / "page/style.css"
WIDTH, HEIGHT = 480, 240  # each, in its own units
LEFT, RIGHT, TOP, BOTTOM = 40, 10, 10, 24
MOST_POINTS = 500
MOST_TICKS = 7
SQUARE = 5


def colours():
    """The palette of all pages, light and dark, as style rules."""
    light, dark = re.findall(r":root[^{]*\{([^}]*)\}", STYLE.read_text(encoding="utf-8"))[:2]
    return f":root {{{light}}}\n@media (prefers-color-scheme: dark) {{ :root {{{dark}}} }}"


def ticks(low, high):
    """Round numbers within a range."""
    rough = (high - low) / MOST_TICKS
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(each * power for each in (1.0, 2.0, 5.0, 10.0) if each * power >= rough)
    return [count * step for count in range(math.ceil(low / step), math.floor(high / step) + 1)]


def path(drive):
    """Metres to the right and ahead of the first row, row by row, and the seconds for which they are not known; None without
    speed or yaw rate."""
    if "speed" not in drive.columns or "yaw_rate" not in drive.columns:
        return None
    speed_mps, yaw_radps = drive.columns["speed"] / 3.6, numpy.radians(drive.columns["yaw_rate"])
    step_s = numpy.diff(drive.times_us, prepend=drive.times_us[0]) / 1.0e6
    is_known = numpy.isfinite(speed_mps) & numpy.isfinite(yaw_radps)
    heading = numpy.cumsum(numpy.where(is_known, yaw_radps, 0.0) * step_s)
    gone_m = numpy.where(is_known, speed_mps, 0.0) * step_s
    return numpy.cumsum(-numpy.sin(heading) * gone_m), numpy.cumsum(numpy.cos(heading) * gone_m), float(step_s[~is_known].sum())


def line(points, colour, width=2):
    """Pieces of a line, each a list of points."""
    parts = "".join("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in piece) for piece in points if len(piece) > 1)
    return f'<path d="{parts}" fill="none" stroke="var({colour})" stroke-width="{width}" stroke-linejoin="round"/>'


def text(x, y, words, anchor="middle"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{html.escape(words)}</text>'


def figure(words, drawn):
    return (f'<figure><svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html.escape(words)}">{"".join(drawn)}</svg>'
            f"<figcaption>{html.escape(words)}</figcaption></figure>")


def square(x, y):
    return f'<rect x="{x - SQUARE:.1f}" y="{y - SQUARE:.1f}" width="{2 * SQUARE}" height="{2 * SQUARE}" fill="var(--vermilion)"/>'


def path_picture(drive, warnings):
    driven = path(drive)
    if driven is None:
        return "<figure><figcaption>No path: the log has no speed, or no yaw rate.</figcaption></figure>"
    across, ahead, unknown_s = driven
    shown = numpy.unique(numpy.linspace(0, len(across) - 1, MOST_POINTS).astype(int))
    size = max(float(numpy.ptp(ahead)) / (WIDTH - LEFT - RIGHT), float(numpy.ptp(across)) / (HEIGHT - TOP - BOTTOM), 0.01)
    centre = [(float(each.max()) + float(each.min())) / 2.0 for each in (across, ahead)]

    def place(row):
        return WIDTH / 2.0 + (ahead[row] - centre[1]) / size, (HEIGHT - BOTTOM + TOP) / 2.0 + (across[row] - centre[0]) / size

    bar_m = ticks(0.0, size * WIDTH / 3.0)[-1]
    low = HEIGHT - 8
    drawn = [line([[place(row) for row in shown]], "--blue"), line([[(LEFT, low), (LEFT + bar_m / size, low)]], "--quiet", 3),
             text(LEFT + bar_m / size + 6, low + 4, f"{bar_m:g} m", "start")]
    x, y = place(0)
    drawn.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="var(--green)"/>')
    drawn += [square(*place(min(int(numpy.searchsorted(drive.times_us, 1.0e6 * float(time_s))), len(across) - 1)))
              for time_s, _ in warnings]
    return figure("Path by speed and yaw rate, from the dot to the right: a left turn goes up"
                  + ("; squares: warnings" if warnings else "")
                  + (f"; without {unknown_s:.1f} s that are not known" if unknown_s else ""), drawn)


def envelope(times_s, values):
    """Pieces of a line through the least and the largest value of each share of the rows; gaps stay gaps."""
    pieces, piece = [], []
    for rows in numpy.array_split(numpy.arange(len(values)), min(MOST_POINTS, len(values))):
        known = rows[numpy.isfinite(values[rows])]
        if len(known) == 0:
            pieces.append(piece)
            piece = []
            continue
        ends = sorted({int(known[numpy.argmin(values[known])]), int(known[numpy.argmax(values[known])])})
        piece += [(times_s[row], values[row]) for row in ends]
    return [*pieces, piece]


def acceleration_picture(drive, warnings):
    times_s, values = drive.times_us / 1.0e6, drive.columns["lateral_acceleration"]
    size = max(1.0, float(numpy.nanmax(numpy.abs(values), initial=0.0))) * 1.05
    first_s, length_s = float(times_s[0]), max(float(times_s[-1] - times_s[0]), 0.01)

    def place(time_s, value):
        return (LEFT + (time_s - first_s) / length_s * (WIDTH - LEFT - RIGHT),
                TOP + (size - value) / (2.0 * size) * (HEIGHT - TOP - BOTTOM))

    drawn = []
    for value in ticks(-size, size):
        x, y = place(first_s, value)
        drawn += [line([[(x, y), (WIDTH - RIGHT, y)]], "--grid" if value else "--line", 1), text(x - 5, y + 4, f"{value:g}", "end")]
    for time_s in ticks(first_s, first_s + length_s):
        drawn.append(text(place(time_s, 0.0)[0], HEIGHT - 6, f"{time_s:g}"))
    drawn += [line([[place(float(time_s), size), place(float(time_s), -size)]], "--vermilion", 1.6) for time_s, _ in warnings]
    drawn.append(line([[place(*point) for point in piece] for piece in envelope(times_s, values)], "--sky", 1.5))
    return figure("Lateral acceleration [m/s\u00b2] over time [s]: of a left turn above zero"
                  + ("; upright: warnings" if warnings else ""), drawn)


def pictures(drive, warnings):
    """`warnings`: time and side of each."""
    return f'<div class="pictures">{path_picture(drive, warnings)}{acceleration_picture(drive, warnings)}</div>'

"""The parts of docs/reports/validation.md about estimators and observer, from what roll_centre_table and observer_table print."""

import csv
import io
import statistics

LIMIT_ROLL_DEG = 0.3
LIMIT_BANK_DEG = 1.0


def _vehicles(path):
    """Vehicle, and the lines of its table."""
    found = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("|"):
            found[-1][1].append(line)
        elif line.startswith(("large_suv", "ordinary_suv", "van")):
            found.append((line.partition(":")[0], []))
    return found


def _rows(lines):
    """Cells of the rows below the head."""
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def _numbers(cell):
    return [float(number) for number in cell.split(" / ")]


def _data(found, parts):
    """All rows as one CSV text, with the vehicle. `parts`: what the numbers of a cell that holds several are for."""
    head = [cell.strip() for cell in found[0][1][0].strip("|").split("|")]
    first = _rows(found[0][1])[0]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["vehicle", *(f"{name}, {part}" if " / " in cell else name for name, cell in zip(head, first)
                                  for part in (parts if " / " in cell else [""]))])
    for vehicle, lines in found:
        writer.writerows([vehicle, *(number for cell in row for number in cell.split(" / "))] for row in _rows(lines))
    return text.getvalue()


def _summary(found, columns):
    """Median and largest of each column, by vehicle. `columns`: heading, decimals, and how it reads a row."""
    lines = [f"| median, largest of all manoeuvres | {' | '.join(heading for heading, _, _ in columns)} |",
             "|---" * (len(columns) + 1) + "|"]
    for vehicle, of_vehicle in found:
        cells = []
        for _, decimals, read in columns:
            values = [read(row) for row in _rows(of_vehicle)]
            cells.append(f"{statistics.median(values):.{decimals}f}, {max(values):.{decimals}f}")
        lines.append(f"| {vehicle} | {' | '.join(cells)} |")
    return "\n".join(lines)


def _number(column, part=0):
    return lambda row: _numbers(row[column])[part]


def estimator(path):
    """The page's part, and the data file."""
    found = _vehicles(path)
    turns, worse = [], []
    for vehicle, lines in found:
        for name, _, constant, _, _, second, *_ in _rows(lines):
            constant_mm, second_mm = float(constant), _numbers(second)
            if name == "j-turn-45":
                turns.append(f"{vehicle} {second_mm[1]:.1f} of {constant_mm:.1f} mm")
            if second_mm[2] > 1.1 * constant_mm:
                worse.append(f"{vehicle} {name} ({second_mm[2]:.1f} for {constant_mm:.1f} mm)")
    words = (
        "Aimed at: at most half of the constant's error in the J-turn at 45 km/h with 0.005 g bias; reached: " + ", ".join(turns)
        + ". And nowhere worse than the constant by more than 10 % with 0.03 g bias; it is worse in: " + (", ".join(worse) or "none") + "."
    )
    columns = [("constant, mm", 1, _number(2)), ("published, 0.99", 1, _number(3, 1)), ("published, 0.999", 1, _number(4, 1)),
               ("consider-Kalman", 1, _number(5, 1)), ("roll, published, deg", 2, _number(7, 1)),
               ("roll, consider-Kalman", 2, _number(8, 1))]
    return f"{words}\n\n{_summary(found, columns)}", _data(found, ("0 g", "0.005 g", "0.03 g"))


def observer(path):
    """The page's part, and the data file."""
    found = _vehicles(path)
    beyond = [
        f"{vehicle} {name} ({roll}, {bank})"
        for vehicle, lines in found
        for name, roll, bank, _ in _rows(lines)
        if float(roll) > LIMIT_ROLL_DEG or float(bank) > LIMIT_BANK_DEG
    ]
    words = (f"Aimed at: roll within {LIMIT_ROLL_DEG} deg and bank within {LIMIT_BANK_DEG:g} deg. Beyond it (roll, bank): "
             + (", ".join(beyond) or "none") + ".")
    columns = [("roll, deg", 2, _number(1)), ("bank, deg", 2, _number(2)), ("roll, K 10 % low", 2, _number(3)),
               ("roll, K 10 % high", 2, _number(3, 1))]
    return f"{words}\n\n{_summary(found, columns)}", _data(found, ("low", "high"))

"""The parts of docs/reports/validation.md about estimators and observer, from what roll_centre_table and observer_table print."""

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


def _text(found):
    return "\n\n".join(f"**{vehicle}**\n\n" + "\n".join(lines) for vehicle, lines in found)


def estimator(path):
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
    return f"{words}\n\n{_text(found)}"


def observer(path):
    found = _vehicles(path)
    beyond = [
        f"{vehicle} {name} ({roll}, {bank})"
        for vehicle, lines in found
        for name, roll, bank, _ in _rows(lines)
        if float(roll) > LIMIT_ROLL_DEG or float(bank) > LIMIT_BANK_DEG
    ]
    words = (f"Aimed at: roll within {LIMIT_ROLL_DEG} deg and bank within {LIMIT_BANK_DEG:g} deg. Beyond it (roll, bank): "
             + (", ".join(beyond) or "none") + ".")
    return f"{words}\n\n{_text(found)}"

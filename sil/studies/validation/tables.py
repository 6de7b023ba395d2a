"""The parts of docs/reports/validation.md about estimators and observer, from what roll_centre_table and observer_table print."""

import statistics

import markdown

LIMIT_ROLL_DEG = 0.3
LIMIT_BANK_DEG = 1.0


def _summary(rows, columns):
    """Median and largest of each column, by vehicle. `columns`: by heading, the name in the data."""
    lines = []
    for vehicle in dict.fromkeys(row["vehicle"] for row in rows):
        cells = []
        for name in columns.values():
            texts = [row[name] for row in rows if row["vehicle"] == vehicle]
            values = [float(text) for text in texts]
            decimals = len(texts[0].partition(".")[2])
            cells.append(f"{statistics.median(values):.{decimals}f}, {max(values):.{decimals}f}")
        lines.append([vehicle, *cells])
    return markdown.table(["median, largest of all manoeuvres", *columns], lines)


def estimator(rows):
    turns, worse = [], []
    for row in rows:
        constant_mm = float(row["constant"])
        low_mm, high_mm = (float(row[f"consider-Kalman, {bias} g"]) for bias in ("0.005", "0.03"))
        if row["manoeuvre"] == "j-turn-45":
            turns.append(f"{row['vehicle']} {low_mm:.1f} of {constant_mm:.1f} mm")
        if high_mm > 1.1 * constant_mm:
            worse.append(f"{row['vehicle']} {row['manoeuvre']} ({high_mm:.1f} for {constant_mm:.1f} mm)")
    words = (
        "Aimed at: at most half of the constant's error in the J-turn at 45 km/h with 0.005 g bias; reached: " + ", ".join(turns)
        + ". And nowhere worse than the constant by more than 10 % with 0.03 g bias; it is worse in: " + (", ".join(worse) or "none") + "."
    )
    columns = {"constant, mm": "constant", "published, 0.99": "published, 0.99, 0.005 g",
               "published, 0.999": "published, 0.999, 0.005 g", "consider-Kalman": "consider-Kalman, 0.005 g",
               "roll, published, deg": "roll, published, 0.005 g", "roll, consider-Kalman": "roll, consider-Kalman, 0.005 g"}
    return f"{words}\n\n{_summary(rows, columns)}"


def observer(rows):
    beyond = [f"{row['vehicle']} {row['manoeuvre']} ({row['roll']}, {row['bank']})" for row in rows
              if float(row["roll"]) > LIMIT_ROLL_DEG or float(row["bank"]) > LIMIT_BANK_DEG]
    words = (f"Aimed at: roll within {LIMIT_ROLL_DEG} deg and bank within {LIMIT_BANK_DEG:g} deg. Beyond it (roll, bank): "
             + (", ".join(beyond) or "none") + ".")
    columns = {"roll, deg": "roll", "bank, deg": "bank", "roll, K 10 % low": "roll with K 10 % low / high, low",
               "roll, K 10 % high": "roll with K 10 % low / high, high"}
    return f"{words}\n\n{_summary(rows, columns)}"

"""The verdict on the logs of a folder, as Markdown and as a page."""

import collections
import csv
import html
import re
import urllib.parse

SHOWN_WARNINGS = 4


def rows_of(file):
    with file.open(encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def markdown(made, left_out, found, output):
    """Each drive with its results of the replay, and the account of rsi-sil validate."""
    replayed = {row["drive"]: row for row in rows_of(output / "replays/table.csv")}
    kinds = collections.Counter(row["verdict"] for row in replayed.values())
    alarms = [name for name, row in replayed.items() if row["verdict"] == "false alarm"]
    lines = ["# Verdict", "", f"{len(made)} drives: {', '.join(f'{count} {kind}' for kind, count in sorted(kinds.items()))}", "",
             f"False alarms: {', '.join(alarms) or 'none'}"
             + ("; without wheel loads it is not known whether a warning was one" if "warning" in kinds else "")]
    for one in made:
        row = replayed[one.file.stem]
        warnings = warnings_of(output / "replays" / one.file.stem / "warnings.csv")
        more = f" and {len(warnings) - SHOWN_WARNINGS} more" if len(warnings) > SHOWN_WARNINGS else ""
        said = "warned of rolling over " + ", ".join(f"to the {side} at {float(time_s):.2f} s" for time_s, side in
                                                     warnings[:SHOWN_WARNINGS]) + more if warnings else "not warned"
        lines += ["", f"## {one.log.name}", "", *[f"- {line}" for line in one.facts], f"- {said}; verdict: {row['verdict']}"]
        lines += [f"- codes: {row['confirmed_codes']}"] if row["confirmed_codes"] else []
        if float(row["unavailable_duration_s"]):
            lines.append(f"- unavailable for {float(row['unavailable_duration_s']):.2f} s")
        moment = f"#{warnings[0][0]}" if warnings else ""
        lines.append(f"- [report](replays/{urllib.parse.quote(one.file.stem)}/report.html{moment})")
    if left_out:
        lines += ["", "## No drive", "", *[f"- {line}" for line in left_out]]
    if found:
        found = re.sub(r"^drive +warning s.*?^Results in .*?\n", "", found, flags=re.DOTALL | re.MULTILINE)  # it is above
        lines += ["", "## What validate found", "", *[f"- {line.strip()}" for line in found.splitlines() if line.strip()]]
    return "\n".join(lines) + "\n"


def warnings_of(file):
    """Time and side of each warning; while it goes on, of each change of sides."""
    found, last = [], None
    for row in rows_of(file):
        if row["state"] != "warning":
            last = None
        elif row["side"] in ("left", "right") and row["side"] != last:
            last = row["side"]
            found.append((row["time_s"], last))
    return found


def page(text):
    """The Markdown above as HTML."""
    body = []
    for line in text.splitlines():
        safe = re.sub(r"\[report\]\((replays/[^\s()]+)\)", r'<a href="\1">report</a>', html.escape(line))
        level = len(re.match("#*", line)[0])
        body.append(f"<h{level}>{safe[level:].strip()}</h{level}>" if level else f"<li>{safe[2:]}</li>" if line.startswith("- ")
                    else f"<p>{safe}</p>" if line else "")
    lists = re.sub(r"((?:<li>.*\n)+)", r"<ul>\n\1</ul>\n", "\n".join(body) + "\n")
    return ('<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width">\n'
            "<title>Verdict</title>\n<style>body { font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; "
            f"overflow-wrap: anywhere }} :root {{ color-scheme: light dark }}</style>\n{lists}</html>\n")

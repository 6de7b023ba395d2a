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


def markdown(made, left_out, found, doubts, output):
    """Each drive with its results of the replay, the account of rsi-sil validate, and the doubts of rsi-sil identify."""
    replayed = {row["drive"]: row for row in rows_of(output / "replays/table.csv")}
    kinds = collections.Counter(row["verdict"] for row in replayed.values())
    alarms = [name for name, row in replayed.items() if row["verdict"] == "false alarm"]
    lines = ["# Verdict", "", f"{len(made)} drives: {', '.join(f'{count} {kind}' for kind, count in sorted(kinds.items()))}", "",
             f"False alarms: {', '.join(alarms) or 'none'}"
             + ("; of a warning near lift-off it is not known without wheel loads" if "warning" in kinds else "")]
    for one in made:
        row = replayed[one.file.stem]
        warnings = [re.fullmatch(r"(\w+) at (\S+) s", warning) for warning in row["warnings"].split("; ") if warning]
        more = f" and {len(warnings) - SHOWN_WARNINGS} more" if len(warnings) > SHOWN_WARNINGS else ""
        said = "warned of rolling over " + ", ".join(f"to the {warning[1]} at {float(warning[2]):.2f} s" for warning in
                                                     warnings[:SHOWN_WARNINGS]) + more if warnings else "not warned"
        lines += ["", f"## {one.log.name}", "", *[f"- {line}" for line in one.facts], f"- {said}; verdict: {row['verdict']}"]
        lines += [f"- codes: {row['confirmed_codes']}"] if row["confirmed_codes"] else []
        if float(row["unavailable_duration_s"]):
            lines.append(f"- unavailable for {float(row['unavailable_duration_s']):.2f} s")
        moment = f"#{float(warnings[0][2])}" if warnings else ""
        lines.append(f"- [report](replays/{urllib.parse.quote(one.file.stem)}/report.html{moment})")
    text = "\n".join(lines) + "\n" + section("No drive", left_out)
    if found:
        found = re.sub(r"^drive +warning s.*?^Results in .*?\n", "", found, flags=re.DOTALL | re.MULTILINE)  # it is above
        found = re.sub(r"^  identify doubts: .*\n", "", found, flags=re.MULTILINE)  # it is below
        text += section("What validate found", [line.strip() for line in found.splitlines() if line.strip()])
    return text + section("Doubts of identify about the calibration", doubts)


def section(title, lines):
    return "\n".join(["", f"## {title}", "", *[f"- {line}" for line in lines], ""]) if lines else ""


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

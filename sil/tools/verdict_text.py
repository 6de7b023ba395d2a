"""The verdict on the logs of a folder, as Markdown and as a page."""

import collections
import csv
import html
import re
import urllib.parse

import drive_pictures

SHOWN_WARNINGS = 4
STYLE = """body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 1.5rem auto; padding: 0 1rem;
  overflow-wrap: anywhere; background: var(--ground); color: var(--ink) }
a { color: var(--accent) } h1, h2 { line-height: 1.2 } ul { padding-left: 1.2rem }
h2 { border-top: 1px solid var(--line); padding-top: 1rem; margin-top: 1.6rem; font-size: 1.2rem }
.pictures { display: grid; gap: 0.8rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)) }
figure { margin: 0; background: var(--panel); border: 1px solid var(--line); border-radius: 10px; padding: 0.5rem }
svg { display: block; width: 100% } svg text { font-size: 13px; fill: var(--quiet) }
figcaption { color: var(--quiet); font-size: 0.85rem; margin-top: 0.3rem }"""


def rows_of(file):
    with file.open(encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def markdown(made, left_out, found, doubts, output):
    """Each drive with its results of the replay, the account of rsi-sil validate, and the doubts of rsi-sil identify."""
    replayed = replayed_of(output)
    kinds = collections.Counter(row["verdict"] for row in replayed.values())
    alarms = [name for name, row in replayed.items() if row["verdict"] == "false alarm"]
    lines = ["# Verdict", "", f"{len(made)} drives: {', '.join(f'{count} {kind}' for kind, count in sorted(kinds.items()))}", "",
             f"False alarms: {', '.join(alarms) or 'none'}"
             + ("; of a warning near lift-off it is not known without wheel loads" if "warning" in kinds else "")]
    for one in made:
        row = replayed[one.file.stem]
        warnings = warnings_of(row)
        more = f" and {len(warnings) - SHOWN_WARNINGS} more" if len(warnings) > SHOWN_WARNINGS else ""
        said = "warned of rolling over " + ", ".join(f"to the {side} at {float(time_s):.2f} s" for time_s, side in
                                                     warnings[:SHOWN_WARNINGS]) + more if warnings else "not warned"
        lines += ["", f"## {one.log.name}", "", *[f"- {line}" for line in one.facts], f"- {said}; verdict: {row['verdict']}"]
        lines += [f"- codes: {row['confirmed_codes']}"] if row["confirmed_codes"] else []
        if float(row["unavailable_duration_s"]):
            lines.append(f"- unavailable for {float(row['unavailable_duration_s']):.2f} s")
        moment = f"#{float(warnings[0][0])}" if warnings else ""
        lines.append(f"- [report](replays/{urllib.parse.quote(one.file.stem)}/report.html{moment})")
    text = "\n".join(lines) + "\n" + section("No drive", left_out)
    if found:
        found = re.sub(r"^drive +warning s.*?^Results in .*?\n", "", found, flags=re.DOTALL | re.MULTILINE)  # it is above
        found = re.sub(r"^  identify doubts: .*\n", "", found, flags=re.MULTILINE)  # it is below
        text += section("What validate found", [line.strip() for line in found.splitlines() if line.strip()])
    return text + section("Doubts of identify about the calibration", doubts)


def section(title, lines):
    return "\n".join(["", f"## {title}", "", *[f"- {line}" for line in lines], ""]) if lines else ""


def replayed_of(output):
    """The rows of the replay, by the names of the drives."""
    return {row["drive"]: row for row in rows_of(output / "replays/table.csv")}


def warnings_of(row):
    """Time and side of each warning in a row of the replay; while it goes on, of each change of sides."""
    found = [re.fullmatch(r"(\w+) at (\S+) s", warning) for warning in row["warnings"].split("; ") if warning]
    return [(warning[2], warning[1]) for warning in found]


def pictures(made, output):
    """HTML for the headings of the drives."""
    replayed = replayed_of(output)
    return {f"## {one.log.name}": drive_pictures.pictures(one.drive, warnings_of(replayed[one.file.stem])) for one in made}


def page(text, below):
    """The Markdown above as HTML, with what belongs below some of its lines."""
    body = []
    for line in text.splitlines():
        safe = re.sub(r"\[report\]\((replays/[^\s()]+)\)", r'<a href="\1">report</a>', html.escape(line))
        level = len(re.match("#*", line)[0])
        body.append(f"<h{level}>{safe[level:].strip()}</h{level}>" if level else f"<li>{safe[2:]}</li>" if line.startswith("- ")
                    else f"<p>{safe}</p>" if line else "")
        body += [below[line]] if line in below else []
    lists = re.sub(r"((?:<li>.*\n)+)", r"<ul>\n\1</ul>\n", "\n".join(body) + "\n")
    return ('<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width">\n'
            '<meta name="color-scheme" content="light dark">\n'
            f"<title>Verdict</title>\n<style>{drive_pictures.colours()}\n{STYLE}</style>\n{lists}</html>\n")

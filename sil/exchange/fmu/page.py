"""The page within an FMU that an importer opens: what it is, how it is stepped, every variable."""

import html

import description

TITLES = {"input": "Inputs", "output": "Outputs", "parameter": "Parameters, fixed after initialisation"}
TIME = """The cycle is 10 ms, best the communication step too. A longer step is several cycles. In shorter ones a cycle takes
the inputs of its beginning and holds its outputs until its end. Signs are those of ISO 8855: left and up are positive."""


def row_of(variable):
    unit = description.UNITS[variable.unit][0] if variable.unit else ""
    span = ", ".join(variable.choices)
    if not span and variable.least < variable.largest:
        span = f"{description.number(variable.least)} to {description.number(variable.largest)}"
    start = description.start_of(variable) if variable.role != "output" else ""
    cells = "".join(f"<td>{html.escape(cell)}</td>" for cell in (variable.name, unit, start, span, variable.meaning))
    return f"<tr>{cells}</tr>\n"


def text_of(model, rows):
    parts = [f"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{html.escape(model.name)}</title></head><body>\n"
             f"<h1>{html.escape(model.name)} {html.escape(model.version)}</h1>\n<p>{html.escape(model.description)}.</p>\n"
             f"<p>{html.escape(TIME)}</p>\n"]
    for role, title in TITLES.items():
        parts.append(f"<h2>{title}</h2>\n<table>\n<tr><th>name</th><th>unit</th><th>start</th><th>range, choices</th>"
                     "<th>meaning</th></tr>\n")
        parts += [row_of(row) for row in rows if row.role == role]
        parts.append("</table>\n")
    return "".join(parts) + "</body></html>\n"

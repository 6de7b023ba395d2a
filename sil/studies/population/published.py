"""The published values of published.toml, checked."""

import math
import tomllib
import typing

import file_io
from vehicle_quantities import UNITS

# How much of a source was read for this project, and how a page says so.
READ = {"data": "its data", "text": "its text or abstract", "quoted": "another's text that quotes it",
        "not read": "**nothing: from knowledge of the source**"}
SOURCE_TEXTS = ("author", "title", "place", "read")
VALUE_TEXTS = ("quantity", "of", "ends", "source")
ENDS = ("low", "middle", "high")


class Wrong(Exception):
    """Says what is wrong in which file, and what to do."""


class Source(typing.NamedTuple):
    name: str
    author: str
    title: str
    year: int | None  # None: the source does not say
    place: str
    read: str


class Value(typing.NamedTuple):
    quantity: str
    classes: list  # of the population, to compare with
    of: str
    low: float | None
    middle: float | None
    high: float | None
    ends: str
    source: Source

    def numbers(self):
        return [number for number in (self.low, self.middle, self.high) if number is not None]


def _source(name, table, where):
    unknown = sorted(set(table) - {*SOURCE_TEXTS, "year"})
    if unknown:
        raise Wrong(f"{where}: [source.{name}] has an unknown key {unknown[0]}; there are {', '.join(SOURCE_TEXTS)}, year")
    for key in SOURCE_TEXTS:
        if not isinstance(table.get(key), str) or not table[key].strip():
            raise Wrong(f"{where}: [source.{name}] has no {key}; say it")
    if table["read"] not in READ:
        raise Wrong(f"{where}: [source.{name}] was read \"{table['read']}\"; there are {', '.join(READ)}")
    return Source(name, table["author"], table["title"], table.get("year"), table["place"], table["read"])


def _number(table, key, named):
    number = table.get(key)
    if number is None:
        return None
    if isinstance(number, bool) or not isinstance(number, (int, float)) or not math.isfinite(number):
        raise Wrong(f"{named}: {key} is no number")
    return float(number)


def _value(table, sources, classes, named):
    unknown = sorted(set(table) - {*VALUE_TEXTS, *ENDS, "classes"})
    if unknown:
        raise Wrong(f"{named} has an unknown key {unknown[0]}; there are {', '.join((*VALUE_TEXTS, *ENDS, 'classes'))}")
    if table.get("source") is None:
        raise Wrong(f"{named} has no source; name one of the tables [source.NAME]")
    if table["source"] not in sources:
        raise Wrong(f"{named}: there is no table [source.{table['source']}]; write it, or name another")
    if table.get("quantity") not in UNITS:
        raise Wrong(f"{named}: unknown quantity; there are {', '.join(UNITS)}")
    compared = table.get("classes")
    if not isinstance(compared, list) or not compared:
        raise Wrong(f"{named} has no classes; list those of the population that it is compared with")
    for each in compared:
        if each not in classes:
            raise Wrong(f"{named}: the population has no class {each}; there are {', '.join(classes)}")
    if not table.get("of"):
        raise Wrong(f"{named} has no \"of\"; say what was measured")
    low, middle, high = (_number(table, key, named) for key in ENDS)
    given = [number for number in (low, middle, high) if number is not None]
    if not given:
        raise Wrong(f"{named} has no number; give low, middle or high")
    if given != sorted(given):
        raise Wrong(f"{named}: low, middle and high do not increase; put them in order")
    if (low is not None or high is not None) and not table.get("ends"):
        raise Wrong(f"{named} has no \"ends\"; say what low and high are, for example 5 and 95 %")
    return Value(table["quantity"], compared, table["of"], low, middle, high, table.get("ends", "mean or single value"),
                 sources[table["source"]])


def read(path, classes):
    """Values in the order of the file, and all sources. `classes`: those of the population. Raises Wrong."""
    try:
        content = tomllib.loads(file_io.read(path))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise Wrong(f"{path}: cannot be read as TOML: {error}") from error
    sources = {name: _source(name, table, path.name) for name, table in content.get("source", {}).items()}
    values = []
    for number, table in enumerate(content.get("value", []), 1):
        named = f"{path.name}: value {number} ({table.get('quantity', 'no quantity')}, {table.get('of', 'nothing')})"
        values.append(_value(table, sources, classes, named))
    unused = sorted(set(sources) - {value.source.name for value in values})
    if unused:
        raise Wrong(f"{path.name}: no value is from [source.{unused[0]}]; remove it")
    return values, list(sources.values())

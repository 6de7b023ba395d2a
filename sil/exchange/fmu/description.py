"""modelDescription.xml of FMI 2.0 and 3.0, made of the table of variables that the FMU's own binary tells."""

import ctypes
import dataclasses
import math
import os
import re
import xml.etree.ElementTree as ElementTree

import file_io

CYCLE_S = "0.01"

# Units that a user would rather see, with the factor from the SI unit.
DISPLAYED = {"rad": ("deg", 180.0 / math.pi), "rad/s": ("deg/s", 180.0 / math.pi), "m/s": ("km/h", 3.6)}

# How a name ends, or what the table of outputs calls it: the unit's name for FMI, and its exponents and factor in SI.
UNITS = {
    "kg": ("kg", {"kg": 1}), "m": ("m", {"m": 1}), "s": ("s", {"s": 1}), "hz": ("Hz", {"s": -1}),
    "n": ("N", {"kg": 1, "m": 1, "s": -2}), "nm": ("N.m", {"kg": 1, "m": 2, "s": -2}),
    "g": ("g", {"m": 1, "s": -2, "factor": 9.80665}),
    "m2": ("m2", {"m": 2}), "mps": ("m/s", {"m": 1, "s": -1}), "mps2": ("m/s2", {"m": 1, "s": -2}),
    "rad": ("rad", {"rad": 1}), "radps": ("rad/s", {"rad": 1, "s": -1}), "radpm": ("rad/m", {"rad": 1, "m": -1}),
    "kgm2": ("kg.m2", {"kg": 1, "m": 2}), "npm": ("N/m", {"kg": 1, "s": -2}), "npm2": ("N/m2", {"kg": 1, "m": -1, "s": -2}),
    "nspm": ("N.s/m", {"kg": 1, "s": -1}), "nmprad": ("N.m/rad", {"kg": 1, "m": 2, "s": -2, "rad": -1}),
    "nmprad3": ("N.m/rad3", {"kg": 1, "m": 2, "s": -2, "rad": -3}),
    "nmprad5": ("N.m/rad5", {"kg": 1, "m": 2, "s": -2, "rad": -5}),
    "nmsprad": ("N.m.s/rad", {"kg": 1, "m": 2, "s": -1, "rad": -1}), "nprad": ("N/rad", {"kg": 1, "m": 1, "s": -2, "rad": -1}),
    "radpn": ("rad/N", {"rad": 1, "kg": -1, "m": -1, "s": 2}), "prad": ("1/rad", {"rad": -1}), "pm": ("1/m", {"m": -1}),
    "pm2": ("1/m2", {"m": -2}), "s2pm": ("s2/m", {"s": 2, "m": -1}), "per_s": ("1/s", {"s": -1}),
}


@dataclasses.dataclass
class Variable:
    role: str
    kind: str
    name: str
    start: str
    least: float
    largest: float
    may_be_missing: bool
    unit: str
    choices: list
    meaning: str


def table_of(binary):
    """Output of rsi_fmu_variables of the binary."""
    told = []
    take = ctypes.CFUNCTYPE(None, ctypes.c_char_p)
    ctypes.CDLL(str(binary)).rsi_fmu_variables(take(lambda text: told.append(text.decode())))
    rows = []
    for line in told[0].splitlines():
        role, kind, name, start, least, largest, may_be_missing, unit, choices, meaning = line.split("\t")
        rows.append(Variable(role, kind, name, start, float(least), float(largest), may_be_missing == "1",
                             unit_of(name, unit) if kind == "number" else "", choices.split(",") if choices else [], meaning))
    return rows


def explain(rows, *headers):
    """Meanings out of the headers that define a field, where the table has none: those of the fields' comments; and behind
    an "rsi_state: ..." what the values of that enumeration are."""
    text = "\n".join(file_io.read(header) for header in headers)
    comments = {}
    field = re.compile(r"^ +(?:float|double|int32_t|Real)\s+(\w+)(?:\{\})?;\s*(?:/\*(.*?)\*/|// ([^\n]*)$)", re.M | re.S)
    for name, remark, line in field.findall(text):
        comments.setdefault(name, " ".join((remark or line).split()))
    values = {}
    for body, name in re.findall(r"typedef enum \{([^{}]*)\} (rsi_\w+);", re.sub(r"/\*.*?\*/", "", text, flags=re.S)):
        pairs = re.findall(r"(\w+)\s*=\s*(\d+)", body)
        common = os.path.commonprefix([constant for constant, _ in pairs]).rpartition("_")[0]
        values[name] = ", ".join(f"{value} {constant[len(common) + 1:].lower().replace('_', ' ')}" for constant, value in pairs)
    for row in rows:
        row.meaning = row.meaning or (comments.get(row.name.rsplit(".", 1)[-1], "") if row.role == "parameter" else "")
        named = row.meaning.partition(":")[0]
        if row.role == "output" and named in values:
            row.meaning += f": {values[named]}"


def unit_of(name, told):
    """The key into UNITS: what the table tells, or the longest ending of the name that is one."""
    if name == "time":
        return "s"
    if told == "g":
        return "g"
    if told == "-":
        return ""
    last = name.rsplit(".", 1)[-1]
    return max((key for key in UNITS if last.endswith("_" + key) and key != "g"), key=len, default="")


def number(value):
    """As XML has it, and as short as gives the same number."""
    value = float(value)
    if math.isnan(value):
        return "NaN"
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def start_of(variable):
    if variable.kind == "text":
        return variable.start
    if variable.kind == "boolean":
        return "true" if float(variable.start) else "false"
    return str(int(float(variable.start))) if variable.kind in ("integer", "choice") else number(variable.start)


def units_of(rows):
    element = ElementTree.Element("UnitDefinitions")
    for key in sorted({row.unit for row in rows if row.unit}, key=lambda key: UNITS[key][0]):
        name, exponents = UNITS[key]
        unit = ElementTree.SubElement(element, "Unit", name=name)
        ElementTree.SubElement(unit, "BaseUnit", {base: str(exponent) for base, exponent in exponents.items()})
        shown, factor = DISPLAYED.get(name, (name, 1.0))
        ElementTree.SubElement(unit, "DisplayUnit", name=shown, factor=number(factor))
    return element


def common(version, model):
    """Root element with what both versions call alike."""
    return ElementTree.Element(
        "fmiModelDescription", fmiVersion=version, modelName=model.name, description=model.description,
        author="Rollover-warning ECU component", version=model.version, license="MIT",
        generationTool=f"sil/exchange/fmu/build {model.version}", variableNamingConvention="structured")


def attributes_of(row, reference):
    """Those of a variable that both versions call alike."""
    causality = "independent" if row.role == "time" else row.role
    attributes = {"name": row.name, "valueReference": str(reference), "causality": causality}
    if row.meaning:
        attributes["description"] = row.meaning
    numeric = row.kind == "number"
    attributes["variability"] = "fixed" if row.role == "parameter" else "continuous" if row.role == "time" else "discrete"
    if row.role == "output":
        attributes["initial"] = "calculated"
    elif row.role == "parameter":
        attributes["initial"] = "exact"
    typed = {}
    if numeric and row.unit:
        typed["unit"] = UNITS[row.unit][0]
        typed["displayUnit"] = DISPLAYED.get(typed["unit"], (typed["unit"],))[0]
    if row.least < row.largest and row.kind in ("number", "integer"):
        typed |= {"min": number(row.least), "max": number(row.largest)}
    if row.kind == "choice":
        typed["declaredType"] = row.name
    if row.role in ("parameter", "input"):
        typed["start"] = start_of(row)
    return attributes, typed


def add_types(root, rows, declare):
    """`declare(types, name)` adds the element of an enumeration; the versions have it elsewhere."""
    choices = [row for row in rows if row.kind == "choice"]
    if choices:
        types = ElementTree.SubElement(root, "TypeDefinitions")
        for row in choices:
            declared = declare(types, row.name)
            for value, name in enumerate(row.choices):
                ElementTree.SubElement(declared, "Item", name=name, value=str(value))


def add_log_and_experiment(root):
    ElementTree.SubElement(root, "LogCategories").append(
        ElementTree.Element("Category", name="logStatusError", description="what was refused, and why"))
    ElementTree.SubElement(root, "DefaultExperiment", startTime="0", stepSize=CYCLE_S)


def fmi3(model, rows):
    root = common("3.0", model)
    root.set("instantiationToken", model.token)
    ElementTree.SubElement(root, "CoSimulation", modelIdentifier=model.identifier, canHandleVariableCommunicationStepSize="true",
                           fixedInternalStepSize=CYCLE_S, canGetAndSetFMUState="true",
                           canSerializeFMUState=str(model.serialises).lower())
    root.append(units_of(rows))
    add_types(root, rows, lambda types, name: ElementTree.SubElement(types, "EnumerationType", name=name))
    add_log_and_experiment(root)
    variables = ElementTree.SubElement(root, "ModelVariables")
    tags = {"number": "Float64", "integer": "Int32", "boolean": "Boolean", "text": "String", "choice": "Enumeration"}
    for reference, row in enumerate(rows):
        attributes, typed = attributes_of(row, reference)
        if row.kind == "text":
            element = ElementTree.SubElement(variables, "String", attributes)
            ElementTree.SubElement(element, "Start", value=row.start)
        else:
            ElementTree.SubElement(variables, tags[row.kind], attributes | typed)
    structure = ElementTree.SubElement(root, "ModelStructure")
    for kind in ("Output", "InitialUnknown"):
        for reference, row in enumerate(rows):
            if row.role == "output":
                ElementTree.SubElement(structure, kind, valueReference=str(reference))
    return text_of(root)


def fmi2(model, rows, sources):
    root = common("2.0", model)
    root.set("guid", model.token)
    root.set("numberOfEventIndicators", "0")
    simulation = ElementTree.SubElement(
        root, "CoSimulation", modelIdentifier=model.identifier, canHandleVariableCommunicationStepSize="true",
        canNotUseMemoryManagementFunctions="true", canGetAndSetFMUstate="true",
        canSerializeFMUstate=str(model.serialises).lower())
    if sources:
        files = ElementTree.SubElement(simulation, "SourceFiles")
        for source in sources:
            ElementTree.SubElement(files, "File", name=source)
    root.append(units_of(rows))
    add_types(root, rows, lambda types, name: ElementTree.SubElement(
        ElementTree.SubElement(types, "SimpleType", name=name), "Enumeration"))
    add_log_and_experiment(root)
    variables = ElementTree.SubElement(root, "ModelVariables")
    tags = {"number": "Real", "integer": "Integer", "boolean": "Boolean", "text": "String", "choice": "Enumeration"}
    for reference, row in enumerate(rows):
        attributes, typed = attributes_of(row, reference)
        ElementTree.SubElement(ElementTree.SubElement(variables, "ScalarVariable", attributes), tags[row.kind], typed)
    structure = ElementTree.SubElement(root, "ModelStructure")
    for kind in ("Outputs", "InitialUnknowns"):
        group = ElementTree.SubElement(structure, kind)
        for index, row in enumerate(rows, start=1):
            if row.role == "output":
                ElementTree.SubElement(group, "Unknown", index=str(index))
    return text_of(root)


def text_of(root):
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=False).join(
        ['<?xml version="1.0" encoding="UTF-8"?>\n', "\n"])

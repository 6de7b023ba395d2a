"""SystemStructure.ssd of SSP 1.0: vehicle and ECU connected, the driver's inputs and the ECU's answers outside."""

import xml.etree.ElementTree as ElementTree

SSD = "http://ssp-standard.org/SSP1/SystemStructureDescription"
SSC = "http://ssp-standard.org/SSP1/SystemStructureCommon"
KINDS = {"number": "Real", "integer": "Integer", "boolean": "Boolean", "text": "String", "choice": "Enumeration"}
NAME = "rollover_warning"
ANSWERS = ("state", "side", "warning_level")
STOP_S = "10"


def tag(space, name):
    return f"{{{space}}}{name}"


def add_connectors(parent, rows):
    connectors = ElementTree.SubElement(parent, tag(SSD, "Connectors"))
    for row in rows:
        connector = ElementTree.SubElement(connectors, tag(SSD, "Connector"), name=row.name, kind=row.role)
        kind = ElementTree.SubElement(connector, tag(SSC, KINDS[row.kind]))
        if row.kind == "choice":
            kind.set("name", row.name)


def add_connection(parent, start, end, name):
    """`start` and `end`: elements; None is the system itself."""
    ends = {"startElement": start, "endElement": end}
    ElementTree.SubElement(parent, tag(SSD, "Connection"),
                           {key: element for key, element in ends.items() if element}
                           | {"startConnector": name, "endConnector": name})


def text_of(vehicle, ecu, version):
    """The file for the rows of both FMUs, which are of FMI 2."""
    ElementTree.register_namespace("ssd", SSD)
    ElementTree.register_namespace("ssc", SSC)
    root = ElementTree.Element(tag(SSD, "SystemStructureDescription"), version="1.0", name=NAME,
                               generationTool=f"sil/exchange/fmu/build {version}")
    system = ElementTree.SubElement(root, tag(SSD, "System"), name=NAME)
    driver = [row for row in vehicle if row.role == "input"]
    answers = [row for row in ecu if row.role == "output" and row.name in ANSWERS]
    signals = [row for row in ecu if row.role == "input"]
    add_connectors(system, driver + answers)
    elements = ElementTree.SubElement(system, tag(SSD, "Elements"))
    for name, rows in (("vehicle", vehicle), ("ecu", ecu)):
        component = ElementTree.SubElement(elements, tag(SSD, "Component"), name=name, type="application/x-fmu-sharedlibrary",
                                           source=f"resources/rsi_{name}_fmi2.fmu")
        add_connectors(component, [row for row in rows if row.role in ("input", "output")])
    connections = ElementTree.SubElement(system, tag(SSD, "Connections"))
    for start, end, rows in ((None, "vehicle", driver), ("vehicle", "ecu", signals), ("ecu", None, answers)):
        for row in rows:
            add_connection(connections, start, end, row.name)
    enumerations = ElementTree.SubElement(root, tag(SSD, "Enumerations"))
    for row in ecu:
        if row.role == "output" and row.kind == "choice":
            enumeration = ElementTree.SubElement(enumerations, tag(SSC, "Enumeration"), name=row.name)
            for value, choice in enumerate(row.choices):
                ElementTree.SubElement(enumeration, tag(SSC, "Item"), name=choice, value=str(value))
    ElementTree.SubElement(root, tag(SSD, "DefaultExperiment"), startTime="0", stopTime=STOP_S)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode").join(['<?xml version="1.0" encoding="UTF-8"?>\n', "\n"])

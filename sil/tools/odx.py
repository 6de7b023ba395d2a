"""ODX of the ECU: its services, identifiers and trouble codes as a PDX file, from the firmware's tables."""

import pathlib
import re
import tempfile

from odxtools import writepdxfile
from odxtools.compumethods.compucategory import CompuCategory
from odxtools.compumethods.compuinternaltophys import CompuInternalToPhys
from odxtools.compumethods.compurationalcoeffs import CompuRationalCoeffs
from odxtools.compumethods.compuconst import CompuConst
from odxtools.compumethods.compudefaultvalue import CompuDefaultValue
from odxtools.compumethods.compuscale import CompuScale
from odxtools.compumethods.identicalcompumethod import IdenticalCompuMethod
from odxtools.compumethods.limit import Limit
from odxtools.compumethods.linearcompumethod import LinearCompuMethod
from odxtools.compumethods.texttablecompumethod import TexttableCompuMethod
from odxtools.database import Database
from odxtools.dataobjectproperty import DataObjectProperty
from odxtools.diagdatadictionaryspec import DiagDataDictionarySpec
from odxtools.diaglayercontainer import DiagLayerContainer
from odxtools.diaglayers.basevariant import BaseVariant
from odxtools.diaglayers.basevariantraw import BaseVariantRaw
from odxtools.diaglayers.diaglayertype import DiagLayerType
from odxtools.diaglayers.ecuvariant import EcuVariant
from odxtools.diaglayers.ecuvariantraw import EcuVariantRaw
from odxtools.diagnostictroublecode import DiagnosticTroubleCode
from odxtools.diagservice import DiagService
from odxtools.dtcdop import DtcDop
from odxtools.ecuvariantpattern import EcuVariantPattern
from odxtools.endofpdufield import EndOfPduField
from odxtools.matchingparameter import MatchingParameter
from odxtools.nameditemlist import NamedItemList
from odxtools.odxlink import DocType, OdxDocFragment, OdxLinkId, OdxLinkRef
from odxtools.odxtypes import DataType
from odxtools.parameters.codedconstparameter import CodedConstParameter
from odxtools.parameters.valueparameter import ValueParameter
from odxtools.parentref import ParentRef
from odxtools.physicaltype import PhysicalType
from odxtools.request import Request
from odxtools.response import Response, ResponseType
from odxtools.standardlengthtype import StandardLengthType
from odxtools.structure import Structure
from odxtools.text import Text
from odxtools.uds import NegativeResponseCodes
from odxtools.unit import Unit
from odxtools.unitspec import UnitSpec

import odx_communication
from odx_tables import name_of_trouble_code
from uds_client import REFUSALS

NAME = "rollover_ecu"
VARIANT = "rollover_ecu_variant"
SYSTEM = "Rollover warning"
FRAGMENTS = (OdxDocFragment(NAME, DocType.CONTAINER), OdxDocFragment(NAME, DocType.LAYER))
SESSIONS = {1: "default", 2: "programming", 3: "extended"}


def short(name):
    return re.sub(r"\W+", "_", name)


def link(*names):
    return OdxLinkId(".".join(short(str(name)) for name in names), FRAGMENTS)


def coded(bits, kind=DataType.A_UINT32):
    return StandardLengthType(base_data_type=kind, bit_length=bits)


class Layer:
    """Description of one ECU."""

    def __init__(self, tables):
        self.tables = tables
        self.dops, self.structures, self.fields, self.units = [], [], [], {}
        self.requests, self.responses, self.refusals, self.services = [], [], [], []
        self.byte = self.number("byte", 8)
        self.word = self.number("word", 16)
        self.three_bytes = self.number("three_bytes", 24)
        self.codes = self.code_property()
        self.reason = self.choice("reason", {code.value: short(code.name) for code in NegativeResponseCodes})
        # Content of a snapshot, in the order of the bytes.
        four_bytes = self.number("four_bytes", 32)
        self.frame = [("lateral_acceleration", self.scaled("lateral_acceleration", 0.01, "m/s^2")),
                      ("roll_rate", self.scaled("roll_rate", 0.001, "rad/s")),
                      ("roll_angle", self.scaled("roll_angle", 0.001, "rad")),
                      ("speed", self.scaled("speed", 0.01, "m/s")), ("seconds_since_start", self.word),
                      ("operation_cycle", four_bytes), ("calibration_checksum", four_bytes)]

    def unit(self, name):
        if name not in self.units:
            self.units[name] = Unit(short_name=short(name) or "one", odx_id=link("unit", name), display_name=name)
        return OdxLinkRef.from_id(self.units[name].odx_id)

    def property_of(self, name, compu, coded_type, physical, unit=None):
        dop = DataObjectProperty(short_name=short(name), odx_id=link("dop", name), compu_method=compu,
                                 diag_coded_type=coded_type, physical_type=PhysicalType(base_data_type=physical),
                                 unit_ref=self.unit(unit) if unit else None)
        self.dops.append(dop)
        return dop

    def number(self, name, bits):
        kind = DataType.A_UINT32
        same = IdenticalCompuMethod(category=CompuCategory.IDENTICAL, physical_type=kind, internal_type=kind)
        return self.property_of(name, same, coded(bits), kind)

    def real(self, name, unit):
        kind = DataType.A_FLOAT32
        same = IdenticalCompuMethod(category=CompuCategory.IDENTICAL, physical_type=kind, internal_type=kind)
        return self.property_of(name, same, coded(32, kind), kind, unit)

    def choice(self, name, texts, bits=8):
        """A number with a text for each of its values; another value reads as its `other`."""
        internal, physical = DataType.A_UINT32, DataType.A_UNICODE2STRING
        scales = [CompuScale(lower_limit=Limit(value_raw=str(value), value_type=internal),
                             upper_limit=Limit(value_raw=str(value), value_type=internal),
                             compu_const=CompuConst(vt=text, data_type=physical), domain_type=internal, range_type=physical)
                  for value, text in texts.items()]
        other = CompuDefaultValue(vt="other", data_type=physical)
        method = TexttableCompuMethod(category=CompuCategory.TEXTTABLE, physical_type=physical, internal_type=internal,
                                      compu_internal_to_phys=CompuInternalToPhys(compu_scales=scales, compu_default_value=other))
        return self.property_of(name, method, coded(bits), physical)

    def text_of(self, name, length):
        """ASCII, filled with zeros."""
        internal, physical = DataType.A_ASCIISTRING, DataType.A_UNICODE2STRING
        same = IdenticalCompuMethod(category=CompuCategory.IDENTICAL, physical_type=physical, internal_type=internal)
        return self.property_of(name, same, coded(8 * length, internal), physical)

    def bytes_of(self, name, length):
        kind = DataType.A_BYTEFIELD
        same = IdenticalCompuMethod(category=CompuCategory.IDENTICAL, physical_type=kind, internal_type=kind)
        return self.property_of(name, same, coded(8 * length, kind), kind)

    def scaled(self, name, step, unit):
        internal, physical = DataType.A_INT32, DataType.A_FLOAT64
        scale = CompuScale(compu_rational_coeffs=CompuRationalCoeffs(value_type=DataType.A_FLOAT64, numerators=[0, step],
                                                                     denominators=[1]),
                           domain_type=internal, range_type=physical)
        linear = LinearCompuMethod(category=CompuCategory.LINEAR, physical_type=physical, internal_type=internal,
                                   compu_internal_to_phys=CompuInternalToPhys(compu_scales=[scale]))
        return self.property_of(name, linear, coded(16, internal), physical, unit)

    def code_property(self):
        kind = DataType.A_UINT32
        codes = [DiagnosticTroubleCode(short_name=short(name), odx_id=link("code", name), trouble_code=number,
                                       display_trouble_code=name_of_trouble_code(number), text=Text(text=name.replace("_", " ")))
                 for number, name in self.tables.codes.items()]
        same = IdenticalCompuMethod(category=CompuCategory.IDENTICAL, physical_type=kind, internal_type=kind)
        return DtcDop(short_name="trouble_code", odx_id=link("dop", "trouble_code"), diag_coded_type=coded(24),
                      physical_type=PhysicalType(base_data_type=kind), compu_method=same, dtcs_raw=codes)

    def constant(self, name, value, at, bits=8):
        return CodedConstParameter(short_name=name, coded_value_raw=str(value), byte_position=at, diag_coded_type=coded(bits))

    @staticmethod
    def value(name, dop, at=None):
        return ValueParameter(short_name=short(name), dop_ref=OdxLinkRef.from_id(dop.odx_id), byte_position=at)

    def structure(self, name, parameters):
        structure = Structure(short_name=name, odx_id=link("structure", name), parameters=NamedItemList(parameters))
        self.structures.append(structure)
        return structure

    def repeated(self, name, structure):
        field = EndOfPduField(short_name=name, odx_id=link("field", name),
                              structure_ref=OdxLinkRef.from_id(structure.odx_id))
        self.fields.append(field)
        return field

    def service(self, name, head, asked=(), answered=(), echoed=None):
        """`head`: the bytes that the request begins with; the answer repeats `echoed` of them (default: all)."""
        echoed = len(head) if echoed is None else echoed
        request = [self.constant(f"request_{at}", byte, at) for at, byte in enumerate(head)]
        answer = [self.constant(f"answer_{at}", byte + (0x40 if at == 0 else 0), at)
                  for at, byte in enumerate(head[:echoed])]
        self.requests.append(Request(short_name=f"{name}_request", odx_id=link("request", name),
                                     parameters=NamedItemList(request + list(asked))))
        self.responses.append(Response(short_name=f"{name}_answer", odx_id=link("answer", name),
                                       response_type=ResponseType.POSITIVE,
                                       parameters=NamedItemList(answer + list(answered))))
        refusal = [self.constant("negative", 0x7F, 0), self.constant("service", head[0], 1), self.value("reason", self.reason, 2)]
        self.refusals.append(Response(short_name=f"{name}_refusal", odx_id=link("refusal", name),
                                      response_type=ResponseType.NEGATIVE, parameters=NamedItemList(refusal)))
        self.services.append(DiagService(short_name=name, odx_id=link("service", name),
                                         request_ref=OdxLinkRef.from_id(self.requests[-1].odx_id),
                                         pos_response_refs=[OdxLinkRef.from_id(self.responses[-1].odx_id)],
                                         neg_response_refs=[OdxLinkRef.from_id(self.refusals[-1].odx_id)]))


def split(identifier):
    return [identifier >> 8, identifier & 0xFF]


def add_sessions(layer):
    for number, name in SESSIONS.items():
        layer.service(f"session_{name}", [0x10, number], answered=[layer.value("p2_ms", layer.word),
                                                                   layer.value("p2_star_10_ms", layer.word)])
    layer.service("reset_hard", [0x11, 0x01])
    layer.service("reset_soft", [0x11, 0x03])
    layer.service("tester_present", [0x3E, 0x00])
    layer.service("frames_sent", [0x28, 0x00], asked=[layer.value("messages", layer.byte)])
    layer.service("frames_not_sent", [0x28, 0x01], asked=[layer.value("messages", layer.byte)])
    layer.service("recording_on", [0x85, 0x01])
    layer.service("recording_off", [0x85, 0x02])
    block = layer.bytes_of("key_block", 16)
    layer.service("request_seed", [0x27, 0x01], answered=[layer.value("seed", block)])
    layer.service("send_key", [0x27, 0x02], asked=[layer.value("key", block)])


def add_codes(layer):
    code, status = layer.value("code", layer.codes), layer.value("status", layer.byte)
    mask, record = layer.value("mask", layer.byte), layer.value("record", layer.byte)
    available = layer.value("available", layer.byte)
    listed = layer.repeated("codes", layer.structure("code_with_status", [code, status]))
    layer.service("clear_codes", [0x14], asked=[layer.value("group", layer.three_bytes)])
    layer.service("count_codes", [0x19, 0x01], asked=[mask], answered=[
        available, layer.value("format", layer.byte), layer.value("count", layer.word)])
    layer.service("read_codes", [0x19, 0x02], asked=[mask], answered=[available, layer.value("codes", listed)])
    layer.service("read_all_codes", [0x19, 0x0A], answered=[available, layer.value("codes", listed)])
    identifier = layer.constant("identifier", layer.tables.constants["freeze_frame_identifier"], 2, 16)
    frame = [layer.value("record", layer.byte, 0), layer.constant("identifiers", 1, 1), identifier]
    frame += [layer.value(name, dop) for name, dop in layer.frame]
    snapshots = layer.repeated("snapshots", layer.structure("snapshot", frame))
    layer.service("read_snapshots", [0x19, 0x04], asked=[code, record],
                  answered=[code, status, layer.value("snapshots", snapshots)])
    counts = layer.repeated("counts", layer.structure("count", [record, layer.value("value", layer.byte)]))
    counters = layer.repeated("counters", layer.structure("counter", [code, layer.value("counter", layer.byte)]))
    layer.service("read_fault_detection_counters", [0x19, 0x14], answered=[layer.value("counters", counters)])
    layer.service("read_counts", [0x19, 0x06], asked=[code, record],
                  answered=[code, status, layer.value("counts", counts)])


def add_data(layer):
    constants = layer.tables.constants
    for identifier, length, name in layer.tables.texts:
        layer.service(f"read_{short(name)}", [0x22, *split(identifier)],
                      answered=[layer.value(name, layer.text_of(name, length))])
    for identifier, name, unit in layer.tables.numbers:
        layer.service(f"read_{name}", [0x22, *split(identifier)], answered=[layer.value(name, layer.real(name, unit))])
    for identifier, name, texts in layer.tables.choices:
        layer.service(f"read_{name}", [0x22, *split(identifier)],
                      answered=[layer.value(name, layer.choice(name, dict(enumerate(texts))))])
    layer.service("read_session", [0x22, *split(constants["active_session_identifier"])],
                  answered=[layer.value("session", layer.choice("session", SESSIONS))])
    layer.service("read_calibration_checksum", [0x22, *split(constants["calibration_checksum_identifier"])],
                  answered=[layer.value("calibration_checksum", layer.number("checksum", 32))])
    layer.service("read_operation_cycles", [0x22, *split(constants["operation_cycles_identifier"])],
                  answered=[layer.value("operation_cycles", layer.number("cycles", 32))])
    for name, dop in (("vehicle_number", layer.text_of("vehicle_number", 17)),
                      ("programming_date", layer.bytes_of("programming_date", 4))):
        identifier = split(constants[f"{name}_identifier"])
        layer.service(f"read_{name}", [0x22, *identifier], answered=[layer.value(name, dop)])
        layer.service(f"write_{name}", [0x2E, *identifier], asked=[layer.value(name, dop)])


def add_routines(layer):
    self_test = split(layer.tables.constants["self_test_routine"])
    check = split(layer.tables.constants["check_section_routine"])
    layer.service("self_test", [0x31, 0x01, *self_test], answered=[layer.value("found", layer.byte)])
    layer.service("self_test_results", [0x31, 0x03, *self_test], answered=[layer.value("found", layer.byte)])
    layer.service("check_section", [0x31, 0x01, *check], answered=[layer.value("refusal", layer.choice("refusal", dict(enumerate(REFUSALS))))])
    # Not compressed, an address of a byte, a length of two.
    layer.service("request_download", [0x34, 0x00, 0x21, 0x00, *split(layer.tables.constants["section_length"])], echoed=1,
                  answered=[layer.value("format", layer.byte), layer.value("longest_block", layer.word)])
    rest = layer.repeated("data", layer.structure("data_byte", [layer.value("data", layer.byte)]))
    layer.service("transfer_data", [0x36], asked=[layer.value("block", layer.byte), layer.value("data", rest)],
                  answered=[layer.value("block", layer.byte)])
    layer.service("transfer_exit", [0x37])


def variant_of(base):
    """The only one; a tester knows it by its name."""
    system = MatchingParameter(expected_value=SYSTEM, diag_comm_snref="read_system_name", out_param_if_snref="system_name")
    raw = EcuVariantRaw(short_name=VARIANT, odx_id=OdxLinkId(VARIANT, FRAGMENTS[:1]), variant_type=DiagLayerType.ECU_VARIANT,
                        ecu_variant_patterns=[EcuVariantPattern(matching_parameters=[system])],
                        parent_refs=[ParentRef(layer_ref=OdxLinkRef.from_id(base.odx_id))])
    return EcuVariant(diag_layer_raw=raw)


def database_of(tables):
    layer = Layer(tables)
    add_sessions(layer)
    add_codes(layer)
    add_data(layer)
    add_routines(layer)
    dictionary = DiagDataDictionarySpec(
        dtc_dops=NamedItemList([layer.codes]), data_object_props=NamedItemList(layer.dops),
        structures=NamedItemList(layer.structures), end_of_pdu_fields=NamedItemList(layer.fields),
        unit_spec=UnitSpec(units=NamedItemList(layer.units.values())))
    subset = odx_communication.subset_of(tables.constants)
    spec = odx_communication.spec_of(subset)
    protocol = odx_communication.protocol_of(spec, FRAGMENTS[:1])
    raw = BaseVariantRaw(short_name=NAME, odx_id=OdxLinkId(NAME, FRAGMENTS[:1]), variant_type=DiagLayerType.BASE_VARIANT,
                         diag_data_dictionary_spec=dictionary, diag_comms_raw=layer.services,
                         requests=NamedItemList(layer.requests), positive_responses=NamedItemList(layer.responses),
                         negative_responses=NamedItemList(layer.refusals),
                         comparam_refs=odx_communication.references_of(tables.constants),
                         parent_refs=[ParentRef(layer_ref=OdxLinkRef.from_id(protocol.odx_id))])
    base = BaseVariant(diag_layer_raw=raw)
    container = DiagLayerContainer(short_name=NAME, odx_id=OdxLinkId(f"container.{NAME}", FRAGMENTS[:1]),
                                   protocols=NamedItemList([protocol]), base_variants=NamedItemList([base]),
                                   ecu_variants=NamedItemList([variant_of(base)]))
    database = Database()
    database.short_name = NAME
    database.comparam_subsets.append(subset)
    database.comparam_specs.append(spec)
    database.diag_layer_containers = NamedItemList([container])
    database.refresh()
    return database


def pdx_of(tables):
    """The bytes of the file."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "rsi-ecu.pdx"
        writepdxfile.write_pdx_file(str(file), database_of(tables))
        return file.read_bytes()

"""Communication of a tester with the ECU, for its ODX: parameters in the names of ISO 22900-2, their values, the protocol."""

from odxtools.comparam import Comparam
from odxtools.comparaminstance import ComparamInstance
from odxtools.comparamspec import ComparamSpec
from odxtools.comparamsubset import ComparamSubset
from odxtools.complexcomparam import ComplexComparam
from odxtools.compumethods.compucategory import CompuCategory
from odxtools.compumethods.identicalcompumethod import IdenticalCompuMethod
from odxtools.dataobjectproperty import DataObjectProperty
from odxtools.diaglayers.diaglayertype import DiagLayerType
from odxtools.diaglayers.protocol import Protocol
from odxtools.diaglayers.protocolraw import ProtocolRaw
from odxtools.nameditemlist import NamedItemList
from odxtools.odxlink import DocType, OdxDocFragment, OdxLinkId, OdxLinkRef
from odxtools.odxtypes import DataType
from odxtools.physicaltype import PhysicalType
from odxtools.protstack import ProtStack
from odxtools.standardizationlevel import StandardizationLevel
from odxtools.standardlengthtype import StandardLengthType
from odxtools.usage import Usage

SPEC, SUBSET, STACK, PROTOCOL = "UDS_on_CAN", "UDS_on_CAN_parameters", "UDS_on_ISO_TP", "UDS_on_CAN_protocol"
IN_SUBSET = (OdxDocFragment(SUBSET, DocType.COMPARAM_SUBSET),)
IN_SPEC = (OdxDocFragment(SPEC, DocType.COMPARAM_SPEC),)
BAUDRATE = 500000
P2_US, P2_STAR_US = 50000, 5000000  # as the ECU says in the answer to 0x10
TESTER_PRESENT_US = 2000000
IDENTIFIERS = ("CP_CanPhysReqId", "CP_CanRespUSDTId")


def values_of(constants):
    """Name to class and value; times in microseconds."""
    return {"CP_Baudrate": ("BUSTYPE", BAUDRATE), "CP_CanFuncReqId": ("COM", constants["functional_request"]),
            "CP_P2Max": ("TIMING", P2_US), "CP_P2Star": ("TIMING", P2_STAR_US),
            "CP_TesterPresentTime": ("TIMING", TESTER_PRESENT_US)}


def parameter(name, kind, value):
    return Comparam(short_name=name, odx_id=OdxLinkId(name, IN_SUBSET), param_class=kind, cptype=StandardizationLevel.STANDARD,
                    cpusage=Usage.ECU_COMM, physical_default_value_raw=str(value),
                    dop_ref=OdxLinkRef.from_id(OdxLinkId("number", IN_SUBSET)))


def subset_of(constants):
    kind = DataType.A_UINT32
    number = DataObjectProperty(
        short_name="number", odx_id=OdxLinkId("number", IN_SUBSET),
        compu_method=IdenticalCompuMethod(category=CompuCategory.IDENTICAL, physical_type=kind, internal_type=kind),
        diag_coded_type=StandardLengthType(base_data_type=kind, bit_length=32), physical_type=PhysicalType(base_data_type=kind))
    table = ComplexComparam(
        short_name="CP_UniqueRespIdTable", odx_id=OdxLinkId("CP_UniqueRespIdTable", IN_SUBSET), param_class="UNIQUE_ID",
        cptype=StandardizationLevel.STANDARD, cpusage=Usage.ECU_COMM, allow_multiple_values_raw=True,
        subparams=NamedItemList([parameter(name, "UNIQUE_ID", 0) for name in IDENTIFIERS]))
    return ComparamSubset(
        short_name=SUBSET, odx_id=OdxLinkId(SUBSET, IN_SUBSET), category="TRANSPORT", data_object_props=NamedItemList([number]),
        comparams=NamedItemList([parameter(name, kind, value) for name, (kind, value) in values_of(constants).items()]),
        complex_comparams=NamedItemList([table]))


def spec_of(subset):
    stack = ProtStack(short_name=STACK, odx_id=OdxLinkId(STACK, IN_SPEC), pdu_protocol_type="ISO_15765_3_on_ISO_15765_2",
                      physical_link_type="ISO_11898_2_DWCAN", comparam_subset_refs=[OdxLinkRef.from_id(subset.odx_id)])
    return ComparamSpec(short_name=SPEC, odx_id=OdxLinkId(SPEC, IN_SPEC), prot_stacks=NamedItemList([stack]))


def protocol_of(spec, fragments):
    return Protocol(diag_layer_raw=ProtocolRaw(
        short_name=PROTOCOL, odx_id=OdxLinkId(PROTOCOL, fragments), variant_type=DiagLayerType.PROTOCOL,
        comparam_spec_ref=OdxLinkRef.from_id(spec.odx_id), prot_stack_snref=STACK))


def references_of(constants):
    """The values that the ECU has, for its layer."""
    def instance(name, value):
        return ComparamInstance(value=value, spec_ref=OdxLinkRef.from_id(OdxLinkId(name, IN_SUBSET)), protocol_snref=PROTOCOL)

    table = [str(constants["physical_request"]), str(constants["response"])]
    return [instance("CP_UniqueRespIdTable", table),
            *(instance(name, str(value)) for name, (_, value) in values_of(constants).items())]

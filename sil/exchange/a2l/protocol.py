"""XCP's part of the A2L: the meta language of it (of XCP 1.1, as far as it is used), and what it says of the slave."""

# The tags and types of the standard's own, so that a tool may put its own in their place.
META_LANGUAGE = """\
    /begin A2ML
      block "IF_DATA" taggedunion if_data {
        "XCP" struct {
          taggedstruct {
            block "PROTOCOL_LAYER" struct {
              uint; uint; uint; uint; uint; uint; uint; uint; uchar; uint;
              enum { "BYTE_ORDER_MSB_LAST" = 0, "BYTE_ORDER_MSB_FIRST" = 1 };
              enum { "ADDRESS_GRANULARITY_BYTE" = 1, "ADDRESS_GRANULARITY_WORD" = 2, "ADDRESS_GRANULARITY_DWORD" = 4 };
              taggedstruct {
                ("OPTIONAL_CMD" enum { %COMMANDS% })*;
                "SEED_AND_KEY_EXTERNAL_FUNCTION" char[256];
              };
            };
            block "DAQ" struct {
              enum { "STATIC" = 0, "DYNAMIC" = 1 };
              uint; uint; uchar;
              enum { "OPTIMISATION_TYPE_DEFAULT" = 0 };
              enum { "ADDRESS_EXTENSION_FREE" = 0, "ADDRESS_EXTENSION_ODT" = 1, "ADDRESS_EXTENSION_DAQ" = 3 };
              enum { "IDENTIFICATION_FIELD_TYPE_ABSOLUTE" = 0 };
              enum { "GRANULARITY_ODT_ENTRY_SIZE_DAQ_BYTE" = 1 };
              uchar;
              enum { "NO_OVERLOAD_INDICATION" = 0, "OVERLOAD_INDICATION_PID" = 1, "OVERLOAD_INDICATION_EVENT" = 2 };
              taggedstruct {
                "PRESCALER_SUPPORTED";
                block "TIMESTAMP_SUPPORTED" struct {
                  uint;
                  enum { "NO_TIME_STAMP" = 0, "SIZE_BYTE" = 1, "SIZE_WORD" = 2, "SIZE_DWORD" = 4 };
                  enum { "UNIT_1US" = 3, "UNIT_10US" = 4, "UNIT_100US" = 5, "UNIT_1MS" = 6 };
                  taggedstruct { "TIMESTAMP_FIXED"; };
                };
                (block "EVENT" struct {
                  char[101]; char[9]; uint;
                  enum { "DAQ" = 1, "STIM" = 2, "DAQ_STIM" = 3 };
                  uchar; uchar; uchar; uchar;
                })*;
              };
            };
            block "PAG" struct { uchar; taggedstruct { "FREEZE_SUPPORTED"; }; };
            block "SEGMENT" struct {
              uchar; uchar; uchar; uchar; uchar;
              taggedstruct {
                block "CHECKSUM" struct {
                  enum { "XCP_CRC_32" = 9 };
                  taggedstruct { "MAX_BLOCK_SIZE" ulong; };
                };
                (block "PAGE" struct {
                  uchar;
                  enum { "ECU_ACCESS_NOT_ALLOWED" = 0, "ECU_ACCESS_WITHOUT_XCP_ONLY" = 1, "ECU_ACCESS_WITH_XCP_ONLY" = 2,
                         "ECU_ACCESS_DONT_CARE" = 3 };
                  enum { "XCP_READ_ACCESS_NOT_ALLOWED" = 0, "XCP_READ_ACCESS_WITHOUT_ECU_ONLY" = 1,
                         "XCP_READ_ACCESS_WITH_ECU_ONLY" = 2, "XCP_READ_ACCESS_DONT_CARE" = 3 };
                  enum { "XCP_WRITE_ACCESS_NOT_ALLOWED" = 0, "XCP_WRITE_ACCESS_WITHOUT_ECU_ONLY" = 1,
                         "XCP_WRITE_ACCESS_WITH_ECU_ONLY" = 2, "XCP_WRITE_ACCESS_DONT_CARE" = 3 };
                  taggedstruct { "INIT_SEGMENT" uchar; };
                })*;
              };
            };
            block "XCP_ON_CAN" struct {
              uint;
              taggedstruct {
                "CAN_ID_MASTER" ulong;
                "CAN_ID_SLAVE" ulong;
                "BAUDRATE" ulong;
              };
            };
          };
        };
      };
    /end A2ML
"""

COMMANDS = {
    "GET_COMM_MODE_INFO": 0xFB, "GET_ID": 0xFA, "SET_REQUEST": 0xF9, "GET_SEED": 0xF8, "UNLOCK": 0xF7, "SET_MTA": 0xF6,
    "UPLOAD": 0xF5, "SHORT_UPLOAD": 0xF4, "BUILD_CHECKSUM": 0xF3, "DOWNLOAD": 0xF0, "SET_CAL_PAGE": 0xEB,
    "GET_CAL_PAGE": 0xEA, "GET_PAG_PROCESSOR_INFO": 0xE9, "GET_SEGMENT_INFO": 0xE8, "GET_PAGE_INFO": 0xE7,
    "SET_SEGMENT_MODE": 0xE6, "GET_SEGMENT_MODE": 0xE5, "COPY_CAL_PAGE": 0xE4, "CLEAR_DAQ_LIST": 0xE3,
    "SET_DAQ_PTR": 0xE2, "WRITE_DAQ": 0xE1, "SET_DAQ_LIST_MODE": 0xE0, "GET_DAQ_LIST_MODE": 0xDF,
    "START_STOP_DAQ_LIST": 0xDE, "START_STOP_SYNCH": 0xDD, "GET_DAQ_CLOCK": 0xDC, "GET_DAQ_PROCESSOR_INFO": 0xDA,
    "GET_DAQ_RESOLUTION_INFO": 0xD9, "GET_DAQ_EVENT_INFO": 0xD7, "FREE_DAQ": 0xD6, "ALLOC_DAQ": 0xD5,
    "ALLOC_ODT": 0xD4, "ALLOC_ODT_ENTRY": 0xD3,
}

# The library of sil/exchange/seed_and_key, which a tool looks for beside the A2L.
SEED_AND_KEY = "SeedNKeyXcp.dll"

# The answer comes behind the next cycle of 10 ms.
TIMEOUTS_MS = (200, 200, 200, 200, 200, 200, 200)


def meta_language():
    commands = ", ".join(f"\"{name}\" = {code:#04X}".replace("0X", "0x") for name, code in COMMANDS.items())
    return META_LANGUAGE.replace("%COMMANDS%", commands)


def module(constants):
    """IF_DATA of the module."""
    commands = "\n".join(f"        OPTIONAL_CMD {name}" for name in COMMANDS)
    timeouts = " ".join(str(timeout) for timeout in TIMEOUTS_MS)
    return f"""\
    /begin IF_DATA XCP
      /begin PROTOCOL_LAYER
        0x0101 {timeouts} {constants["packet_length"]} {constants["packet_length"]}
        BYTE_ORDER_MSB_LAST ADDRESS_GRANULARITY_BYTE
{commands}
        SEED_AND_KEY_EXTERNAL_FUNCTION "{SEED_AND_KEY}"
      /end PROTOCOL_LAYER
      /begin DAQ
        DYNAMIC {constants["most_lists"]} 2 0
        OPTIMISATION_TYPE_DEFAULT ADDRESS_EXTENSION_FREE IDENTIFICATION_FIELD_TYPE_ABSOLUTE
        GRANULARITY_ODT_ENTRY_SIZE_DAQ_BYTE {constants["largest_entry"]} OVERLOAD_INDICATION_EVENT
        PRESCALER_SUPPORTED
        /begin TIMESTAMP_SUPPORTED 1 SIZE_WORD UNIT_100US /end TIMESTAMP_SUPPORTED
        /begin EVENT "every cycle, 10 ms" "10ms" 0 DAQ {constants["most_lists"]} 10 6 1 /end EVENT
        /begin EVENT "every tenth cycle, 100 ms" "100ms" 1 DAQ {constants["most_lists"]} 100 6 0 /end EVENT
      /end DAQ
      /begin PAG 1 FREEZE_SUPPORTED /end PAG
      /begin XCP_ON_CAN
        0x0101
        CAN_ID_MASTER {int(constants["command_identifier"]):#x}
        CAN_ID_SLAVE {int(constants["answer_identifier"]):#x}
        BAUDRATE 500000
      /end XCP_ON_CAN
    /end IF_DATA
"""


def segment(constants):
    """IF_DATA of the memory segment."""
    access = "ECU_ACCESS_DONT_CARE XCP_READ_ACCESS_DONT_CARE"
    return f"""\
        /begin IF_DATA XCP
          /begin SEGMENT 0 2 0 0 0
            /begin CHECKSUM XCP_CRC_32 MAX_BLOCK_SIZE {constants["parameters_length"]} /end CHECKSUM
            /begin PAGE 0 {access} XCP_WRITE_ACCESS_DONT_CARE INIT_SEGMENT 0 /end PAGE
            /begin PAGE 1 {access} XCP_WRITE_ACCESS_NOT_ALLOWED INIT_SEGMENT 0 /end PAGE
          /end SEGMENT
        /end IF_DATA
"""

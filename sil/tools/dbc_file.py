"""The statements of a DBC file that a strict parser takes. The others are left out or mended, each with its line and why."""

import collections
import re

# A line that is not as it should be: its number and what was done about it.
Odd = collections.namedtuple("Odd", "line what")

KEYWORDS = ("BO_", "SG_", "CM_", "VAL_", "VAL_TABLE_", "SIG_VALTYPE_", "SG_MUL_VAL_", "BA_DEF_", "BA_DEF_DEF_", "BA_", "BS_",
            "BU_", "NS_", "VERSION", "BO_TX_BU_", "SIG_GROUP_", "EV_", "EV_DATA_", "ENVVAR_DATA_", "BA_REL_", "BA_DEF_REL_",
            "BA_DEF_DEF_REL_", "BA_DEF_SGTYPE_", "BA_SGTYPE_", "SGTYPE_", "SGTYPE_VAL_", "SIG_TYPE_REF_", "SIGTYPE_VALTYPE_",
            "CAT_", "CAT_DEF_", "FILTER", "NS_DESC_", "BU_SG_REL_", "BU_EV_REL_", "BU_BO_REL_")
BEGINNING = re.compile(rf"\s*({'|'.join(KEYWORDS)})\b(?=[\s:\"]*[^\s:])|\s*(NS_|BS_|BU_)\s*:")
# Statements within a text that is not closed; any other line there is the text's.
CERTAIN = re.compile(r"\s*(?:BO_\s+\d+\s+\S+\s*:\s*\d|SG_\s+[^\s:]+(?:\s+[Mm]\w*)?\s*:\s*\d+\s*\||"
                     r"CM_\s+(?:(?:SG_|BO_)\s+\d|(?:BU_|EV_)\s+\S+\s+\"|\")|VAL_\s+\d+\s+\S+\s+-?\d|BA_(?:DEF_|DEF_DEF_)?\s+(?:\w+_\s+)?\"|SIG_VALTYPE_\s+\d|SG_MUL_VAL_\s+\d)")
NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?"
MESSAGE = re.compile(r"\s*BO_\s+(\w+)\s+([^\s:]+)\s*:\s*(\d+)(?:\s+(\S+))?\s*")
SIGNAL = re.compile(rf"\s*SG_\s+([^\s:]+)(?:\s+(M|m\d{{0,9}}M?))?\s*:\s*(\d+)\s*\|\s*(\d+)\s*@\s*([01])\s*([+-])\s*"
                    rf"\(\s*({NUMBER})\s*,\s*({NUMBER})\s*\)\s*(?:\[([^\]|]*)\|([^\]|]*)\])?\s*(?:\"(.*)\")?[^\"]*")
COMMENT = re.compile(r'\s*CM_\s+(?:(SG_|BO_|BU_|EV_)\s+([^\s"]+)(?:\s+([^\s"]+))?\s*)?"(.*)"\s*;?', re.DOTALL)
VALUES = re.compile(rf'\s*VAL_\s+(\d+)\s+([^\s"]+)((?:\s*{NUMBER}\s*"(?:\\"|[^"])*")*)\s*(?:;|\Z)')
VALUE = re.compile(rf'({NUMBER})\s*"((?:\\"|[^"])*)"')
FLOAT = re.compile(r"\s*SIG_VALTYPE_\s+(\d+)\s+([^\s:]+)\s*:?\s*(\d)\s*(?:;|\Z)")
PAGES = re.compile(r"\s*SG_MUL_VAL_\s+(\d+)\s+(\S+)\s+(\S+)\s+(\d+\s*-\s*\d+(?:[\s,]+\d+\s*-\s*\d+)*)\s*(?:;|\Z)")
DEFINITION = re.compile(r'\s*BA_DEF_\s+(?:(?:SG_|BO_|BU_|EV_)\s+)?"([^"]*)"\s+(\w+)([^;]*)(?:;|\Z)')
DEFAULT = re.compile(r'\s*BA_DEF_DEF_\s+"([^"]*)"\s*(?:"([^"]*)"|([^\s;]+))\s*(?:;|\Z)')
ATTRIBUTE = re.compile(r'\s*BA_\s+"([^"]*)"\s*(?:(BO_|SG_|BU_|EV_)\s+([^\s"]+)\s+)?(?:([^\s";]+)\s+)??'
                       r'(?:"([^"]*)"|([^\s";]+))\s*(?:;|\Z)')

# Numbers for which a strict parser takes memory and time without limit: places, lengths, pages and powers of ten.
HUGE = re.compile(r"^[ \t]*SG_[^:\n]*(?:\sm\d{10,}|:\s*\d{6,}|:\s*\d+\s*\|\s*\d{6,})|^[ \t]*BO_\s+\w+\s+\S+\s*:\s*\d{6,}|"
                  r"^[ \t]*SG_MUL_VAL_.*\d{6,}|\d[eE][-+]?\d{4,}", re.MULTILINE)

EXTENDED = 0x8000_0000
INDEPENDENT = (0xC000_0000, 0x4000_0000)  # signals of no message
LONGEST_MESSAGE = 4096
LONGEST_FRAME = 64  # of CAN FD, also where a file gives a shorter length
MOST_PAGES = 65_536
FORMAT = "VFrameFormat"  # from which cantools knows J1939 and CAN FD
FORMATS = ("StandardCAN", "ExtendedCAN", "reserved", "J1939PG", *["reserved"] * 10, "StandardCAN_FD", "ExtendedCAN_FD")
DEFINITIONS = ('BA_DEF_ BO_ "VFrameFormat" ENUM ' + ",".join(f'"{name}"' for name in FORMATS) + ";\n"
               'BA_DEF_ BO_ "SystemMessageLongSymbol" STRING ;\nBA_DEF_ SG_ "SystemSignalLongSymbol" STRING ;\n'
               'BA_DEF_DEF_ "VFrameFormat" "StandardCAN";\nBA_DEF_DEF_ "SystemMessageLongSymbol" "";\n'
               'BA_DEF_DEF_ "SystemSignalLongSymbol" "";\n')
BEGIN = 'VERSION ""\nNS_ :\nBS_:\nBU_: N\n'


def text_of(content):
    """Old DBC files are in the code page of Windows; newer tools write UTF-8."""
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", "replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", "replace")


def statements(text):
    """Number of the first line, keyword and lines of each."""
    number, keyword, lines, is_open = 1, "", [], False
    for current, line in enumerate(re.split(r"\r\n|\r|\n", text), 1):
        if line.lstrip().startswith("//"):
            continue
        begins = (CERTAIN if is_open else BEGINNING).match(line)
        if begins:
            yield number, keyword, lines
            number, keyword, lines, is_open = current, re.match(r"\s*(\w+)", line)[1], [], False
        lines.append(line)
        is_open ^= bool(line.replace('\\"', "").count('"') % 2) and keyword not in ("SG_", "BO_")
    yield number, keyword, lines


class Block:
    """A message, its signals, and the statements about them, for cantools."""

    def __init__(self, line, number, name, length):
        self.line, self.number, self.name, self.length = line, number, name, length
        self.signals = set()
        self.lines = []
        self.others = []

    def text(self):
        return "".join([f"BO_ {self.number} {self.name}: {self.length} N\n", *self.lines, "\n", *self.others])


class DbcFile:
    """The readable part of a DBC file: `blocks` by message, `odd` lines, and the `names` behind those that cantools would
    not take."""

    def __init__(self, text):
        self.blocks, self.odd, self.names = [], [], {}
        self._by_number = collections.defaultdict(dict)  # by identifier and signal; None: the message itself
        self._first_lines = {}    # of messages by identifier and by name
        self._block = None        # the signals that follow belong to it; None: left out with their message
        self._given = None        # its identifier as it stands in the file
        self._is_counted = True
        self._aliases = {}
        self._enumerations = {FORMAT: FORMATS}  # values of each attribute that has such; None for another one
        self._formats = {}        # by message
        self._default_format = ""
        readers = {"": self._no_statement, "BO_": self._message, "SG_": self._signal, "CM_": self._comment, "VAL_": self._values,
                   "SIG_VALTYPE_": self._float, "SG_MUL_VAL_": self._pages, "BA_DEF_": self._definition,
                   "BA_DEF_DEF_": self._default, "BA_": self._attribute, "BS_": self._timing}
        # Statements may stand before what they are about.
        order = {"": 0, "BO_": 0, "SG_": 0, "BS_": 0, "BA_DEF_": 0, "BA_DEF_DEF_": 1}
        found = [statement for statement in statements(text) if statement[1] in readers]
        for line, keyword, lines in sorted(found, key=lambda statement: order.get(statement[1], 2)):
            readers[keyword](line, lines)
        for block in self.blocks:
            name = self._formats.get(block, self._default_format)
            if name in FORMATS:
                block.others.append(f'BA_ "VFrameFormat" BO_ {block.number} {FORMATS.index(name)};\n')
        self.odd.sort()

    def _leave_out(self, line, what):
        self.odd.append(Odd(line, f"{what}: left out"))

    def _alias(self, name):
        """A name that cantools takes."""
        if re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name) and name not in KEYWORDS:
            return name
        if name not in self._aliases:
            self._aliases[name] = f"alias_{len(self._aliases)}_of_a_name"
            self.names[self._aliases[name]] = name
        return self._aliases[name]

    def _whole(self, pattern, line, lines, what):
        """The match of a statement that may go over several lines; None if it is left out."""
        text = "\n".join(lines)
        match = pattern.match(text)
        if match is None:
            self._leave_out(line, what)
            return None
        self._rest(line + text.count("\n", 0, match.end()), text[match.end():])
        return match

    def _rest(self, line, text):
        """Lines behind a statement that belong to none."""
        for number, rest in enumerate(text.split("\n"), line):
            if rest.strip(" \t;"):
                self._leave_out(number, "this is no statement of a DBC file")

    def _no_statement(self, line, lines):
        self._rest(line, "\n".join(lines))

    def _timing(self, line, lines):
        if not re.fullmatch(r"\s*BS_\s*:[\s;]*", lines[0]):
            self._leave_out(line, "the bit timing is not needed")
        self._rest(line + 1, "\n".join(lines[1:]))

    def _message(self, line, lines):
        self._block, self._is_counted = None, True
        match = MESSAGE.match(lines[0]) or MESSAGE.match(" ".join(lines))
        if match is None:
            self._leave_out(line, "this is no message, such as BO_ 36 NAME: 8 SENDER")
            return
        if lines[0].strip() and MESSAGE.match(lines[0]):
            self._rest(line + 1, "\n".join(lines[1:]))
        try:
            number = given = int(match[1], 0)
        except ValueError:
            self._leave_out(line, f"'{match[1]}' is no identifier")
            return
        if number in INDEPENDENT:
            self._is_counted = False
            return
        is_extended, number = bool(number & EXTENDED), number & ~EXTENDED
        if number > 0x1FFF_FFFF:
            self._leave_out(line, f"message {match[2]}'s identifier {given} has more than 29 bits")
            return
        if len(match[3]) > 4 or int(match[3]) > LONGEST_MESSAGE:
            self._leave_out(line, f"message {match[2]} of {match[3]} bytes")
            return
        if number > 0x7FF and not is_extended:
            self.odd.append(Odd(line, f"message {match[2]}'s identifier {given} has more than 11 bits, but not bit 31 that "
                                      "should say so: read as one of 29"))
            is_extended = True
        self._block = Block(line, number | (EXTENDED if is_extended else 0), self._alias(match[2]), int(match[3]))
        number, name = self._block.number, self._block.name
        if number in self._first_lines:
            self.odd.append(Odd(line, f"message {match[2]} has the identifier {given} of the message in line "
                                      f"{self._first_lines[number]}: both are read"))
        elif name in self._first_lines:
            self.odd.append(Odd(line, f"a second message {match[2]}: of signals of the same name that in line "
                                      f"{self._first_lines[name]} counts"))
        self._first_lines.setdefault(number, line)
        self._first_lines.setdefault(name, line)
        self.blocks.append(self._block)
        for key in {given, self._block.number}:
            self._by_number[key].setdefault(None, self._block)
        self._given = given

    def _signal(self, line, lines):
        match = SIGNAL.fullmatch(lines[0])
        if match:
            self._rest(line + 1, "\n".join(lines[1:]))
        match = match or SIGNAL.fullmatch(" ".join(lines))
        if self._block is None:
            if self._is_counted:
                self._leave_out(line, "a signal without its message")
            return
        if match is None:
            self._leave_out(line, "this is no signal, such as SG_ NAME : 8|16@1- (0.01,0) [-300|300] \"deg/s\" RECEIVER")
            return
        name, page, start, length, order, sign, factor, offset, low, high, unit = match.groups()
        if name in self._block.signals:
            self._leave_out(line, f"a second signal {name} in its message")
            return
        bits = 8 * max(self._block.length, LONGEST_FRAME)
        if not 0 < int(length) <= bits or int(start) >= bits:
            self._leave_out(line, f"signal {name} of {length} bits from bit {start} on")
            return
        first = int(start) if order == "1" else int(start) // 8 * 8 + 7 - int(start) % 8
        if first + int(length) > 8 * self._block.length:
            self.odd.append(Odd(line, f"signal {name} reaches beyond the {self._block.length} bytes of its message"))
        if not re.fullmatch(rf"\s*{NUMBER}\s*\|\s*{NUMBER}\s*", f"{low}|{high}"):
            low = high = "0"
        numbers = [plain(number) for number in (factor, offset, low, high)]
        self._block.signals.add(name)
        if page == "m":
            self.odd.append(Odd(line, f"signal {name} is on no page of a number: read as what says which page is sent"))
            page = "M"
        for key in {self._given, self._block.number}:
            self._by_number[key].setdefault(name, self._block)
        self._block.lines.append(f" SG_ {self._alias(name)}{' ' + page if page else ''} : {start}|{length}@{order}{sign} "
                                 f"({numbers[0]},{numbers[1]}) [{numbers[2]}|{numbers[3]}] \"{quotable(unit or '')}\" N\n")

    def _about(self, line, number, name=None):
        """The block of what a statement is about; none if that is not there."""
        known = self._by_number.get(int(number)) if number.isascii() and number.isdigit() else None
        if known and name in known:
            return [known[name]]
        if not known and number not in map(str, INDEPENDENT):
            self._leave_out(line, f"it is about message {number}, which is not there")
        elif known:
            self._leave_out(line, f"it is about a signal {name}, which message {number} has not")
        return []

    def _comment(self, line, lines):
        match = self._whole(COMMENT, line, lines, "this is no comment, such as CM_ SG_ 36 NAME \"TEXT\";")
        if match is None or match[1] in (None, "BU_", "EV_"):
            return
        if match[1] == "SG_" and match[3] is None:
            self._leave_out(line, "a signal's comment without the signal's name")
            return
        for block in self._about(line, match[2], match[3] if match[1] == "SG_" else None):
            if match[1] == "SG_":
                block.others.append(f"CM_ SG_ {block.number} {self._alias(match[3])} \"{quotable(match[4])}\";\n")

    def _values(self, line, lines):
        if not re.match(r"\s*VAL_\s+\d", lines[0]):
            return  # of an environment variable
        match = self._whole(VALUES, line, lines, "these are no texts of values, such as VAL_ 36 NAME 0 \"off\" 1 \"on\";")
        for block in self._about(line, match[1], match[2]) if match else ():
            texts = [f"{int(float(value))} \"{quotable(text)}\"" for value, text in VALUE.findall(match[3])
                     if abs(float(value)) < 2.0**64]
            block.others.append(f"VAL_ {block.number} {self._alias(match[2])} {' '.join(texts)} ;\n")

    def _float(self, line, lines):
        match = self._whole(FLOAT, line, lines, "this is no kind of a signal, such as SIG_VALTYPE_ 36 NAME : 1;")
        for block in self._about(line, match[1], match[2]) if match and match[3] != "0" else ():
            block.others.append(f"SIG_VALTYPE_ {block.number} {self._alias(match[2])} : {match[3]};\n")

    def _pages(self, line, lines):
        match = self._whole(PAGES, line, lines, "these are no pages of a signal, such as SG_MUL_VAL_ 36 NAME PAGE 0-3;")
        if match is None:
            return
        ranges = [(int(first), int(last)) for first, last in re.findall(r"(\d+)\s*-\s*(\d+)", match[4])]
        if sum(max(last - first + 1, 0) for first, last in ranges) > MOST_PAGES:
            self._leave_out(line, f"signal {match[2]} on more than {MOST_PAGES} pages")
            return
        for block in self._about(line, match[1], match[2]):
            if match[3] in block.signals:
                spans = ", ".join(f"{first}-{last}" for first, last in ranges)
                block.others.append(f"SG_MUL_VAL_ {block.number} {self._alias(match[2])} {self._alias(match[3])} {spans};\n")
            else:
                self._leave_out(line, f"it is about a signal {match[3]}, which message {match[1]} has not")

    def _definition(self, line, lines):
        match = self._whole(DEFINITION, line, lines, "this is no definition of an attribute, such as BA_DEF_ \"NAME\" INT 0 9;")
        if match:
            numbered = FORMATS if match[1] == FORMAT else None
            self._enumerations[match[1]] = re.findall(r'"([^"]*)"', match[3]) if match[2] == "ENUM" else numbered

    def _default(self, line, lines):
        match = self._whole(DEFAULT, line, lines, "this is no default of an attribute, such as BA_DEF_DEF_ \"NAME\" 0;")
        if match is None:
            return
        value = self._value(line, match[1], match[2], match[3])
        if match[1] == FORMAT and value is not None:
            self._default_format = value

    def _attribute(self, line, lines):
        match = self._whole(ATTRIBUTE, line, lines, "this is no attribute's value, such as BA_ \"NAME\" BO_ 36 5;")
        if match is None:
            return
        value = self._value(line, match[1], match[5], match[6])
        if value is None or match[2] not in ("BO_", "SG_"):
            return
        for block in self._about(line, match[3], match[4] if match[2] == "SG_" else None):
            if match[1] == FORMAT:
                self._formats[block] = value
            elif match[1] == "SystemMessageLongSymbol" and match[2] == "BO_":
                block.others.append(f"BA_ \"{match[1]}\" BO_ {block.number} \"{quotable(value)}\";\n")
            elif match[1] == "SystemSignalLongSymbol" and match[2] == "SG_":
                block.others.append(f"BA_ \"{match[1]}\" SG_ {block.number} {self._alias(match[4])} \"{quotable(value)}\";\n")

    def _value(self, line, name, text, number):
        """An attribute's value as a text; None if it is left out."""
        if name not in self._enumerations:
            self._leave_out(line, f"no attribute {name} is defined")
            return None
        names = self._enumerations[name]
        if names is None or text is not None:
            return text if text is not None else number
        if not number.isascii() or not number.isdigit() or int(number) >= len(names):
            self._leave_out(line, f"attribute {name} has no value number {number}")
            return None
        return names[int(number)]


def plain(number):
    """A number's text as cantools takes it."""
    text = number.strip()
    return re.sub(r"^([-+]?)\.", r"\g<1>0.", text)


def quotable(text):
    return re.sub(r'\\?"', "'", text).replace("\\", "/")

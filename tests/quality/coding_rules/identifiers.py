"""Rules on tokens: what may not be named at all, whatever it would mean. Comments and strings do not count."""

import bisect
import re

from findings import PROJECT, Finding

_TOKEN = re.compile(
    r"""(?P<comment>//(?:[^\n\\]|\\.|\\\n)*|/\*.*?\*/)
      |(?P<string>R"(?P<end>[^()\s\\]*)\(.*?\)(?P=end)"|"(?:[^"\\\n]|\\.)*")
      |(?P<number>\.?[0-9](?:[eEpP][+-]|'(?=[0-9A-Za-z])|[0-9A-Za-z_.])*)
      |(?P<character>'(?:[^'\\\n]|\\.)+')
      |(?P<name>[A-Za-z_]\w*)
      |(?P<directive>^[ \t]*\#[ \t]*\w+)
      |(?P<sign>::|->|&&|\|\||<<|>>|[-+*/%^&|<>=!]=|\+\+|--|\.\.\.|[^\s\w])""",
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)

# Headers that make neither heap nor streams nor threads necessary.
HEADERS = {
    "array", "cstddef", "cstdint", "cstring", "limits", "new", "numeric", "stdint.h", "type_traits", "utility",
    "Eigen/Core",
}

# rule: what to do, and the names.
NAMES = {
    "heap": (
        "take the memory from the caller",
        "malloc calloc realloc free aligned_alloc delete make_unique make_shared unique_ptr shared_ptr allocator",
    ),
    "exceptions": ("answer with a value", "throw try catch exception_ptr rethrow_exception"),
    "run-time-type": ("decide at compile time, or by a virtual function", "dynamic_cast typeid type_info any_cast"),
    "jump": ("leave by return, or split the function", "goto setjmp longjmp sigsetjmp siglongjmp jmp_buf"),
    "volatile": ("registers are read and written by hal/zynqmp_r5/registers.hpp", "volatile"),
    "assembly": ("leave it to the board's start-up code", "asm __asm __asm__"),
    "reinterpret-cast": ("convert the value, or copy the bytes", "reinterpret_cast bit_cast launder"),
    "const-cast": ("pass it as what it is", "const_cast"),
    "union": ("use a struct, or copy the bytes", "union variant"),
    "double": ("compute in float: many targets have hardware for float only", "double double_t"),
    "integer-type": ("say the width: std::int32_t, std::uint64_t", "short long signed wchar_t __int128"),
    "thread": ("one component is one thread's; state is its owner's", "thread_local thread mutex atomic"),
    "offset": ("write bytes one by one", "offsetof"),
    "obsolete": ("C++ has a keyword or an operator for it", "NULL register"),
    "variable-arguments": ("give the arguments types", "va_list va_start va_arg va_end"),
    "suppression": ("put it right, or enter it with its reason in tests/quality/coding_rules/allowed.toml", "_Pragma"),
}
# Only from namespace std, or from none.
FUNCTIONS = {
    "standard-library": (
        "not on a bare target; what is allowed is in identifiers.py",
        "function string vector map set list deque unordered_map any optional string_view stringstream cout cerr cin "
        "endl ostream istream thread chrono regex filesystem initializer_list exception runtime_error",
    ),
    "environment": (
        "time, chance and environment come from the caller",
        "rand srand time clock localtime gmtime getenv setenv system exit abort _Exit quick_exit atexit terminate raise "
        "signal random_device errno setlocale assert",
    ),
    "c-library": (
        "not on a bare target: use the types' own operations, std::memcpy where bytes are copied",
        "printf sprintf snprintf fprintf puts putchar scanf sscanf fopen fread fwrite atoi atof atol strtol strtof strtod "
        "strcpy strcat strcmp strlen strncpy memcmp isdigit isalpha toupper qsort bsearch",
    ),
}
# Eigen's types of a size that is known at run time only, and where its class templates may be named: another
# fixed size gets a name there.
DYNAMIC_MATRIX = re.compile(r"(Matrix|Vector|RowVector|Array)[234]?X\w*|Dynamic|DynamicIndex")
MATRIX_TEMPLATES = {"Matrix", "Array", "Map", "Ref", "Tensor", "SparseMatrix"}
MATRIX_HEADER = "firmware/rsi/numeric/matrix.hpp"

# Marks in comments. Joined from halves, so that a search for marks does not find this line.
MARKS = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b")
SUPPRESSIONS = re.compile(r"\b(NOLINT\w*|cppcheck-suppress|IWYU pragma)\b")

# Everything that `rules()` may answer; planted_test and document_test hold the document to it.
RULES = sorted(
    {*NAMES, *FUNCTIONS, "placement-new", "dynamic-matrix", "header", "pragma", "unbounded-loop", "static-local", "enum-type",
     "unscoped-enum", "bit-field", "octal", "else-if-without-else", "mark", "include-guard", "function-macro"}
)
_BY_NAME = {name: (rule, what) for rule, (what, names) in NAMES.items() for name in names.split()}
_BY_FUNCTION = {name: (rule, what) for rule, (what, names) in FUNCTIONS.items() for name in names.split()}


class Token:
    def __init__(self, kind, text, line):
        self.kind, self.text, self.line = kind, text, line

    def __repr__(self):
        return self.text


def tokens_of(text):
    ends = [match.start() for match in re.finditer("\n", text)]
    for match in _TOKEN.finditer(text):
        yield Token(match.lastgroup if match.lastgroup != "end" else "string", match.group(),
                    bisect.bisect_left(ends, match.start()) + 1)


class Source:
    """One file's tokens, and what is found in them."""

    def __init__(self, path):
        self.path = path
        text = (PROJECT / path).read_text(encoding="utf-8")
        all_tokens = list(tokens_of(text))
        self.comments = [token for token in all_tokens if token.kind == "comment"]
        self.tokens = [token for token in all_tokens if token.kind != "comment"]
        self.lines = text.splitlines()
        self.findings = []

    def found(self, token, rule, what):
        self.findings.append(Finding(self.path, token.line, rule, what))

    def text_at(self, index):
        return self.tokens[index].text if 0 <= index < len(self.tokens) else ""

    def kind_at(self, index):
        return self.tokens[index].kind if 0 <= index < len(self.tokens) else ""

    def closing(self, index):
        """Index of the bracket that closes the one at `index`."""
        pairs = {"(": ")", "{": "}", "[": "]"}
        opening, closing = self.text_at(index), pairs[self.text_at(index)]
        depth = 0
        for at in range(index, len(self.tokens)):
            depth += (self.text_at(at) == opening) - (self.text_at(at) == closing)
            if depth == 0:
                return at
        return len(self.tokens)


def rules(path):
    """All findings in one file."""
    source = Source(path)
    _check_comments(source)
    _check_include_guard(source)
    for index, token in enumerate(source.tokens):
        if token.kind == "name":
            _check_name(source, index, token)
        elif token.kind == "number":
            _check_number(source, token)
        elif token.kind == "directive":
            _check_directive(source, index, token)
        elif token.text == ":":
            _check_bit_field(source, index, token)
    _check_static_locals(source)
    return source.findings


def _check_comments(source):
    for comment in source.comments:
        for offset, line in enumerate(comment.text.split("\n")):
            place = Token("comment", line, comment.line + offset)
            mark = MARKS.search(line)
            if mark:
                source.found(place, "mark", f"{mark.group()}: do it, or open an issue")
            suppression = SUPPRESSIONS.search(line)
            if suppression:
                source.found(place, "suppression", f"{suppression.group()}: {NAMES['suppression'][0]}")


def _check_include_guard(source):
    if not source.path.endswith((".h", ".hpp")):
        return
    first = [token.text for token in source.tokens[:2]]
    guarded = bool(first) and (re.fullmatch(r"#\s*pragma", first[0].strip()) and first[1:] == ["once"]
                               or re.fullmatch(r"#\s*ifndef", first[0].strip()))
    if not guarded:
        source.found(Token("", "", 1), "include-guard", "begin the header with #pragma once")


def _is_from_elsewhere(source, index):
    """Behind a dot, an arrow or a namespace other than std; or the name of something that is declared here."""
    before = source.text_at(index - 1)
    if before == "::":
        return source.kind_at(index - 2) == "name" and source.text_at(index - 2) != "std"
    return before in (".", "->")


def _check_name(source, index, token):
    text = token.text
    if re.fullmatch(r"\s*#\s*include", source.text_at(index - 2)):
        return
    if DYNAMIC_MATRIX.fullmatch(text) or _is_matrix_template(source, index, text):
        source.found(token, "dynamic-matrix", f"{text}: use a type of rsi/numeric/matrix.hpp, of fixed size")
    elif text == "new":
        _check_new(source, index, token)
    elif text in _BY_NAME and not _is_from_elsewhere(source, index):
        rule, what = _BY_NAME[text]
        deleted_function = text == "delete" and source.text_at(index - 1) == "="
        of_assembly = text == "volatile" and source.text_at(index - 1) == "asm"
        if not deleted_function and not of_assembly:
            source.found(token, rule, f"{text}: {what}")
    elif text in _BY_FUNCTION and not _is_from_elsewhere(source, index):
        rule, what = _BY_FUNCTION[text]
        of_std = source.text_at(index - 1) == "::"
        declared = source.kind_at(index - 1) == "name" and source.text_at(index - 1) not in ("return", "else", "do")
        called = source.text_at(index + 1) == "(" and not declared
        if of_std or called:
            source.found(token, rule, f"{text}: {what}")
    elif text == "while":
        if source.text_at(index + 1) == "(" and source.text_at(index + 2) in ("true", "1", "1U") \
                and source.text_at(index + 3) == ")":
            source.found(token, "unbounded-loop", "give the loop a bound that can be read")
    elif text == "for":
        _check_for(source, index, token)
    elif text == "enum":
        _check_enum(source, index, token)
    elif text == "else" and source.text_at(index + 1) == "if":
        _check_else_if(source, index, token)


def _is_matrix_template(source, index, text):
    from_eigen = source.text_at(index - 1) == "::" and source.text_at(index - 2) == "Eigen"
    return text in MATRIX_TEMPLATES and from_eigen and source.path != MATRIX_HEADER


def _check_new(source, index, token):
    if source.text_at(index - 1) == "operator" or source.text_at(index + 1) != "(":
        source.found(token, "heap", "new: take the memory from the caller")
    else:
        source.found(token, "placement-new", "new: construct in the declaration")


def _check_for(source, index, token):
    close = source.closing(index + 1)
    head = [source.text_at(at) for at in range(index + 2, close)]
    if head.count(";") == 2 and head[head.index(";") + 1] == ";":
        source.found(token, "unbounded-loop", "give the loop a bound that can be read")


def _check_enum(source, index, token):
    scoped = source.text_at(index + 1) in ("class", "struct")
    if not scoped:
        source.found(token, "unscoped-enum", "enum: write enum class")
    name = index + 2 if scoped else index + 1
    if scoped and source.text_at(name + 1) == "{":
        source.found(token, "enum-type", "say the type that it is kept in: enum class Name : std::uint8_t")


def _check_else_if(source, index, token):
    body = source.closing(index + 2) + 1
    if source.text_at(body) == "{" and source.text_at(source.closing(body) + 1) != "else":
        source.found(token, "else-if-without-else", "end the chain with an else, if only to say why nothing is to be done")


def _check_number(source, token):
    text = token.text.replace("'", "")
    if re.fullmatch(r"0[0-7]+[uUlL]*", text):
        source.found(token, "octal", f"{token.text}: write it as a decimal, hexadecimal or binary number")
    hexadecimal = text.lower().startswith("0x")
    binary = text.lower().startswith("0b")
    floating = "." in text or (not hexadecimal and not binary and "e" in text.lower()) or (hexadecimal and "p" in text.lower())
    if floating and not text.lower().endswith("f"):
        source.found(token, "double", f"{token.text}: write {token.text}F")


def _check_directive(source, index, token):
    name = token.text.strip().lstrip("#").strip()
    if name == "include" and source.text_at(index + 1) == "<":
        header = ""
        at = index + 2
        while source.text_at(at) not in (">", ""):
            header += source.text_at(at)
            at += 1
        if header not in HEADERS:
            source.found(token, "header", f"<{header}> is not on the list of identifiers.py")
    elif name == "pragma" and source.text_at(index + 1) != "once":
        source.found(token, "pragma", "no pragma but once; warnings are put right, not switched off")
    elif name == "define":
        line = source.lines[token.line - 1]
        if re.match(r"\s*#\s*define\s+\w+\(", line):
            source.found(token, "function-macro", "write a function, or a template")


def _check_bit_field(source, index, token):
    if source.kind_at(index + 1) != "number" or source.text_at(index + 2) not in (";", "{", "="):
        return
    at = index - 1
    while at >= 0 and source.text_at(at) not in (";", "{", "}"):
        if source.text_at(at) in ("?", "case"):
            return
        at -= 1
    if source.kind_at(index - 1) == "name" and source.kind_at(index - 2) == "name":
        source.found(token, "bit-field", "keep whole integers; take bits with masks")


def _check_static_locals(source):
    """`static` within a function: state that outlives the call and has no owner."""
    functions = []  # of each open brace: is it a function's, or within one
    start = 0
    for index, token in enumerate(source.tokens):
        if token.text == "{":
            head = [source.text_at(at) for at in range(start, index)]
            scope = any(word in ("namespace", "class", "struct", "enum", "extern", "union") for word in head)
            functions.append((bool(functions) and functions[-1]) or not scope or (")" in head and "extern" not in head))
        elif token.text == "}" and functions:
            functions.pop()
        if token.text in (";", "{", "}") or token.kind == "directive":
            start = index + 1
        if token.text == "static" and functions and functions[-1] \
                and "constexpr" not in (source.text_at(index + 1), source.text_at(index - 1)):
            source.found(token, "static-local", "make it a member of the object that the caller owns")

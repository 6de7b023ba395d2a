"""Writes mutant schemata: a source in which every mutant sleeps until its number is called.

A mutant is a small change of one place: an operator, a condition, a constant, a statement, a returned value, an argument.
The syntax tree is clang's; the change is made in the text, so whatever is not mutated stays as it was.
"""

import collections
import dataclasses
import re

import clang.cindex
from clang.cindex import CursorKind as Kind, TypeKind

clang.cindex.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")

FLOATS = {TypeKind.FLOAT, TypeKind.DOUBLE}
INTEGERS = {TypeKind.BOOL, TypeKind.CHAR_S, TypeKind.CHAR_U, TypeKind.SCHAR, TypeKind.UCHAR, TypeKind.SHORT,
            TypeKind.USHORT, TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG,
            TypeKind.ULONGLONG}
DEPENDENT = {TypeKind.DEPENDENT, TypeKind.UNEXPOSED, TypeKind.INVALID}
SWAPS = {"+": ("plus", "-"), "-": ("minus", "+"), "*": ("times", "/"), "/": ("over", "*"), "%": ("rest", "*"),
         "<<": ("left", ">>"), ">>": ("right", "<<"), "&": ("bit_and", "|"), "|": ("bit_or", "&"), "^": ("bit_xor", "&")}
RELATIONS = {"<": ("less", ("<=", ">=")), "<=": ("less_equal", ("<", ">")), ">": ("greater", (">=", "<=")),
             ">=": ("greater_equal", (">", "<")), "==": ("equal", ("!=",)), "!=": ("unequal", ("==",))}
BOUNDING = {"smaller": ("Smaller", ("the first argument", "the second argument")),
            "larger": ("Larger", ("the first argument", "the second argument")),
            "clamp": ("Clamp", ("no lower bound", "no upper bound")),
            "clamp_magnitude": ("ClampMagnitude", ("no bound",)),
            "absolute": ("Absolute", ("the sign stays",))}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR, Kind.CONVERSION_FUNCTION,
             Kind.FUNCTION_TEMPLATE}
CLASSES = {Kind.CLASS_DECL, Kind.STRUCT_DECL, Kind.CLASS_TEMPLATE}
HANDLED = {Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.UNARY_OPERATOR, Kind.INTEGER_LITERAL,
           Kind.FLOATING_LITERAL, Kind.CXX_BOOL_LITERAL_EXPR, Kind.DECL_REF_EXPR, Kind.IF_STMT, Kind.WHILE_STMT,
           Kind.CONDITIONAL_OPERATOR, Kind.RETURN_STMT, Kind.FOR_STMT}
NUMBER = re.compile(r"^[0-9.][0-9A-Fa-fxX.'+-]*[uUlLfF]*$|^[0-9.]+[eE][-+]?[0-9]+[fF]?$")


@dataclasses.dataclass
class Mutant:
    id: int
    file: str
    line: int
    function: str
    operator: str
    original: str
    mutated: str

    def key(self):
        return self.file, self.function, self.operator, self.original, self.mutated

    def __str__(self):
        return f"{self.file}:{self.line} {self.function}: {self.operator}: `{self.original}` -> `{self.mutated}`"


def plain(text):
    return re.sub(r"\s+", " ", text).strip()


class Mutator:
    """Numbers the mutants over all files: constants first, for a constant of one file is used in others."""

    def __init__(self):
        self.mutants = []
        self.skipped = collections.Counter()
        self._constants = {}  # USR: first mutant

    def _new(self, file, line, function, operator, original, *mutated):
        first = len(self.mutants) + 1
        for text in mutated:
            self.mutants.append(Mutant(len(self.mutants) + 1, file, line, function, operator, plain(original), plain(text)))
        return first

    def parse(self, path, arguments):
        unit = clang.cindex.Index.create().parse(str(path), arguments)
        bad = [d for d in unit.diagnostics if d.severity >= clang.cindex.Diagnostic.Error]
        if bad:
            raise SystemExit(f"mutation: clang cannot read {path}: {bad[0]}")
        return unit

    def find_constants(self, name, path, unit):
        source = Source(self, name, path, unit)
        source.find_constants(unit.cursor)

    def mutated(self, name, path, unit, left_out=frozenset()):
        """`left_out`: lines without mutants."""
        source = Source(self, name, path, unit, left_out)
        source.visit_children(unit.cursor)
        return source.text()


class Source:
    def __init__(self, mutator, name, path, unit, left_out=frozenset()):
        self._left_out = left_out
        self._seen = set()
        self._all = mutator
        self._name = name
        self._path = str(path)
        self._bytes = path.read_bytes()
        self._unit = unit
        self._before, self._after, self._instead = collections.defaultdict(list), collections.defaultdict(list), {}
        self._function = ""

    # What is where.
    def _start(self, cursor):
        return cursor.extent.start.offset

    def _end(self, cursor):
        return cursor.extent.end.offset

    def _text_of(self, cursor):
        return self._bytes[self._start(cursor):self._end(cursor)].decode()

    def _here(self, cursor):
        file = cursor.extent.start.file
        return file is not None and file.name == self._path

    def _kind(self, cursor):
        return cursor.type.get_canonical().kind

    def _is_number(self, cursor):
        return self._kind(cursor) in FLOATS | INTEGERS

    def _new(self, cursor, operator, original, *mutated):
        return self._all._new(self._name, cursor.extent.start.line, self._function, operator, original, *mutated)

    def _skip(self, why):
        self._all.skipped[why] += 1

    # Changes of the text.
    def _wrap(self, cursor, prefix, suffix=")"):
        self._before[self._start(cursor)].append(prefix)
        self._after[self._end(cursor)].append(suffix)

    def _replace(self, start, end, text):
        self._instead[start] = (end, text)

    def text(self):
        out, at = [], 0
        positions = sorted({*self._before, *self._after, *self._instead, len(self._bytes)})
        for position in positions:
            if position < at:
                raise SystemExit(f"mutation: {self._name}: two changes of one place at byte {position}")
            out.append(self._bytes[at:position].decode())
            at = position
            out += reversed(self._after.get(position, []))
            out += self._before.get(position, [])
            if position in self._instead:
                at, replacement = self._instead[position]
                out.append(replacement)
        return "".join(out)

    def _between(self, left, right):
        """The operator between two operands: where it begins, where it ends, what it is."""
        start, end = self._end(left), self._start(right)
        gap = self._bytes[start:end].decode()
        bare = re.sub(r"//[^\n]*|/\*.*?\*/", lambda found: " " * len(found.group()), gap, flags=re.S)
        found = re.search(r"\.\*|->\*|[-+*/%<>=!&|^]+", bare)
        if not found:
            return None
        return start + found.start(), start + found.end(), found.group()

    # Constants: mutated where they are used, so that they stay constants.
    def _is_constant(self, cursor):
        if cursor.kind != Kind.VAR_DECL or not self._is_number(cursor):
            return False
        return "constexpr" in [token.spelling for token in cursor.get_tokens()][:4]

    def find_constants(self, cursor):
        for child in cursor.get_children():
            if not self._here(child):
                continue
            if self._is_constant(child) and child.get_usr() not in self._all._constants:
                self._all._constants[child.get_usr()] = self._numbers(child, child.spelling, "constant")
            named = child.kind in FUNCTIONS
            outer = self._function
            self._function = self._full_name(child) if named else self._function
            self.find_constants(child)
            self._function = outer

    def _full_name(self, cursor):
        parent = cursor.semantic_parent
        return f"{parent.spelling}::{cursor.spelling}" if parent and parent.kind in CLASSES else cursor.spelling

    def _numbers(self, cursor, text, operator):
        if self._kind(cursor) in FLOATS:
            zero = re.fullmatch(r"0*\.?0*[fF]?", text)
            steps = (f"{text} + 1", f"{text} - 1") if zero else (f"{text} * 1.1", f"{text} * 0.9")
            return self._new(cursor, operator, text, *steps)
        steps = [f"{text} + 1", f"{text} - 1"]
        if not re.fullmatch(r"(0x)?0*[01][uUlL]*", text):
            steps.append("0")
        return self._new(cursor, operator, text, *steps)

    # The walk.
    def visit_children(self, cursor):
        for child in cursor.get_children():
            if self._here(child):
                self.visit(child, cursor)

    def visit(self, cursor, parent):
        kind = cursor.kind
        if cursor.extent.start.line in self._left_out and kind not in FUNCTIONS | CLASSES | {
                Kind.COMPOUND_STMT, Kind.NAMESPACE}:
            self._skip("line that does not compile when mutated")
            return
        if kind in FUNCTIONS:
            outer, self._function = self._function, self._full_name(cursor)
            for child in cursor.get_children():
                if child.kind in (Kind.COMPOUND_STMT, Kind.PARM_DECL, Kind.CXX_TRY_STMT):
                    self.visit(child, cursor)
            self._function = outer
            return
        if kind == Kind.STATIC_ASSERT or kind == Kind.ENUM_DECL or kind == Kind.ENUM_CONSTANT_DECL:
            self._skip("static_assert, enumerator")
            return
        if kind == Kind.UNEXPOSED_DECL and b"constexpr" in self._bytes[self._start(cursor):self._end(cursor)]:
            self._skip("constant that is no number: a table, a structure")
            return
        if kind == Kind.LAMBDA_EXPR:
            self.visit_children(cursor)
            return
        if kind in (Kind.VAR_DECL, Kind.FIELD_DECL, Kind.PARM_DECL):
            self._declaration(cursor, parent)
            return
        if kind == Kind.CASE_STMT:
            self._skip("case label")
            for child in list(cursor.get_children())[1:]:
                self.visit(child, cursor)
            return
        place = kind, self._start(cursor), self._end(cursor)
        if kind != Kind.CALL_EXPR and kind in HANDLED:
            if place in self._seen:  # a template's instance
                return
            self._seen.add(place)
        self._statement(cursor, parent)
        handler = {Kind.BINARY_OPERATOR: self._binary, Kind.COMPOUND_ASSIGNMENT_OPERATOR: self._compound,
                   Kind.UNARY_OPERATOR: self._unary, Kind.CALL_EXPR: self._call, Kind.INTEGER_LITERAL: self._literal,
                   Kind.FLOATING_LITERAL: self._literal, Kind.CXX_BOOL_LITERAL_EXPR: self._truth,
                   Kind.DECL_REF_EXPR: self._reference, Kind.IF_STMT: self._condition,
                   Kind.WHILE_STMT: self._condition, Kind.CONDITIONAL_OPERATOR: self._condition,
                   Kind.RETURN_STMT: self._return, Kind.FOR_STMT: self._for}.get(kind)
        if handler is None or handler(cursor) is not False:
            if kind != Kind.FOR_STMT:
                self.visit_children(cursor)

    def _declaration(self, cursor, parent):
        """Only the initial value; a number before the name belongs to the type."""
        if "constexpr" in [token.spelling for token in cursor.get_tokens()][:4]:
            if not self._is_constant(cursor):
                self._skip("constant that is no number: a table, a structure")
            return
        if cursor.kind == Kind.FIELD_DECL and any(child.spelling == "init" for child in parent.get_children()):
            self._skip("initial value of a member that init() replaces")
            return
        for child in cursor.get_children():
            before = self._bytes[:self._start(child)].rstrip()[-1:]
            if self._here(child) and self._start(child) > cursor.location.offset and before != b"[":
                self.visit(child, cursor)

    # Statements.
    def _statement(self, cursor, parent):
        if parent.kind != Kind.COMPOUND_STMT:
            return
        deletes = cursor.kind in (Kind.CALL_EXPR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.CXX_STATIC_CAST_EXPR)
        if cursor.kind == Kind.BINARY_OPERATOR:
            deletes = True
        if cursor.kind == Kind.UNARY_OPERATOR:
            deletes = "++" in self._text_of(cursor) or "--" in self._text_of(cursor)
        if cursor.kind == Kind.UNEXPOSED_EXPR:
            deletes = self._bytes[self._end(cursor):].lstrip()[:1] == b";"
        if cursor.kind == Kind.RETURN_STMT:
            deletes = not list(cursor.get_children())
        if not deletes:
            return
        end = self._bytes.index(b";", self._end(cursor)) + 1
        mutant = self._new(cursor, "statement", self._text_of(cursor), "(nothing)")
        self._before[self._start(cursor)].append(f"{{ if (!::mutation::on<{mutant}>()) {{ ")
        self._after[end].append(" } }")

    def _for(self, cursor):
        """Its three parts: a step that is mutated would never end."""
        self._skip("step of a loop")
        children = list(cursor.get_children())
        semicolons = []
        depth = 0
        at = self._start(cursor)
        while len(semicolons) < 2:
            byte = self._bytes[at:at + 1]
            depth += (byte in b"([{") - (byte in b")]}")
            if byte == b";" and depth == 1:
                semicolons.append(at)
            at += 1
        for child in children:
            if self._start(child) < semicolons[1] or child == children[-1]:
                self.visit(child, cursor)

    def _return(self, cursor):
        values = list(cursor.get_children())
        if not values:
            return
        value = self._bare(values[0])
        if value.kind in (Kind.INTEGER_LITERAL, Kind.FLOATING_LITERAL, Kind.CXX_BOOL_LITERAL_EXPR):
            return
        kind = self._kind(values[0])
        text = self._text_of(values[0])
        if kind == TypeKind.BOOL:
            if not self._is_decision(value):
                self._wrap(values[0], f"::mutation::returned<{self._new(cursor, 'returned value', text, f'!({text})')}>(")
        elif kind in FLOATS | INTEGERS | {TypeKind.ENUM}:
            self._wrap(values[0], f"::mutation::returned<{self._new(cursor, 'returned value', text, '0')}>(")
        else:
            self._skip("returned value of a class")

    # Conditions.
    def _bare(self, cursor):
        """Without parentheses and conversions."""
        while cursor.kind in (Kind.UNEXPOSED_EXPR, Kind.PAREN_EXPR):
            inside = [child for child in cursor.get_children()]
            if len(inside) != 1:
                break
            cursor = inside[0]
        return cursor

    def _is_decision(self, cursor):
        """Mutated to its opposite already."""
        children = list(cursor.get_children())
        if cursor.kind == Kind.BINARY_OPERATOR and len(children) == 2:
            found = self._between(*children)
            return bool(found) and found[2] in RELATIONS
        return cursor.kind == Kind.UNARY_OPERATOR and self._text_of(cursor).startswith("!")

    def _condition(self, cursor):
        if cursor.kind == Kind.IF_STMT and re.match(rb"if\s+constexpr", self._bytes[self._start(cursor):]):
            self._skip("if constexpr")
            return
        condition = next(iter(cursor.get_children()))
        if not self._here(condition) or condition.kind == Kind.VAR_DECL or self._is_decision(self._bare(condition)):
            return
        text = self._text_of(condition)
        self._wrap(condition, f"::mutation::negated<{self._new(condition, 'negated condition', text, f'!({text})')}>(")

    def _truth(self, cursor):
        text = self._text_of(cursor)
        if text in ("true", "false"):
            mutant = self._new(cursor, "constant", text, "false" if text == "true" else "true")
            self._wrap(cursor, f"::mutation::negated<{mutant}>(")

    # Operators.
    def _binary(self, cursor):
        left, right = cursor.get_children()
        found = self._between(left, right)
        if not found:
            self._skip("operator out of a macro")
            return
        start, end, operator = found
        original = self._text_of(cursor)

        def with_operator(other):
            return self._text_of(left) + " " + other + " " + self._text_of(right)

        if operator in ("&&", "||"):
            other = "||" if operator == "&&" else "&&"
            swap = self._new(cursor, "logical connector", original, with_operator(other), self._text_of(left),
                             self._text_of(right))
            gate = "|| " if operator == "&&" else "&& !"
            on = "::mutation::on<{}>()".format
            self._wrap(cursor, "(((((", f") {gate}{on(swap + 1)}) != {on(swap)})) != {on(swap)})")
            self._replace(start, end, f") {gate}{on(swap + 2)}) != {on(swap)}) {operator} (((")
        elif operator in RELATIONS:
            name, others = RELATIONS[operator]
            mutant = self._new(cursor, "relation", original, *map(with_operator, others))
            self._wrap(cursor, f"::mutation::compare<{mutant}, ::mutation::Relation::{name}>(")
            self._replace(start, end, ",")
        elif operator in SWAPS:
            if self._kind(cursor) not in FLOATS | INTEGERS | DEPENDENT:
                self._skip("arithmetic of pointers and classes")
                return
            name, other = SWAPS[operator]
            mutant = self._new(cursor, "arithmetic", original, with_operator(other))
            self._wrap(cursor, f"::mutation::arithmetic<{mutant}, ::mutation::Swap::{name}>(")
            self._replace(start, end, ",")

    def _compound(self, cursor):
        left, right = cursor.get_children()
        found = self._between(left, right)
        operator = found[2].removesuffix("=") if found else ""
        if operator not in SWAPS or self._kind(cursor) not in FLOATS | INTEGERS:
            self._skip("arithmetic of pointers and classes")
            return
        name, other = SWAPS[operator]
        mutant = self._new(cursor, "arithmetic", self._text_of(cursor),
                           f"{self._text_of(left)} {other}= {self._text_of(right)}")
        self._wrap(cursor, f"::mutation::compound<{mutant}, ::mutation::Swap::{name}>(")
        self._replace(found[0], found[1], ",")

    def _unary(self, cursor):
        text = self._text_of(cursor)
        start = self._start(cursor)
        if text.startswith("!"):
            self._wrap(cursor, "(", f" != ::mutation::on<{self._new(cursor, 'negated condition', text, text[1:])}>())")
        elif text.startswith("-") and not text.startswith("--") and self._is_number(cursor):
            mutant = self._new(cursor, "unary minus", text, text[1:])
            self._replace(start, start + 1, f"::mutation::minus<{mutant}>(")
            self._after[self._end(cursor)].append(")")

    def _call(self, cursor):
        name = cursor.spelling
        children = list(cursor.get_children())
        if name in BOUNDING and children and self._kind(cursor) in FLOATS and self._here(children[0]):
            helper, mutated = BOUNDING[name]
            mutant = self._new(cursor, "bounding", self._text_of(cursor), *mutated)
            self._replace(self._start(children[0]), self._end(children[0]), f"::mutation::{helper}<{mutant}>{{}}")
            for child in children[1:]:
                self.visit(child, cursor)
            return False
        if name == "operator<" and len(children) == 3:
            left, right = children[0], children[2]
            found = self._between(left, right)
            if found and found[2] == "<":
                mutant = self._new(cursor, "relation", self._text_of(cursor),
                                   f"{self._text_of(left)} <= {self._text_of(right)}",
                                   f"{self._text_of(left)} >= {self._text_of(right)}")
                self._wrap(cursor, f"::mutation::class_less<{mutant}>(")
                self._replace(found[0], found[1], ",")
        return True

    # Values.
    def _literal(self, cursor):
        text = self._text_of(cursor)
        if not NUMBER.match(text):
            self._skip("number out of a macro")
            return
        helper = "real" if self._kind(cursor) in FLOATS else "integer"
        self._wrap(cursor, f"::mutation::{helper}<{self._numbers(cursor, text, 'constant')}>(")

    def _reference(self, cursor):
        declared = cursor.referenced
        first = self._all._constants.get(declared.get_usr()) if declared is not None else None
        if first is None:
            return True
        if not self._text_of(cursor).endswith(declared.spelling):
            return True
        helper = "real" if self._kind(declared) in FLOATS else "integer"
        self._wrap(cursor, f"::mutation::{helper}<{first}>(")
        return False

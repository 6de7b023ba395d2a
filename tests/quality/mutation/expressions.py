"""Changes within an expression: operators, conditions, constants, arguments.

A function for each kind of place. `file` is the FileMutator; False says that what is inside has been seen to.
"""

import re

import kinds

SWAPS = {"+": ("plus", "-"), "-": ("minus", "+"), "*": ("times", "/"), "/": ("over", "*"), "%": ("rest", "*"),
         "<<": ("left", ">>"), ">>": ("right", "<<"), "&": ("bit_and", "|"), "|": ("bit_or", "&"), "^": ("bit_xor", "&")}
RELATIONS = {"<": ("less", ("<=", ">=")), "<=": ("less_equal", ("<", ">")), ">": ("greater", (">=", "<=")),
             ">=": ("greater_equal", (">", "<")), "==": ("equal", ("!=",)), "!=": ("unequal", ("==",))}
BOUNDING = {"smaller": ("Smaller", ("the first argument", "the second argument")),
            "larger": ("Larger", ("the first argument", "the second argument")),
            "clamp": ("Clamp", ("no lower bound", "no upper bound")),
            "clamp_magnitude": ("ClampMagnitude", ("no bound",)),
            "absolute": ("Absolute", ("the sign stays",))}
STANDARD_BOUNDING = {"std::min": "Least", "std::max": "Greatest"}
NUMBER = re.compile(r"^[0-9.][0-9A-Fa-fxX.'+-]*[uUlLfF]*$|^[0-9.]+[eE][-+]?[0-9]+[fF]?$")


def binary(file, cursor):
    left, right = cursor.get_children()
    found = file.source.operator_between(left, right)
    if not found:
        file.skip("operator out of a macro")
        return
    start, end, operator = found
    original, first, second = map(file.source.text_of, (cursor, left, right))
    if operator in ("&&", "||"):
        other = "||" if operator == "&&" else "&&"
        swap = file.new(cursor, "logical connector", original, f"{first} {other} {second}", first, second)
        gate = "|| " if operator == "&&" else "&& !"
        on = "::mutation::on<{}>()".format
        file.source.wrap(cursor, "(((((", f") {gate}{on(swap + 1)}) != {on(swap)})) != {on(swap)})")
        file.source.replace(start, end, f") {gate}{on(swap + 2)}) != {on(swap)}) {operator} (((")
    elif operator in RELATIONS:
        name, others = RELATIONS[operator]
        mutant = file.new(cursor, "relation", original, *(f"{first} {other} {second}" for other in others))
        file.source.wrap(cursor, f"::mutation::compare<{mutant}, ::mutation::Relation::{name}>(")
        file.source.replace(start, end, ",")
    elif operator in SWAPS:
        if kinds.kind_of_type(cursor) not in kinds.NUMBERS | kinds.DEPENDENT:
            file.skip("arithmetic of pointers and classes")
            return
        name, other = SWAPS[operator]
        mutant = file.new(cursor, "arithmetic", original, f"{first} {other} {second}")
        file.source.wrap(cursor, f"::mutation::arithmetic<{mutant}, ::mutation::Swap::{name}>(")
        file.source.replace(start, end, ",")


def compound(file, cursor):
    left, right = cursor.get_children()
    found = file.source.operator_between(left, right)
    operator = found[2].removesuffix("=") if found else ""
    if operator not in SWAPS or not kinds.is_number(cursor):
        file.skip("arithmetic of pointers and classes")
        return
    name, other = SWAPS[operator]
    mutant = file.new(cursor, "arithmetic", file.source.text_of(cursor),
                      f"{file.source.text_of(left)} {other}= {file.source.text_of(right)}")
    file.source.wrap(cursor, f"::mutation::compound<{mutant}, ::mutation::Swap::{name}>(")
    file.source.replace(found[0], found[1], ",")


def unary(file, cursor):
    text = file.source.text_of(cursor)
    start = file.source.start(cursor)
    if text.startswith("!"):
        mutant = file.new(cursor, "negated condition", text, text[1:])
        file.source.wrap(cursor, "(", f" != ::mutation::on<{mutant}>())")
    elif text.startswith("-") and not text.startswith("--") and kinds.is_number(cursor):
        mutant = file.new(cursor, "unary minus", text, text[1:])
        file.source.replace(start, start + 1, f"::mutation::minus<{mutant}>(")
        file.source.insert(start, file.source.end(cursor), "", ")")


def call(file, cursor):
    children = list(cursor.get_children())
    if cursor.spelling in BOUNDING and children and kinds.is_float(cursor) and file.source.holds(children[0]):
        helper, mutated = BOUNDING[cursor.spelling]
        mutant = file.new(cursor, "bounding", file.source.text_of(cursor), *mutated)
        name = children[0]
        file.source.replace(file.source.start(name), file.source.end(name), f"::mutation::{helper}<{mutant}>{{}}")
        for argument in children[1:]:
            file.visit(argument, cursor)
        return False
    if len(children) == 3 and file.source.holds(children[0]) and kinds.is_number(cursor):
        name, *arguments = children
        helper = STANDARD_BOUNDING.get(file.source.text_of(name))
        if helper:
            mutant = file.new(cursor, "bounding", file.source.text_of(cursor), *map(file.source.text_of, arguments))
            file.source.replace(file.source.start(name), file.source.end(name), f"::mutation::{helper}<{mutant}>{{}}")
            for argument in arguments:
                file.visit(argument, cursor)
            return False
    if cursor.spelling == "operator<" and len(children) == 3:
        left, right = children[0], children[2]
        found = file.source.operator_between(left, right)
        if found and found[2] == "<":
            first, second = file.source.text_of(left), file.source.text_of(right)
            mutant = file.new(cursor, "relation", file.source.text_of(cursor), f"{first} <= {second}",
                              f"{first} >= {second}")
            file.source.wrap(cursor, f"::mutation::compare<{mutant}, ::mutation::Relation::less>(")
            file.source.replace(found[0], found[1], ",")
    return True


def literal(file, cursor):
    text = file.source.text_of(cursor)
    if not NUMBER.match(text):
        file.skip("number out of a macro")
        return
    helper = "real" if kinds.is_float(cursor) else "small_integer" if _is_zero_or_one(text) else "integer"
    file.source.wrap(cursor, f"::mutation::{helper}<{numbers(file, cursor, text)}>(")


def truth(file, cursor):
    text = file.source.text_of(cursor)
    if text in ("true", "false"):
        mutant = file.new(cursor, "constant", text, "false" if text == "true" else "true")
        file.source.wrap(cursor, f"::mutation::negated<{mutant}>(")


def numbers(file, cursor, text):
    """The mutants of a number that `text` stands for."""
    if kinds.is_float(cursor):
        zero = re.fullmatch(r"0*\.?0*[fF]?", text)
        steps = (f"{text} + 1", f"{text} - 1") if zero else (f"{text} * 1.1", f"{text} * 0.9")
        return file.new(cursor, "constant", text, *steps)
    steps = [f"{text} + 1", f"{text} - 1"]
    if not _is_zero_or_one(text):
        steps.append("0")
    return file.new(cursor, "constant", text, *steps)


def _is_zero_or_one(text):
    return re.fullmatch(r"(0x)?0*[01][uUlL]*", text) is not None


def reference(file, cursor):
    """A named constant is mutated where it is used, so that it stays a constant."""
    declared = cursor.referenced
    first = file.mutants.of_constant.get(kinds.name_of_constant(declared)) if declared is not None else None
    if first is None or not file.source.text_of(cursor).endswith(declared.spelling):
        return True
    helper = "real" if kinds.is_float(declared) else "integer"
    file.source.wrap(cursor, f"::mutation::{helper}<{first}>(")
    return False

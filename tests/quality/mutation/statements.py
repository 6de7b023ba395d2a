"""Changes of a statement: it is left out, its condition is inverted, its result is another value.

`file` is the FileMutator.
"""

import re

from clang.cindex import CursorKind as Kind, TypeKind

import expressions
import kinds


def left_out(file, cursor, parent):
    if parent.kind != Kind.COMPOUND_STMT or not _can_be_left_out(file.source, cursor):
        return
    mutant = file.new(cursor, "statement", file.source.text_of(cursor), "(nothing)")
    file.source.insert(file.source.start(cursor), file.source.semicolon_behind(cursor),
                       f"{{ if (!::mutation::on<{mutant}>()) {{ ", " } }")


def _can_be_left_out(source, cursor):
    if cursor.kind in (Kind.CALL_EXPR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.CXX_STATIC_CAST_EXPR,
                       Kind.BINARY_OPERATOR):
        return True
    if cursor.kind == Kind.UNARY_OPERATOR:
        return "++" in source.text_of(cursor) or "--" in source.text_of(cursor)
    if cursor.kind == Kind.UNEXPOSED_EXPR:
        return source.behind(cursor) == b";"
    return cursor.kind == Kind.RETURN_STMT and not list(cursor.get_children())


def loop(file, cursor):
    """A `for` but for its step, which would never end."""
    file.skip("step of a loop")
    children = list(cursor.get_children())
    end_of_condition = file.source.second_semicolon_of(cursor)
    for child in children:
        if file.source.start(child) < end_of_condition or child == children[-1]:
            file.visit(child, cursor)


def returned(file, cursor):
    values = list(cursor.get_children())
    if not values:
        return
    value = kinds.bare(values[0])
    if value.kind in (Kind.INTEGER_LITERAL, Kind.FLOATING_LITERAL, Kind.CXX_BOOL_LITERAL_EXPR):
        return
    kind = kinds.kind_of_type(values[0])
    text = file.source.text_of(values[0])
    if kind == TypeKind.BOOL:
        if not _is_decision(file.source, value):
            mutant = file.new(cursor, "returned value", text, f"!({text})")
            file.source.wrap(values[0], f"::mutation::returned<{mutant}>(")
    elif kind in kinds.NUMBERS | {TypeKind.ENUM}:
        file.source.wrap(values[0], f"::mutation::returned<{file.new(cursor, 'returned value', text, '0')}>(")
    else:
        file.skip("returned value of a class")


def condition(file, cursor):
    if cursor.kind == Kind.IF_STMT and re.match(r"if\s+constexpr", file.source.text_of(cursor)):
        file.skip("if constexpr")
        return
    decision = next(iter(cursor.get_children()))
    if cursor.kind == Kind.IF_STMT and file.source.holds(decision) and decision.kind != Kind.VAR_DECL and _refuses(cursor):
        mutant = file.new(decision, "refusal", file.source.text_of(decision), "never refused")
        file.source.wrap(decision, f"::mutation::never<{mutant}>(")
    if not file.source.holds(decision) or decision.kind == Kind.VAR_DECL or _is_decision(
            file.source, kinds.bare(decision)):
        return
    text = file.source.text_of(decision)
    mutant = file.new(decision, "negated condition", text, f"!({text})")
    file.source.wrap(decision, f"::mutation::negated<{mutant}>(")


def _refuses(cursor):
    """Refusals by an exception: a test of good input alone sees a condition's opposite, but not that it is gone."""
    then = list(cursor.get_children())[1]
    last = list(then.get_children())[-1:] if then.kind == Kind.COMPOUND_STMT else [then]
    return bool(last) and kinds.bare(last[0]).kind == Kind.CXX_THROW_EXPR


def _is_decision(source, cursor):
    """Changed to its opposite already."""
    children = list(cursor.get_children())
    if cursor.kind == Kind.BINARY_OPERATOR and len(children) == 2:
        found = source.operator_between(*children)
        return bool(found) and found[2] in expressions.RELATIONS
    return cursor.kind == Kind.UNARY_OPERATOR and source.text_of(cursor).startswith("!")

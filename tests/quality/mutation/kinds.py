"""Kinds of types and of places in clang's syntax tree."""

from clang.cindex import CursorKind as Kind, TypeKind

FLOATS = {TypeKind.FLOAT, TypeKind.DOUBLE}
INTEGERS = {TypeKind.BOOL, TypeKind.CHAR_S, TypeKind.CHAR_U, TypeKind.SCHAR, TypeKind.UCHAR, TypeKind.SHORT,
            TypeKind.USHORT, TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG,
            TypeKind.ULONGLONG}
NUMBERS = FLOATS | INTEGERS
DEPENDENT = {TypeKind.DEPENDENT, TypeKind.UNEXPOSED, TypeKind.INVALID}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR, Kind.CONVERSION_FUNCTION,
             Kind.FUNCTION_TEMPLATE}
CLASSES = {Kind.CLASS_DECL, Kind.STRUCT_DECL, Kind.CLASS_TEMPLATE}


def kind_of_type(cursor):
    return cursor.type.get_canonical().kind


def is_number(cursor):
    return kind_of_type(cursor) in NUMBERS


def is_float(cursor):
    return kind_of_type(cursor) in FLOATS


def declares_constant(cursor):
    return "constexpr" in [token.spelling for token in cursor.get_tokens()][:4]


def is_numeric_constant(cursor):
    return cursor.kind == Kind.VAR_DECL and is_number(cursor) and declares_constant(cursor)


def name_of_constant(declared):
    """clang's name (USR) and the file: constants of two files may have the same name if they are local."""
    file = declared.location.file
    return declared.get_usr(), file.name if file else ""


def full_name(member):
    parent = member.semantic_parent
    return f"{parent.spelling}::{member.spelling}" if parent and parent.kind in CLASSES else member.spelling


def bare(cursor):
    """Without parentheses and conversions."""
    while cursor.kind in (Kind.UNEXPOSED_EXPR, Kind.PAREN_EXPR):
        inside = list(cursor.get_children())
        if len(inside) != 1:
            break
        cursor = inside[0]
    return cursor

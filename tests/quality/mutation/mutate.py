"""Writes mutant schemata: a source in which every mutant sleeps until its number is called.

A mutant is a small change of one place: an operator, a condition, a constant, a statement, a returned value, an argument.
The syntax tree is clang's; the change is made in the text, so whatever is not mutated stays as it was.
"""

import re

from clang.cindex import CursorKind as Kind

import edited_source
import expressions
import kinds
import statements

HANDLERS = {Kind.BINARY_OPERATOR: expressions.binary, Kind.COMPOUND_ASSIGNMENT_OPERATOR: expressions.compound,
            Kind.UNARY_OPERATOR: expressions.unary, Kind.CALL_EXPR: expressions.call,
            Kind.INTEGER_LITERAL: expressions.literal, Kind.FLOATING_LITERAL: expressions.literal,
            Kind.CXX_BOOL_LITERAL_EXPR: expressions.truth, Kind.DECL_REF_EXPR: expressions.reference,
            Kind.IF_STMT: statements.condition, Kind.WHILE_STMT: statements.condition,
            Kind.CONDITIONAL_OPERATOR: statements.condition, Kind.RETURN_STMT: statements.returned,
            Kind.FOR_STMT: statements.loop}
MACRO = re.compile(r"[A-Z][A-Z0-9_]+\(")
STRUCTURE = kinds.FUNCTIONS | kinds.CLASSES | {Kind.COMPOUND_STMT, Kind.NAMESPACE}


class FileMutator:
    """Walks over one file. `declarations`: what stands at its top; `left_out`: lines without mutants."""

    def __init__(self, mutants, name, path, declarations, left_out=frozenset()):
        self.mutants = mutants
        self.source = edited_source.EditedSource(name, path)
        self._declarations = declarations
        self._left_out = left_out
        self._seen = set()
        self._function = ""

    def new(self, cursor, operator, original, *mutated):
        return self.mutants.new(self.source.name, cursor.extent.start.line, self._function, operator, original, *mutated)

    def skip(self, why):
        self.mutants.skipped[why] += 1

    def find_constants(self):
        """Numbers the mutants of the named constants; before mutated() of any file."""
        self._find_constants_in(self._declarations)

    def mutated(self):
        for declared in self._declarations:
            self.visit(declared, declared.semantic_parent)
        return self.source.text()

    def _find_constants_in(self, cursors):
        of_constant = self.mutants.of_constant
        for child in filter(self.source.holds, cursors):
            name = kinds.name_of_constant(child)
            if kinds.is_numeric_constant(child) and name not in of_constant:
                of_constant[name] = expressions.numbers(self, child, child.spelling)
            outer = self._function
            if child.kind in kinds.FUNCTIONS:
                self._function = kinds.full_name(child)
            self._find_constants_in(child.get_children())
            self._function = outer

    def visit_children(self, cursor):
        for child in filter(self.source.holds, cursor.get_children()):
            self.visit(child, cursor)

    def visit(self, cursor, parent):
        kind = cursor.kind
        if cursor.extent.start.line in self._left_out and kind not in STRUCTURE:
            self.skip("line that does not compile when mutated")
        elif MACRO.match(self.source.text_of(cursor)):
            self.skip("rows of a table that a macro writes out")
        elif kind in kinds.FUNCTIONS:
            self._visit_function(cursor)
        elif kind in (Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.ENUM_CONSTANT_DECL):
            self.skip("static_assert, enumerator")
        elif kind == Kind.UNEXPOSED_DECL and "constexpr" in self.source.text_of(cursor):
            self.skip("constant that is no number: a table, a structure")
        elif kind == Kind.LAMBDA_EXPR:
            self.visit_children(cursor)
        elif kind in (Kind.VAR_DECL, Kind.FIELD_DECL, Kind.PARM_DECL):
            self._visit_declaration(cursor, parent)
        elif kind == Kind.CASE_STMT:
            self.skip("case label")
            for child in list(cursor.get_children())[1:]:
                self.visit(child, cursor)
        else:
            self._visit_code(cursor, parent)

    def _visit_function(self, cursor):
        outer, self._function = self._function, kinds.full_name(cursor)
        for child in cursor.get_children():
            if child.kind in (Kind.COMPOUND_STMT, Kind.PARM_DECL, Kind.CXX_TRY_STMT):
                self.visit(child, cursor)
        self._function = outer

    def _visit_declaration(self, cursor, parent):
        """Only the initial value; a number before the name belongs to the type."""
        if kinds.declares_constant(cursor):
            if not kinds.is_numeric_constant(cursor):
                self.skip("constant that is no number: a table, a structure")
            return
        if cursor.kind == Kind.FIELD_DECL and any(child.spelling == "init" for child in parent.get_children()):
            self.skip("initial value of a member that init() replaces")
            return
        outer = self._function
        if cursor.kind == Kind.FIELD_DECL:
            self._function = kinds.full_name(cursor)
        for child in cursor.get_children():
            behind_name = self.source.start(child) > cursor.location.offset
            if self.source.holds(child) and behind_name and self.source.before(child) != b"[":
                self.visit(child, cursor)
        self._function = outer

    def _visit_code(self, cursor, parent):
        handler = HANDLERS.get(cursor.kind)
        if handler is not None and cursor.kind != Kind.CALL_EXPR:
            place = cursor.kind, self.source.start(cursor), self.source.end(cursor)
            if place in self._seen:  # a template's instance
                return
            self._seen.add(place)
        statements.left_out(self, cursor, parent)
        if handler is None or handler(self, cursor) is not False:
            if cursor.kind != Kind.FOR_STMT:
                self.visit_children(cursor)

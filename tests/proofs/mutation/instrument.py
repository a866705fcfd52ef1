"""Rewrites the library's sources so that one program holds every mutant.

Where the source says `a < b` the copy says `mutation::less(17, a, b)`: mutants.hpp makes `a <= b`
of it while mutant 17 is the active one, and `a >= b` while mutant 18 is. Lines stay where they are.
"""
import re
from collections import Counter
from dataclasses import dataclass

from clang.cindex import CursorKind as Kind
from clang.cindex import Diagnostic, Index, TranslationUnit

# By operator: the helper in mutants.hpp, and one replacement per mutant.
BINARY = {
    '<': ('less', '<=', '>='), '<=': ('less_equal', '<', '>'),
    '>': ('greater', '>=', '<='), '>=': ('greater_equal', '>', '<'),
    '==': ('equal', '!='), '!=': ('unequal', '=='),
    '+': ('plus', '-'), '-': ('minus', '+'), '*': ('times', '/'), '/': ('divided', '*'),
    '%': ('modulo', '*'), '&': ('bit_and', '|'), '|': ('bit_or', '&'), '^': ('bit_xor', '&'),
    '<<': ('shift_left', '>>'), '>>': ('shift_right', '<<'),
    '+=': ('add', '-='), '-=': ('subtract', '+='), '*=': ('multiply', '/='), '/=': ('divide', '*='),
    '%=': ('remain', '*='), '&=': ('mask', '|='), '|=': ('combine', '&='), '^=': ('toggle', '&='),
    '<<=': ('raise', '>>='), '>>=': ('lower', '<<='),
}
UNARY = {
    '++': ('increment', '--'), '--': ('decrement', '++'), '!': ('negation', ''),
    '-': ('minus', ''), '~': ('inverse', ''),
}

FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR,
             Kind.FUNCTION_TEMPLATE, Kind.CONVERSION_FUNCTION}
DECLARATIONS = {Kind.VAR_DECL, Kind.FIELD_DECL, Kind.PARM_DECL}
# Constants of the program's text, and code that is never evaluated.
UNTOUCHED = {Kind.ENUM_DECL, Kind.STATIC_ASSERT, Kind.TEMPLATE_NON_TYPE_PARAMETER,
             Kind.TYPE_ALIAS_DECL, Kind.TYPEDEF_DECL, Kind.CXX_UNARY_EXPR, Kind.USING_DECLARATION}
# Calls without effect unless an address sanitizer is used (checks.hpp).
CHECKS = ('poison(', 'unpoison(')


@dataclass
class Mutant:
    id: int
    site: int  # the first mutant of the same operator, which the program reports as reached
    file: str
    line: int
    source: str  # the line without its comment, with single spaces
    change: str
    constant: bool  # in a constexpr function: calls evaluated by the compiler are never mutated

    def key(self):
        return f'{self.file} | {self.source} | {self.change}'


class Instrumenter:
    """The mutants of one file. `take_id` numbers them; lines in `refused` get none."""

    def __init__(self, path, flags, take_id, refused):
        self.file = path.name
        self.text = path.read_text()
        self.take_id = take_id
        self.refused = refused
        self.mutants = []
        self.edits = []  # (offset, order at the same offset, length removed, text inserted)
        self.seen = set()
        unit = Index.create().parse(
            str(path), args=flags, options=TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        errors = [d for d in unit.diagnostics if d.severity >= Diagnostic.Error]
        if errors:
            raise SystemExit(f'mutate: libclang cannot read {path}: {errors[0]}')
        cursors = [cursor for cursor in unit.cursor.get_children()
                   if cursor.location.file and cursor.location.file.name == str(path)]
        self.macros = [(cursor.extent.start.offset, cursor.extent.end.offset) for cursor in cursors
                       if cursor.kind == Kind.MACRO_INSTANTIATION]
        for cursor in cursors:
            self.visit(cursor, False)
        self.number_twins()

    def rewritten(self):
        parts, end = [], 0
        for offset, _, length, text in sorted(self.edits):
            parts += [self.text[end:offset], text]
            end = offset + length
        return ''.join(parts) + self.text[end:]

    # ---- mutants and edits ----

    def mutant(self, offset, change, constant, site=None):
        line = self.text.count('\n', 0, offset) + 1
        code = self.text.splitlines()[line - 1].partition('//')[0]
        source = ' '.join(code.split())
        number = self.take_id()
        self.mutants.append(
            Mutant(number, site or number, self.file, line, source, change, constant))
        return number

    def number_twins(self):
        """Equal changes of one line are numbered."""
        count = Counter()
        for mutant in self.mutants:
            key = mutant.key()
            count[key] += 1
            if count[key] > 1:
                mutant.change += f' #{count[key]}'

    def may_edit(self, start, end):
        in_macro = any(begin <= place < last for place in (start, end - 1)
                       for begin, last in self.macros)
        return not in_macro and self.text.count('\n', 0, start) + 1 not in self.refused

    # An outer expression is visited before its parts. So its text comes first where both begin, and last where both
    # end. At one offset, ends precede beginnings.
    def before(self, offset, text):
        self.edits.append((offset, (1, len(self.edits)), 0, text))

    def after(self, offset, text):
        self.edits.append((offset, (0, -len(self.edits)), 0, text))

    def replace(self, offset, length, text):
        self.edits.append((offset, (2, 0), length, text))

    def wrap(self, cursor, head):
        self.before(cursor.extent.start.offset, head)
        self.after(cursor.extent.end.offset, ')')

    def text_of(self, cursor):
        return ' '.join(self.text[cursor.extent.start.offset:cursor.extent.end.offset].split())

    # ---- the walk ----

    def visit(self, cursor, constant):
        if (cursor.kind in UNTOUCHED or self.is_constant_variable(cursor)
                or self.is_check(cursor)):
            return
        if cursor.kind in FUNCTIONS:
            head = self.text[cursor.extent.start.offset:cursor.location.offset]
            constant = 'constexpr' in head
        children = list(cursor.get_children())
        self.statements(cursor, children, constant)
        self.conditions(cursor, children, constant)
        if cursor.kind in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR):
            self.binary(cursor, children, constant)
        elif cursor.kind == Kind.UNARY_OPERATOR:
            self.unary(cursor, constant)
        elif cursor.kind == Kind.INTEGER_LITERAL:
            self.literal(cursor, constant)
        elif cursor.kind == Kind.CXX_BOOL_LITERAL_EXPR:
            self.boolean(cursor, constant)
        for i, child in enumerate(children):
            if i == 0 and (cursor.kind == Kind.CASE_STMT or self.is_constexpr_if(cursor)):
                continue  # declarations of the compiler
            if cursor.kind in DECLARATIONS and self.last_before(child) in '[:':
                continue  # the size of an array, the width of a bit field
            self.visit(child, constant)

    def is_constexpr_if(self, cursor):
        begun = self.text[cursor.extent.start.offset:]
        return cursor.kind == Kind.IF_STMT and re.match(r'if\s+constexpr', begun) is not None

    def is_constant_variable(self, cursor):
        if cursor.kind == Kind.UNEXPOSED_DECL:  # a template of a variable is a declaration of a variable
            head = self.text[cursor.extent.start.offset:].partition('=')[0]
            return 'constexpr' in head.split() and '{' not in head
        if cursor.kind != Kind.VAR_DECL:
            return False
        is_global = cursor.semantic_parent.kind == Kind.NAMESPACE
        head = self.text[cursor.extent.start.offset:cursor.location.offset].split()
        return 'constexpr' in head or is_global and 'const' in head

    def is_check(self, cursor):
        return self.text.startswith(CHECKS, cursor.extent.start.offset)

    def is_template_argument(self, cursor):
        """Whether it is the last argument, which the compiler evaluates."""
        return self.last_before(cursor) in '<,' and self.next_after(cursor) == '>'

    def last_before(self, cursor):
        return self.text[:cursor.extent.start.offset].rstrip()[-1:]

    def is_new(self, cursor, what):
        """An explicit instantiation has the same text again."""
        extent = (cursor.extent.start.offset, cursor.extent.end.offset)
        if (what, extent) in self.seen or not self.may_edit(*extent):
            return False
        self.seen.add((what, extent))
        return True

    # ---- statements and conditions ----

    def statements(self, cursor, children, constant):
        """Omits a statement that consists of an expression."""
        bodies = {Kind.COMPOUND_STMT: children, Kind.IF_STMT: children[1:],
                  Kind.FOR_STMT: children[-1:], Kind.WHILE_STMT: children[-1:],
                  Kind.CXX_FOR_RANGE_STMT: children[-1:], Kind.DO_STMT: children[:1],
                  Kind.CASE_STMT: children[1:], Kind.DEFAULT_STMT: children}
        for child in bodies.get(cursor.kind, []):
            if (child.kind.is_expression() and not self.is_check(child)
                    and self.is_new(child, 'statement')):
                start = child.extent.start.offset
                number = self.mutant(start, f'without: {self.text_of(child)}', constant)
                self.before(start, f'if (mutation::skips({number})) {{}} else ')

    def conditions(self, cursor, children, constant):
        if cursor.kind == Kind.IF_STMT:
            if children[0].kind.is_expression() and not self.is_constexpr_if(cursor):
                self.forced(children[0], ('true', 'false'), constant)
        elif cursor.kind == Kind.CONDITIONAL_OPERATOR:
            self.forced(children[0], ('true', 'false'), constant)
        elif cursor.kind == Kind.WHILE_STMT and children[0].kind.is_expression():
            self.forced(children[0], ('false',), constant)
        elif cursor.kind == Kind.DO_STMT:
            self.forced(children[1], ('false',), constant)
        elif cursor.kind == Kind.FOR_STMT:
            for child in children[:-1]:
                if self.last_before(child) == ';' and self.next_after(child) == ';':
                    self.forced(child, ('false',), constant)

    def next_after(self, cursor):
        return self.text[cursor.extent.end.offset:].lstrip()[:1]

    def forced(self, cursor, values, constant):
        if not self.is_new(cursor, 'condition'):
            return
        for value in values:
            change = f'{self.text_of(cursor)} -> {value}'
            number = self.mutant(cursor.extent.start.offset, change, constant)
            self.wrap(cursor, f'mutation::forced({number}, {value}, ')

    # ---- operators and literals ----

    def binary(self, cursor, children, constant):
        left, right = children
        gap = self.text[left.extent.end.offset:right.extent.start.offset]
        found = re.fullmatch(r'\s*([-+*/%&|^<>=!]+)(?:\s|//.*)*', gap)
        if not found or not self.is_new(cursor, 'operator'):
            return
        operator = found.group(1)
        if operator in ('&&', '||'):  # either side is ignored
            neutral = 'true' if operator == '&&' else 'false'
            self.forced(left, (neutral,), constant)
            self.forced(right, (neutral,), constant)
        elif operator in BINARY:
            helper, *others = BINARY[operator]
            sides = (self.text_of(left), self.text_of(right))
            offset = left.extent.end.offset + found.start(1)
            site = None
            for other in others:
                change = f'{sides[0]} {operator} {sides[1]} -> {other}'
                number = self.mutant(offset, change, constant, site)
                site = site or number
            self.wrap(cursor, f'mutation::{helper}({site}, ')
            self.replace(offset, len(operator), ',')

    def unary(self, cursor, constant):
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        text = self.text[start:end]
        operator = next((o for o in UNARY if text.startswith(o)), None)
        if not operator or self.is_template_argument(cursor) or not self.is_new(cursor, 'operator'):
            return
        change = f'{self.text_of(cursor)} -> {UNARY[operator][1] or "without " + operator}'
        number = self.mutant(start, change, constant)
        self.wrap(cursor, f'mutation::{UNARY[operator][0]}({number}, ')
        self.replace(start, len(operator), '')

    def literal(self, cursor, constant):
        text = self.text_of(cursor)
        if self.is_template_argument(cursor) or not re.fullmatch(r'(0x[0-9A-Fa-f]+|\d+)[uUlL]*', text):
            return
        if self.is_new(cursor, 'literal'):
            number = self.mutant(cursor.extent.start.offset, f'{text} -> {text} + 1', constant)
            self.wrap(cursor, f'mutation::one_more({number}, ')

    def boolean(self, cursor, constant):
        text = self.text_of(cursor)
        if text in ('true', 'false') and self.is_new(cursor, 'literal'):
            change = f'{text} -> {"false" if text == "true" else "true"}'
            number = self.mutant(cursor.extent.start.offset, change, constant)
            self.wrap(cursor, f'mutation::other({number}, ')

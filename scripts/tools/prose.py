"""Finds the prose of a file: the text of documents, comments, usages, messages and titles of tests."""
import ast
import re
import warnings

# What a reader yields: prose, a part of a sentence, or the title of a test.
SENTENCES, PART, TITLE = range(3)
# A string of fewer words is no message.
MESSAGE_WORDS = 4


def paragraphs(pieces):
    """Joins pieces (line, text) to paragraphs, which end at None. Yields (line, prose, SENTENCES)."""
    joined, start = [], 0
    for line, piece in [*pieces, (0, None)]:
        if piece is None:
            if joined:
                yield start, ' '.join(joined), SENTENCES
            joined = []
        else:
            start = start if joined else line
            joined.append(piece)


def piece_of(body):
    """The prose of a line of a comment: None ends a paragraph, as code and remarks for tools do."""
    is_code = re.match(r' {2,}\S', body)
    is_for_tool = re.match(r'\s*(NOLINT|clang-format |shellcheck|noqa|type: |pylint)', body)
    return None if is_code or is_for_tool else body.strip() or None


def markdown(text):
    """Yields (line, prose, SENTENCES or PART) of a page, without code."""
    pieces, fenced = [], False
    for number, line in enumerate(text.split('\n'), 1):
        fence = line.lstrip().startswith('```')
        fenced ^= fence
        item = re.match(r'\s*([-*]|\d+\.) ', line)
        if fenced or fence or not line.strip() or line.startswith(('<!--', '    ')):
            pieces.append((number, None))
        elif line.startswith(('|', '#')):
            pieces.append((number, None))
            for cell in line.strip('|').split('|'):
                yield number, cell.lstrip('# '), PART
        else:
            if item:
                pieces.append((number, None))
            pieces.append((number, line[item.end():] if item else line.strip()))
    yield from paragraphs(pieces)


# The literals and comments of C, C++ and JavaScript.
TOKENS = re.compile(
    r'R"(?P<mark>[^()\\\s]{0,16})\((?P<raw>.*?)\)(?P=mark)"'
    r'|"(?P<string>(?:[^"\\\n]|\\.)*)"'
    r"|(?<![0-9a-fA-F])'(?P<quoted>(?:[^'\\\n]|\\.)*)'"
    r'|`(?P<template>(?:[^`\\]|\\.)*)`'
    r'|(?P<comment>(?:///<|///|//)[^\n]*|/\*.*?\*/)', re.DOTALL)


def tokens(text):
    """Yields (line, match of TOKENS)."""
    line, last = 1, 0
    for found in TOKENS.finditer(text):
        line += text.count('\n', last, found.start())
        last = found.start()
        yield line, found


def code_comments(text):
    """Yields (line, prose, SENTENCES) of the comments of C, C++ and JavaScript, without code in them."""
    pieces, next_line, last_mark = [], 0, ''
    for line, found in tokens(text):
        comment = found['comment']
        if comment is None:
            continue
        mark = re.match(r'///<|///|//|/\*', comment).group(0)
        before = text[text.rfind('\n', 0, found.start()) + 1:found.start()]
        if mark != last_mark or line != next_line or mark == '/*' or before.strip():
            pieces.append((line, None))
        for offset, body in enumerate(comment[len(mark):].removesuffix('*/').split('\n')):
            body = re.sub(r'^\s*\*', '', body)
            if re.match(r'\s*@\w', body):
                pieces.append((line + offset, None))
                body = re.sub(r'@\w+ (\{.*\})?', '', body)
            pieces.append((line + offset, piece_of(body)))
            next_line = line + offset + 1
        last_mark = mark
    yield from paragraphs(pieces)


def hash_comments(text):
    """Yields (line, prose, SENTENCES) of comments that begin with #."""
    pieces = []
    literal = re.compile(r'"(?:[^"\\]|\\.)*"|\'[^\']*\'')
    for number, line in enumerate(text.split('\n'), 1):
        bare = literal.sub(lambda found: '_' * len(found.group(0)), line)
        found = re.search(r'(?:^|\s)#(?!!)', bare)
        follows_code = found and line[:found.start()].strip()
        if follows_code:
            pieces.append((number, None))
        pieces.append((number, piece_of(line[found.end():]) if found else None))
        if follows_code:
            pieces.append((number, None))
    yield from paragraphs(pieces)


def usages(text):
    """Yields what markdown() yields of the usages that a script prints."""
    for found in re.finditer(r"<<'?USAGE'?\n(.*?)\n *USAGE\n", text, re.DOTALL):
        before = text.count('\n', 0, found.start(1))
        # What is indented by two spaces is an item of a list.
        usage = re.sub(r'^  (?=\S)', '- ', found.group(1), flags=re.MULTILINE)
        for line, prose, kind in markdown(usage):
            yield before + line, prose, kind


def lines_of_message(line, message):
    for part in message.split('\n'):
        if len(part.split()) >= MESSAGE_WORDS:
            yield line, part, SENTENCES


def code_messages(text):
    """Yields (line, prose, SENTENCES) of the literals of C, C++ and JavaScript that are sentences."""
    begin, end, message = 0, 0, ''
    for line, found in tokens(text):
        literal = next((found[kind] for kind in ('string', 'quoted', 'template') if found[kind] is not None), None)
        if literal is None:
            continue
        # Literals with nothing between them are one.
        if text[end:found.start()].strip(' \n+'):
            yield from lines_of_message(begin, message)
            message = ''
        begin = begin if message else line
        message += re.sub(r'\$\{[^}]*\}', 'N', literal).replace('\\n', '\n').replace('\\', '')
        end = found.end()
    yield from lines_of_message(begin, message)


def python_strings(text):
    """Yields (line, prose, SENTENCES) of the docstrings and of the other strings that are sentences."""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        tree = ast.parse(text)
    parts = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in ast.walk(node)
             if part is not node}
    for node in ast.walk(tree):
        if id(node) in parts:
            continue
        if isinstance(node, ast.JoinedStr):
            pieces = [part.value if isinstance(part, ast.Constant) else 'N' for part in node.values]
            yield from lines_of_message(node.lineno, ''.join(map(str, pieces)))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            lines = node.value.split('\n')
            yield from paragraphs((node.lineno + offset, None if re.match(r' {6,}\S', line) else line.strip() or None)
                                  for offset, line in enumerate(lines) if len(lines) > 1 or ' ' in line)


def titles(text):
    """Yields (line, title, TITLE) of test cases and their parts, in C++ and JavaScript."""
    literal = r'"((?:[^"\\\n]|\\.)*)"'
    begin = r'\b(?:(?:TEST_CASE|TEST_CASE_TEMPLATE|SUBCASE)\(|TEST_CASE_FIXTURE\(\s*\w+,)\s*'
    for found in re.finditer(f'{begin}({literal}(?:\\s*{literal})*)', text):
        title = ''.join(re.findall(literal, found.group(1)))
        yield text.count('\n', 0, found.start(1)) + 1, title, TITLE
    for found in re.finditer(r"""\btest\(\s*(['"`])((?:\\.|(?!\1).)*)\1""", text):
        title = re.sub(r'\$\{[^}]*\}', 'N', found.group(2))
        yield text.count('\n', 0, found.start(2)) + 1, title, TITLE


def prose_of(path, text):
    """Yields (line, prose, kind) of the prose of a file; its name and first line decide how it is read."""
    is_test = path.startswith(('tests/', 'fuzz/', 'ports/python/tests/'))
    if path.endswith('.md'):
        yield from markdown(text)
    elif re.search(r'\.(?:[ch]pp|[chS]|m?js|ts|css|ld|ino)$', path):
        yield from code_comments(text)
        yield from titles(text)
        if path.startswith('tests/boards/simulator/') or (not is_test and path.startswith(('lib/', 'ports/'))):
            yield from code_messages(text)
    elif path.endswith('.py') or text.startswith('#!/usr/bin/env python3'):
        yield from hash_comments(text)
        if not is_test:
            yield from python_strings(text)
    else:
        yield from hash_comments(text)
        yield from usages(text)

"""bind: the header of the library as Python sees it (ctypes), and C that holds the two together.

    cc -E -P settle/settle.h | python3 bind.py MACROS _bindings.py layout.c        MACROS: what cc -E -dM stonepack.h prints

settle/settle.h includes stonepack.h and needs nothing else; its calls are those of a library of their own, SETTLE_CALLS.

Structs, enumerations and calls are read from the header, so nothing is written down twice. layout.c asserts size and offset of
every field as ctypes lays it out; it compiles only if the compiler of the library agrees.
"""
import ctypes
import re
import sys

PLAIN = {"sp_real": "c_double", "double": "c_double", "int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64",
         "int16_t": "c_int16", "uint16_t": "c_uint16", "uint64_t": "c_uint64", "size_t": "c_size_t", "int": "c_int"}
OWN = "(?:sp|settle)_\\w+"


def enumerations(text):
    """[(name, [(enumerator, value)])]"""
    found = []
    for body, name in re.findall(r"typedef enum \w+ \{([^}]*)\} (\w+);", text):
        value, pairs = -1, []
        for item in filter(None, map(str.strip, body.split(","))):
            word, _, told = map(str.strip, item.partition("="))
            value = int(told, 0) if told else value + 1
            pairs.append((word, value))
        found.append((name, pairs))
    return found


def structs(text):
    """[(name, [declaration])], in the order in which they are defined; those without a body have no declarations."""
    found = {}
    for name in re.findall(r"typedef struct (\w+) \w+;", text):
        found[name] = None
    for name, body in re.findall(r"(?:typedef )?struct (%s) \{([^{}]*)\}" % OWN, text):
        found.pop(name, None)                           # at its place, not where it is announced
        found[name] = [d.strip() for d in body.split(";") if d.strip()]
    return list(found.items())


def type_of(words, stars, enums, known):
    """The ctypes of a C type and so many stars."""
    base = [w for w in words.split() if w not in ("const", "struct", "extern", "static")][-1]
    if stars and base in ("void", "char", "unsigned"):
        return "c_char_p" if base == "char" else "c_void_p"
    if base == "char":                                  # unsigned char *
        return "c_void_p" if "unsigned" in words else "c_char_p"
    if base == "void":
        return "None" if not stars else "c_void_p"
    inner = PLAIN.get(base) or ("c_int" if base in enums else base if base in known else None)
    if inner is None:
        raise SystemExit("bind: unknown type %r" % words)
    for _ in range(stars):
        inner = "POINTER(%s)" % inner
    return inner


def fields(declaration, enums, known):
    """[(name, ctypes)] of one declaration of a struct: `sp_real a, b[3]`, `sp_real (*vertex)[3]`, a pointer to a function."""
    if re.search(r"\(\*\w+\)\s*\(", declaration):
        return [(re.search(r"\(\*(\w+)\)", declaration).group(1), "c_void_p")]
    rows = re.match(r"(.*)\(\*(\w+)\)\[(\d+)\]$", declaration, re.S)
    if rows:
        return [(rows.group(2), "POINTER(%s * %s)" % (type_of(rows.group(1), 0, enums, known), rows.group(3)))]
    first, *more = [p.strip() for p in declaration.split(",")]
    words, name = re.match(r"(.*?)((?:\*\s*)*\w+(?:\[\d+\])*)$", first, re.S).groups()
    out = []
    for item in [name] + more:
        stars, item = item.count("*"), item.replace("*", "").strip()
        word, lengths = re.match(r"(\w+)((?:\[\d+\])*)$", item).groups()
        if "unsigned char" in words:
            kind = "c_void_p"
        else:
            kind = type_of(words, stars, enums, known)
        for length in reversed(re.findall(r"\d+", lengths)):        # the last one lies closest
            kind = "(%s * %s)" % (kind, length)
        out.append((word, kind))
    return out


def calls(text, begins, enums, known):
    """[(name, result, [argument])]"""
    found = []
    for result, name, args in re.findall(r"^ *(?:extern )?((?:const )?\w+ \**)(%s_\w+)\(([^()]*)\);" % begins, text, re.M):
        kinds = []
        for arg in args.split(","):
            arg = arg.strip()
            if arg == "void":
                continue
            stars = arg.count("*") + arg.count("[")
            word = re.sub(r"\[\d*\]|\*", " ", arg).split()
            kinds.append(type_of(" ".join(word[:-1]), stars, enums, known))
        found.append((name, type_of(result.replace("*", " "), result.count("*"), enums, known), kinds))
    return found


def bindings(text, macros):
    enums = enumerations(text)
    names = {name for name, _ in enums}
    every = structs(text)
    known = {name for name, _ in every}
    out = ['"""Made by bind.py from stonepack.h: not to be edited."""', "from ctypes import (POINTER, Structure, c_char_p,"
           " c_double, c_int, c_int16, c_int32, c_int64, c_size_t,\n                    c_uint16, c_uint32, c_void_p)", ""]
    for name, value in sorted(re.findall(r"#define (SP_\w+) \(?([0-9]+)u?\)?$", macros, re.M)):
        out.append("%s = %s" % (name, value))
    for name, pairs in enums:
        out += ["", "# " + name] + ["%s = %d" % p for p in pairs]
    out.append("")
    for name, _ in every:
        out += ["", "class %s(Structure):" % name, "    pass", ""]
    for name, declarations in every:
        if declarations:
            each = [f for d in declarations for f in fields(d, names, known)]
            out += ["", "%s._fields_ = [" % name] + ["    (%r, %s)," % f for f in each] + ["]"]
    for table, begins in ("CALLS", "sp"), ("SETTLE_CALLS", "settle"):
        out += ["", "# name: (result, arguments)", table + " = {"]
        for name, result, kinds in calls(text, begins, names, known):
            out.append("    %r: (%s, [%s])," % (name, result, ", ".join(kinds)))
        out.append("}")
    out += ["STRUCTS = [%s]" % ", ".join(n for n, d in every if d), ""]
    return "\n".join(out)


def layout(module):
    out = ['/* Made by bind.py: the structs as ctypes lays them out, asserted. */',
           '#include "settle/settle.h"',
           "#include <stddef.h>"]
    for struct in module["STRUCTS"]:
        name = struct.__name__
        out.append('_Static_assert(sizeof(%s) == %d, "%s");' % (name, ctypes.sizeof(struct), name))
        for field, _ in struct._fields_:
            at = getattr(struct, field)
            out.append('_Static_assert(offsetof(%s, %s) == %d && sizeof(((%s *)0)->%s) == %d, "%s.%s");'
                       % (name, field, at.offset, name, field, at.size, name, field))
    return "\n".join(out) + "\n"


def main(macros, to, layout_to):
    with open(macros) as file:
        text = bindings(sys.stdin.read(), file.read())
    module = {}
    exec(text, module)
    with open(to, "w") as file:
        file.write(text)
    with open(layout_to, "w") as file:
        file.write(layout(module))


if __name__ == "__main__":
    main(*sys.argv[1:])

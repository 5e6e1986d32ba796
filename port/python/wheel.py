"""wheel: a folder with the package becomes a wheel, by the standard library alone; the same folder makes the same bytes.

    python3 wheel.py FOLDER OUT        FOLDER has stonepack/ and LICENSE, README.md, homepage; prints the wheel's path

The tag says what the shared libraries ask of the system: of glibc the newest GLIBC_2.N that they name, manylinux_2_17 where that is no
newer. What needs a library that manylinux does not list, such as Bullet, is linux_MACHINE: for machines that are known to have it.
"""
import base64
import hashlib
import os
import platform
import re
import sys
import zipfile

META = """Metadata-Version: 2.1
Name: stonepack
Version: %s
Summary: Does an assembly of rigid blocks stand? Verdicts with proof, and a kit for testing packers and planners
License: MIT
%sRequires-Python: >=3.8
Provides-Extra: testing
Requires-Dist: hypothesis; extra == "testing"
Requires-Dist: pytest; extra == "testing"
Classifier: License :: OSI Approved :: MIT License
Classifier: Topic :: Scientific/Engineering
Classifier: Typing :: Typed
Description-Content-Type: text/markdown

%s"""


# Libraries that every Linux is taken to have [PEP 599], of those a C or C++ compiler asks for.
LISTED = {"libc.so.6", "libm.so.6", "libdl.so.2", "librt.so.1", "libpthread.so.0", "libgcc_s.so.1", "libstdc++.so.6"}
MACHINES = {62: "x86_64", 183: "aarch64", 243: "riscv64", 21: "ppc64le", 22: "s390x"}       # e_machine of ELF


def machine_tags(folder):
    """Platform tags: newest glibc asked for, machine, and nothing asked for that is not listed."""
    newest, machine, foreign = 0, platform.machine(), set()
    for name in sorted(os.listdir(folder)):
        if ".so" in name:
            data = read(os.path.join(folder, name))
            machine = MACHINES.get(int.from_bytes(data[18:20], "little"), machine)
            newest = max([newest] + [int(n) for n in re.findall(rb"\0GLIBC_2\.(\d+)", data)])
            needed = re.findall(rb"(?<=\0)lib[\w+-]+\.so[.\d]*(?=\0)", data)
            foreign |= {n.decode() for n in needed if not n.startswith(b"libstonepack")} - LISTED
    if foreign or not newest:
        return ["linux_" + machine]
    return ["manylinux_2_%d_%s" % (max(17, newest), machine)] + (["manylinux2014_" + machine] if newest <= 17 else [])


def digest(data):
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def read(path):
    with open(path, "rb") as file:
        return file.read()


def main(folder, out):
    package = os.path.join(folder, "stonepack")
    told = read(os.path.join(package, "_bindings.py")).decode()
    version = ".".join(re.search(r"SP_VERSION_%s = (\d+)" % part, told).group(1) for part in ("MAJOR", "MINOR", "PATCH"))
    tags, info = machine_tags(package), "stonepack-%s.dist-info" % version
    contents = {"stonepack/" + name: read(os.path.join(package, name)) for name in os.listdir(package)
                if os.path.isfile(os.path.join(package, name))}
    homepage = read(os.path.join(folder, "homepage")).decode().strip()
    address = "Project-URL: Homepage, %s\n" % homepage if homepage else ""
    contents[info + "/METADATA"] = (META % (version, address, read(os.path.join(folder, "README.md")).decode())).encode()
    contents[info + "/LICENSE"] = read(os.path.join(folder, "LICENSE"))
    contents[info + "/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: stonepack\nRoot-Is-Purelib: false\n"
                                 + "".join("Tag: py3-none-%s\n" % tag for tag in tags)).encode()
    record = "".join("%s,%s,%d\n" % (name, digest(data), len(data)) for name, data in sorted(contents.items()))
    contents[info + "/RECORD"] = (record + info + "/RECORD,,\n").encode()
    path = os.path.join(out, "stonepack-%s-py3-none-%s.whl" % (version, ".".join(tags)))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in sorted(contents.items(), key=lambda item: (item[0].endswith("RECORD"), item[0])):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, (0o755 if ".so" in name else 0o644) << 16
            wheel.writestr(entry, data)
    print(path)


if __name__ == "__main__":
    main(*sys.argv[1:])

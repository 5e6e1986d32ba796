"""wheel: a folder with the package becomes a wheel, by the standard library alone; the same folder makes the same bytes.

    python3 wheel.py FOLDER OUT        FOLDER has stonepack/ and LICENSE, README.md; prints the wheel's path

The tag says what the shared libraries ask of the system: the newest GLIBC_2.x that they name.
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
Requires-Python: >=3.8
Provides-Extra: testing
Requires-Dist: hypothesis; extra == "testing"
Requires-Dist: pytest; extra == "testing"
Classifier: License :: OSI Approved :: MIT License
Classifier: Topic :: Scientific/Engineering
Classifier: Typing :: Typed
Description-Content-Type: text/markdown

%s"""


def machine_tag(folder):
    """manylinux_2_N_MACHINE, N the newest glibc asked for, 17 at least."""
    newest = 17
    for name in os.listdir(folder):
        if ".so" in name:
            with open(os.path.join(folder, name), "rb") as file:
                newest = max([newest] + [int(n) for n in re.findall(rb"GLIBC_2\.(\d+)", file.read())])
    return "manylinux_2_%d_%s" % (newest, platform.machine())


def digest(data):
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def read(path):
    with open(path, "rb") as file:
        return file.read()


def main(folder, out):
    package = os.path.join(folder, "stonepack")
    told = read(os.path.join(package, "_bindings.py")).decode()
    version = ".".join(re.search(r"SP_VERSION_%s = (\d+)" % part, told).group(1) for part in ("MAJOR", "MINOR", "PATCH"))
    tag, info = "py3-none-" + machine_tag(package), "stonepack-%s.dist-info" % version
    contents = {"stonepack/" + name: read(os.path.join(package, name)) for name in os.listdir(package)
                if os.path.isfile(os.path.join(package, name))}
    contents[info + "/METADATA"] = (META % (version, read(os.path.join(folder, "README.md")).decode())).encode()
    contents[info + "/LICENSE"] = read(os.path.join(folder, "LICENSE"))
    contents[info + "/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: stonepack\nRoot-Is-Purelib: false\nTag: %s\n" % tag).encode()
    record = "".join("%s,%s,%d\n" % (name, digest(data), len(data)) for name, data in sorted(contents.items()))
    contents[info + "/RECORD"] = (record + info + "/RECORD,,\n").encode()
    path = os.path.join(out, "stonepack-%s-%s.whl" % (version, tag))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in sorted(contents.items(), key=lambda item: (item[0].endswith("RECORD"), item[0])):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, (0o755 if ".so" in name else 0o644) << 16
            wheel.writestr(entry, data)
    print(path)


if __name__ == "__main__":
    main(*sys.argv[1:])

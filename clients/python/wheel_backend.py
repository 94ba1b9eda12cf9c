"""Builds wheels of the package (PEP 517, PEP 660) with Python's own library, so that pip installs it from a checkout
without a registry: it asks for no build tool."""

import base64
import hashlib
import io
import pathlib
import re
import tarfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = "pelage"
METADATA = """\
Metadata-Version: 2.1
Name: {name}
Version: {version}
Summary: Grooming fur from Python: the client of the Pelage render server
License: Apache-2.0
Classifier: License :: OSI Approved :: Apache Software License
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Multimedia :: Graphics :: 3D Rendering
Classifier: Typing :: Typed
Requires-Python: >=3.9
Provides-Extra: numpy
Requires-Dist: numpy>=1.20; extra == "numpy"
Description-Content-Type: text/markdown

{readme}"""
WHEEL = "Wheel-Version: 1.0\nGenerator: pelage\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
FIRST_DATE = (1980, 1, 1, 0, 0, 0)  # earliest date of a zip entry; fixed, so that the same sources give the same wheel


def version():
    text = (HERE / PACKAGE / "__init__.py").read_text(encoding="utf-8")
    return re.search(r'^__version__ = "(.+)"$', text, re.M)[1]


def metadata():
    readme = (HERE / "README.md").read_text(encoding="utf-8")
    return METADATA.format(name=PACKAGE, version=version(), readme=readme).encode()


def sources():
    """The package's files, by their paths in a wheel."""
    if not (HERE / PACKAGE / "commands.py").exists():
        raise SystemExit("pelage: a part of the package is made by the build: run `cmake --preset release && "
                         "cmake --build --preset release --target pelage-python`, then pip again")
    files = sorted(path for path in (HERE / PACKAGE).rglob("*") if path.suffix == ".py" or path.name == "py.typed")
    return {path.relative_to(HERE).as_posix(): path.read_bytes() for path in files}


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def write_wheel(folder, files):
    """Writes a wheel that installs the files, by their paths; gives its name."""
    info = f"{PACKAGE}-{version()}.dist-info"
    files = {**files, f"{info}/METADATA": metadata(), f"{info}/WHEEL": WHEEL.encode()}
    record = "".join(record_line(name, content) for name, content in files.items()) + f"{info}/RECORD,,\n"
    wheel = f"{PACKAGE}-{version()}-py3-none-any.whl"
    with zipfile.ZipFile(pathlib.Path(folder, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in {**files, f"{info}/RECORD": record.encode()}.items():
            entry = zipfile.ZipInfo(name, FIRST_DATE)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return write_wheel(wheel_directory, sources())


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    return write_wheel(wheel_directory, {f"{PACKAGE}.pth": f"{HERE}\n".encode()})


def build_sdist(sdist_directory, config_settings=None):
    name = f"{PACKAGE}-{version()}"
    own = {path: (HERE / path).read_bytes() for path in ("pyproject.toml", "wheel_backend.py", "README.md")}
    with tarfile.open(pathlib.Path(sdist_directory, f"{name}.tar.gz"), "w:gz") as archive:
        for path, content in {"PKG-INFO": metadata(), **own, **sources()}.items():
            entry = tarfile.TarInfo(f"{name}/{path}")
            entry.size = len(content)
            archive.addfile(entry, io.BytesIO(content))
    return f"{name}.tar.gz"

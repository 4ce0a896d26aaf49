"""One file out of one package, by the ordinary clients of the registries. Clause: TOOL-CORPUS-6."""

import io
import shutil
import subprocess
import tarfile
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.corpus.manifest import Client, Source

Obtain = Callable[[Source], Accepted[bytes] | Rejected]

_TIMEOUT: Final = 600.0


def not_obtainable(detail: str) -> Rejected:
    """Why a package's file cannot be had. Clause: TOOL-CORPUS-6."""
    return Rejected(Reason.NOT_OBTAINABLE, Clause.TOOL_CORPUS_6, detail=" ".join(detail.split()))


def obtain(source: Source) -> Accepted[bytes] | Rejected:
    """The bytes of the file that a source names; its hash is not looked at.

    Clause: TOOL-CORPUS-6.
    """
    return and_then(package(source), lambda archive: file_in(archive, source))


def obtaining() -> Obtain:
    """As `obtain`, but the last package is remembered: its next file needs no client."""
    last: dict[tuple[Client, str, str], Accepted[bytes] | Rejected] = {}

    def by(source: Source) -> Accepted[bytes] | Rejected:
        key = (source.client, source.package, source.version)
        if key not in last:
            archive = package(source)
            last.clear()
            last[key] = archive
        return and_then(last[key], lambda archive: file_in(archive, source))

    return by


def package(source: Source) -> Accepted[bytes] | Rejected:
    """The tar file of a package's content. The client runs in a folder that is then removed."""
    with TemporaryDirectory(prefix="clers-") as name:
        match source.client:
            case Client.NPM:
                return _npm(source, Path(name))
            case Client.DEBIAN:
                return _debian(source, Path(name))
            case _:
                assert_never(source.client)


def _npm(source: Source, folder: Path) -> Accepted[bytes] | Rejected:
    command = ["npm", "pack", "--silent", f"{source.package}@{source.version}"]
    return and_then(
        _run(command, folder),
        lambda _: and_then(_only(folder, ".tgz"), lambda file: Accepted(file.read_bytes())),
    )


def _debian(source: Source, folder: Path) -> Accepted[bytes] | Rejected:
    command = ["apt-get", "download", "-qq", f"{source.package}={source.version}"]
    return and_then(
        _run(command, folder),
        lambda _: and_then(
            _only(folder, ".deb"),
            lambda file: _run(["dpkg-deb", "--fsys-tarfile", file.name], folder),
        ),
    )


def file_in(archive: bytes, source: Source) -> Accepted[bytes] | Rejected:
    """The file in the package's tar file, or in the tar file that is in there."""
    start = "./" if source.client is Client.DEBIAN else ""
    found = _member(archive, start + source.path)
    return and_then(found, lambda data: _member(data, source.member)) if source.member else found


def _run(command: list[str], folder: Path) -> Accepted[bytes] | Rejected:
    """What a command prints; its last line on standard error where it fails."""
    program = command[0]
    if shutil.which(program) is None:
        return not_obtainable(f"{program} is not installed")
    try:
        done = subprocess.run(
            command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=_TIMEOUT
        )
    except subprocess.TimeoutExpired:
        return not_obtainable(f"{program} took more than {_TIMEOUT:.0f} s")
    except OSError as error:
        return not_obtainable(f"{program}: {error.strerror}")
    if done.returncode != 0:
        said = done.stderr.decode(errors="replace").strip().splitlines()
        return not_obtainable(f"{' '.join(command)}: {said[-1] if said else done.returncode}")
    return Accepted(done.stdout)


def _only(folder: Path, suffix: str) -> Accepted[Path] | Rejected:
    files = [file for file in folder.iterdir() if file.suffix == suffix]
    if len(files) != 1:
        return not_obtainable(f"{len(files)} {suffix} files where one was to be")
    return Accepted(files[0])


def _member(archive: bytes, path: str) -> Accepted[bytes] | Rejected:
    """One file of a tar file. Nothing is unpacked, so no path in it can lead anywhere."""
    try:
        with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
            file = tar.extractfile(path)
            if file is None:
                return not_obtainable(f"{path} is no file in the package")
            return Accepted(file.read())
    except KeyError:
        return not_obtainable(f"{path} is not in the package")
    except (tarfile.TarError, OSError, EOFError) as error:
        return not_obtainable(f"{path}: {error}")

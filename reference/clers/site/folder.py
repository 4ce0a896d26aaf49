"""A site in a folder: written whole or not at all, over nothing but a site. TOOL-SITE-12."""

import os
import secrets
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Final

import msgspec

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.site.places import MANIFEST

FORMAT: Final = "clers site 1"


class Manifest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a site has: its own files by path, so that no other is ever removed."""

    format: str
    files: tuple[str, ...]


def _unwritable(detail: str) -> Rejected:
    return Rejected(Reason.UNWRITABLE_FILE, Clause.TOOL_SITE_12, detail=detail)


def stranger(folder: Path) -> str | None:
    """What stands in a folder and is not of a site, or None; a folder may also not be there.

    Raises OSError if the folder cannot be read. Clause: TOOL-SITE-12.
    """
    if not folder.exists():
        return None
    if not folder.is_dir():
        return "not a folder"
    found = sorted(path.relative_to(folder).as_posix() for path in _files(folder))
    if not found:
        return None
    try:
        said = msgspec.json.decode((folder / MANIFEST).read_bytes(), type=Manifest)
    except (FileNotFoundError, msgspec.DecodeError):
        return f"it has files, and no {MANIFEST} says that they are a site's"
    if said.format != FORMAT:
        return f"{MANIFEST} has another format: {said.format}"
    own = {*said.files, MANIFEST}
    return next((f"{path} is not of the site" for path in found if path not in own), None)


def _files(folder: Path) -> list[Path]:
    """All files and links to anything below a folder, and folders that have nothing in them."""
    return [
        Path(place, name)
        for place, folders, names in os.walk(folder)
        for name in (*names, *(sub for sub in folders if _bare(Path(place, sub))))
    ]


def _bare(folder: Path) -> bool:
    return folder.is_symlink() or not any(folder.iterdir())


def write_site(folder: Path, files: Mapping[str, bytes]) -> Accepted[Path] | Rejected:
    """Give a folder these files and no others, or leave it as it was. Clause: TOOL-SITE-12.

    The new folder is written beside the old one and then takes its name. An interrupt goes on to
    the caller after the new folder was removed.
    """
    try:
        target = Path(os.path.realpath(folder))
        why = stranger(target)
        if why is not None:
            return _unwritable(why)
        target.parent.mkdir(parents=True, exist_ok=True)
        new = target.with_name(f".{target.name}.{secrets.token_hex(8)}.new")
        try:
            _fill(new, files)
            _replace(target, new)
        finally:
            shutil.rmtree(new, ignore_errors=True)
    except OSError as error:
        return _unwritable(error.strerror or str(error))
    except ValueError as error:  # a name with a null byte
        return _unwritable(str(error))
    return Accepted(folder)


def _fill(new: Path, files: Mapping[str, bytes]) -> None:
    manifest = msgspec.json.format(msgspec.json.encode(Manifest(FORMAT, tuple(sorted(files)))))
    for path, data in {**files, MANIFEST: manifest + b"\n"}.items():
        (new / path).parent.mkdir(parents=True, exist_ok=True)
        (new / path).write_bytes(data)


def _replace(target: Path, new: Path) -> None:
    """The new folder takes the name; the old one is back in its place if that fails."""
    if not target.exists():
        new.rename(target)
        return
    old = target.with_name(f".{target.name}.{secrets.token_hex(8)}.old")
    target.rename(old)
    try:
        new.rename(target)
    except BaseException:
        old.rename(target)
        raise
    shutil.rmtree(old, ignore_errors=True)

"""What is known of findings: what the authors of a codec say of them. Clause: ORCL-CODEC-15."""

from collections.abc import Mapping
from typing import Final

_DRACO: Final = "https://github.com/google/draco/issues"
_BINDING: Final = (
    "The binding does it, before Draco sees the mesh: DracoPy builds meshes with Draco's "
    "`TriangleSoupMeshBuilder`, which makes one vertex of those at one place "
    "([DracoPy #28](https://github.com/seung-lab/DracoPy/pull/28)); its option `preserve_order` "
    "does not, and takes the sequential method."
)

REMARKS: Final[Mapping[tuple[str, str], str]] = {
    ("draco-sequential", "vertices-merged"): _BINDING,
    ("draco-sequential", "lost-isolated-vertices"): (
        "Isolated vertices at one place become one; others are kept. " + _BINDING
    ),
    ("draco", "vertices-merged"): (
        _BINDING + " Edgebreaker then splits again what is not manifold, so that vertices stay "
        "merged along common edges only."
    ),
    ("draco", "dropped-degenerate-faces"): (
        "By design: Edgebreaker codes proper faces, “all degenerate faces are ignored” "
        f"([draco #356]({_DRACO}/356)). The sequential method keeps them."
    ),
    ("draco", "lost-isolated-vertices"): (
        "By design: vertices are coded by the faces around them, and those “can disappear when "
        "they are either isolated or they are connected” only to degenerate faces "
        f"([draco #99]({_DRACO}/99)). The sequential method keeps them."
    ),
    ("draco", "vertices-lost"): (
        "By design, with dropped degenerate faces: a vertex that only they use "
        f"([draco #99]({_DRACO}/99)). The sequential method keeps it."
    ),
    ("draco", "vertices-split"): (
        "By design: “Draco automatically splits non-manifold vertices to ensure the resulting "
        f"surface is manifold” ([draco #503]({_DRACO}/503), [#71]({_DRACO}/71)). The sequential "
        "method keeps them."
    ),
}
"""By setting, or by the word that the setting begins with, and finding."""

UNKNOWN: Final = "No statement of the authors is known to us."


def remark(setting: str, finding: str) -> str:
    """What is known of a finding in a setting."""
    general = setting.partition("-")[0]
    known = REMARKS.get((setting, finding))
    return REMARKS.get((general, finding), UNKNOWN) if known is None else known

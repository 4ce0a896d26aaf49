"""Reads words into a list of faces that is never made shorter: what is left in it is shown too.

As long as each mesh is at least as large as the one before, nobody sees it.
"""

from reference import Message, serve

FACES: list[object] = []


def spoil(request: Message, result: Message) -> Message:
    faces = result.get("faces")
    if request["op"] != "word.decode" or not isinstance(faces, list):
        return result
    FACES[: len(faces)] = faces
    return {**result, "faces": FACES}


serve(spoil)

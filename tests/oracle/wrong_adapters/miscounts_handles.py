"""Each record of the handle data leads one corner too far."""

from reference import Message, serve


def spoil(request: Message, result: Message) -> Message:
    handles = result.get("handles")
    if request["op"] != "word.encode" or not isinstance(handles, list):
        return result
    return {**result, "handles": [{**record, "at": record["at"] + 1} for record in handles]}


serve(spoil)

"""Takes right for left: R and L change places in every word that it writes or reads."""

from reference import Message, serve

SWAP = str.maketrans("RL", "LR")


def turned(message: Message) -> Message:
    word = message.get("word")
    return {**message, "word": word.translate(SWAP)} if isinstance(word, str) else message


def read(request: Message) -> Message:
    given = request["in"]
    if request["op"] != "word.decode" or not isinstance(given, dict):
        return request
    return {**request, "in": turned(given)}


def write(request: Message, result: Message) -> Message:
    return turned(result) if request["op"] == "word.encode" else result


serve(write, read)

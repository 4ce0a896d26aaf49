"""All smaller requests that a single step leads to, promising ones first. Clause: ORCL-SHRINK-3."""

from collections.abc import Iterator
from typing import Final, assert_never

import msgspec

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import Operation
from clers.conformance.payloads import Payload
from clers.conformance.served import arithmetic
from clers.conventions.result import Accepted
from clers.oracle.fuzz.behind import Behind, behind
from clers.oracle.fuzz.changes import bits_of_digits, digits_of
from clers.oracle.fuzz.shrinking import others
from clers.oracle.fuzz.shrinking.blocks import nearer, without_blocks
from clers.oracle.fuzz.shrinking.contracting import contracted, flipped_and_contracted
from clers.oracle.fuzz.shrinking.nets import (
    Step,
    plainer,
    without_components,
    without_faces,
    without_vertices,
)
from clers.oracle.fuzz.shrinking.sizes import size_of
from clers.oracle.fuzz.shrinking.smallest import small_ones
from clers.oracle.fuzz.shrinking.surgery import cut, filled

NET_STEPS: Final[tuple[Step, ...]] = (
    small_ones,
    without_components,
    without_faces,
    without_vertices,
    contracted,
    cut,
    filled,
    plainer,
    flipped_and_contracted,
)
"""What may be done to a mesh, in this order. Clause: ORCL-SHRINK-3."""


def smaller(operation: Operation) -> Iterator[Operation]:
    """Requests that are smaller by one step; some of them are of no use. ORCL-SHRINK-2, -3."""
    size = size_of(operation)
    for candidate in _candidates(operation):
        if size_of(candidate) < size:
            yield candidate


def _candidates(operation: Operation) -> Iterator[Operation]:
    """Of what is made of a mesh only what is made of another. Clause: ORCL-SHRINK-3."""
    about = behind(operation)
    if about is not None:
        yield from _of_net(about)
    for given in _of_input(operation):
        candidate = msgspec.structs.replace(operation, input=given)
        if about is None or behind(candidate) is not None:
            yield candidate


def _of_net(about: Behind) -> Iterator[Operation]:
    for step in NET_STEPS:
        for net in step(about.net):
            made = about.rebuild(net)
            if made is not None:
                yield made


def _of_input(operation: Operation) -> Iterator[Payload]:
    """Smaller inputs, whatever they mean."""
    match operation:
        case message.WordDecode(input=stream) | message.CodeEncode(input=stream):
            yield from others.smaller_streams(stream)
            yield from others.plainer_words(stream)
        case message.CodeDecode(input=given):
            for bits in others.smaller_bits(given.bits):
                yield msgspec.structs.replace(given, bits=bits)
            yield from _smaller_counts(given)
        case message.MeshDecode(input=file):
            for data in others.smaller_files(bytes.fromhex(file.hex)):
                yield form.FileForm(hex=data.hex())
        case message.ArithmeticEncode(input=told):
            yield from others.smaller_messages(told)
        case message.ArithmeticDecode(input=coded):
            yield from _smaller_coded(coded)
        case message.Apply(input=script):
            for text in others.smaller_scripts(script.script):
                yield form.ScriptForm(script=text)
        case message.MeshEncode(input=file):
            yield msgspec.structs.replace(file, accuracy=form.ExactForm())
        case message.Echo() | message.Classify() | message.WordEncode() | message.Roundtrip():
            pass
        case _:
            assert_never(operation)


def _smaller_counts(given: form.FromWord) -> Iterator[Payload]:
    for closings in without_blocks(given.closings):
        yield msgspec.structs.replace(given, closings=closings)
    for symbols in nearer(given.symbols):
        yield msgspec.structs.replace(given, symbols=symbols)
        if symbols < len(digits_of(given.bits)):
            bits = bits_of_digits(digits_of(given.bits)[:symbols])
            yield msgspec.structs.replace(given, symbols=symbols, bits=bits)
    for count in nearer(given.components_with_boundary):
        yield msgspec.structs.replace(given, components_with_boundary=count)


def _smaller_coded(given: form.Coded) -> Iterator[Payload]:
    """What the reference reads in the bits, with less of it, written anew; then the bits."""
    told = form.ToCode(coder=given.coder, model=given.model, symbols=())
    symbols = arithmetic.decode(given)
    if isinstance(symbols, Accepted):
        told = msgspec.structs.replace(told, symbols=symbols.value.symbols)
        for less in others.smaller_messages(told):
            written = arithmetic.encode(less)
            if isinstance(written, Accepted):
                count = len(less.symbols)
                yield form.Coded(
                    coder=less.coder, model=less.model, bits=written.value, count=count
                )
    for bits in others.smaller_bits(given.bits):
        yield msgspec.structs.replace(given, bits=bits)
    for count in nearer(given.count):
        yield msgspec.structs.replace(given, count=count)
    for model in others.smaller_models(given.model):
        yield msgspec.structs.replace(given, model=model)

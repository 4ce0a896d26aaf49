"""`clers bench`: what things cost, as ratios taken in one run, for machines are noisy."""

import typer

from clers.cli import bits, builds, codec_survey, speed
from clers.cli.meshes import AsJson
from clers.cli.output import json, line, progress, table

app = typer.Typer(
    no_args_is_help=True, rich_markup_mode=None, help="Measure bits, time and memory."
)
app.command()(bits.bits)
app.command()(bits.bounds)
app.command()(builds.builds)
app.command()(codec_survey.codecs)
app.command()(speed.speed)


@app.command()
def growth(
    sizes: str = typer.Option("100000,1000000", help="Numbers of faces, comma-separated."),
    rounds: int = typer.Option(3, min=1, help="Runs of each size; the quickest counts."),
    shuffle: bool = typer.Option(False, "--shuffle", help="Faces and vertices in random order."),
    as_json: AsJson = False,
) -> None:
    """Time and memory per triangle of each step of the path, and how they grow with size."""
    from clers.measure.growth import measure

    numbers = [int(size) for size in sizes.split(",") if size.strip().isdecimal()]
    if len(numbers) < 2:
        raise typer.BadParameter("two sizes at least", param_hint="--sizes")
    with progress("bench", len(numbers) * rounds) as step:
        found = measure(numbers, rounds, shuffle, step)
    if as_json:
        json(found)
        return
    line(f"Python {found.python}, {found.machine}, family {found.family}, best of {rounds}")
    heads = ["step", *(f"µs/triangle at {n}" for n in found.faces), "last / first"]
    rows = [
        [row.step, *(f"{1e6 * t:.3f}" for t in row.seconds_per_triangle), f"{row.ratio:.2f}"]
        for row in found.steps
    ]
    table(heads, rows)
    for faces, peak in zip(found.faces, found.peak_bytes_per_triangle, strict=True):
        line(f"peak memory at {faces} faces: {peak:.0f} bytes per triangle")

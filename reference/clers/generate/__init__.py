"""Random and regular meshes: Hypothesis strategies for every law, and plain functions.

For a property test of your own encoder:

    from hypothesis import given
    from clers.complexes.corner_table import face_list
    from clers.generate.surfaces import surfaces

    @given(surfaces(max_faces=60, genus=(0, 2), curves=(0, 0)))
    def test_round_trip(surface):
        faces = face_list(surface).faces
        ...

`surfaces`, `closed_surfaces`, `spheres`, `small_surfaces`, `scripts` are in `surfaces`; `solids`,
with positions, in `solids`; `uniform_spheres`, each rooted sphere as likely, in `uniform`;
`complexes` of every dimension, most of them no manifolds, in `every_dimension`; `manifolds` of
prescribed dimension, orientability, genus, curves and components, and slightly `broken` ones, in
`manifolds`; `face_lists`, some of them faulty, in
`face_lists`; pairs under two labellings in `relabelled`. Without Hypothesis: `families`,
`irregular` and `uniform.uniform_sphere` make meshes of any size, `kinds.random_script` makes
scripts. `domains.strategy_for` finds the strategy of a law's domain, and `distribution` prints what
the strategies reach.
"""

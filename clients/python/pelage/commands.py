"""A method for each command of the contract. Made by generate.py."""

from __future__ import annotations

from typing import Any, Dict, Generic, Literal, Optional, Sequence, TypeVar, Union

from .options import Options
from .schemas import (
    Brush,
    Coat,
    Colour,
    CurveGroup,
    Direction,
    Environment,
    Eye,
    Field,
    Ground,
    Key,
    Light,
    Look,
    MapEncoding,
    MaskAll,
    MaskBox,
    MaskPart,
    MaskPicture,
    MaskSphere,
    NamedAttractor,
    NamedBlower,
    PictureName,
    Position,
    SkinRegion,
    Stroke,
    Symmetry,
    TrimPlane,
    TrimSphere,
    Units,
    Wind,
)

R = TypeVar("R")


class Commands(Generic[R]):
    """Commands as methods. A parameter that is left out is not sent, and takes its default.

    author: Who makes the change, for the log and for those who follow the scene; at most 200 bytes of UTF-8.
    dry_run: Says what the command would do and changes nothing.
    if_match: A revision. At another one nothing is done, and `Conflict` is raised.

    A value that breaks the contract raises `Refused` with a pointer to it; nothing is changed then.
    """

    def _run(self, command: Dict[str, Any], options: Options) -> R:
        """`command`: with None for what is not to be sent."""
        raise NotImplementedError

    def comb(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        lean: Optional[float] = None,
        keep_inclination: Optional[bool] = None,
        direction: Optional[Direction] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Turns fur the way the stroke moves; as a flood, to `direction` everywhere.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        lean: Inclination that combing tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
        keep_inclination: Turns the heading alone. Default false.
        direction: Where fur is turned to as a flood. Required by a flood, refused with a stroke. 3 items (any
            length).
        """
        return self._run(
            {
                "op": "comb", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "lean": lean, "keep_inclination": keep_inclination, "direction": direction,
            },
            Options(author, dry_run, if_match),
        )

    def blow(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        blower: Optional[str] = None,
        source: Optional[Position] = None,
        direction: Optional[Direction] = None,
        cone_degrees: Optional[float] = None,
        softness: Optional[float] = None,
        fall: Optional[float] = None,
        units: Optional[Units] = None,
        strength: Optional[float] = None,
        lean: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Wind from a source, or from a blower that stays, inside a cone. A stroke restricts it to what its brush
        covers.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        blower: Name of a blower of the scene, in place of all that follows. Default "".
        source: Where the wind comes from. 3 items (model units).
        direction: Where the wind blows, the axis of its cone. 3 items (any length). Default [0, -1, 0].
        cone_degrees: Half angle of the cone. 0 to 180 (degrees). Default 40.
        softness: Share of the cone over which its edge fades. 0 to 1 (share). Default 0.25.
        fall: Distance at which the wind has half its strength, in `units`; 0: it does not fall. 0 to 1e+27 (as
            `units`). Default 0.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 0.5.
        lean: Inclination that the wind tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
        """
        return self._run(
            {
                "op": "blow", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "blower": blower,
                "source": source, "direction": direction, "cone_degrees": cone_degrees, "softness": softness,
                "fall": fall, "units": units, "strength": strength, "lean": lean,
            },
            Options(author, dry_run, if_match),
        )

    def attract(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        attractor: Optional[str] = None,
        point: Optional[Position] = None,
        radius: Optional[float] = None,
        units: Optional[Units] = None,
        strength: Optional[float] = None,
        duration: Optional[float] = None,
        threshold: Optional[float] = None,
        max_stretch: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """A stick, or an attractor that stays, pulls fur to it and stretches it. A stroke restricts it to what its
        brush covers.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        attractor: Name of an attractor of the scene, in place of all that follows. Default "".
        point: Where the stick is. 3 items (model units).
        radius: Distance beyond which nothing is pulled, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`).
            Default 0.2.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 0.5.
        duration: How long the stick pulls. 0 to 10000 (seconds). Default 1.
        threshold: Stretch that fur takes without growing. 0 to 1000 (share). Default 0.3.
        max_stretch: Largest length over the length before any stretch. 1 to 100 (factor). Default 3.
        """
        return self._run(
            {
                "op": "attract", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "attractor": attractor,
                "point": point, "radius": radius, "units": units, "strength": strength, "duration": duration,
                "threshold": threshold, "max_stretch": max_stretch,
            },
            Options(author, dry_run, if_match),
        )

    def interpolate(
        self,
        *,
        keys: Sequence[Key],
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        sigma: Optional[float] = None,
        units: Optional[Units] = None,
        distance: Optional[Literal["straight", "dijkstra", "heat"]] = None,
        strength: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Spreads keys over the surface with Gaussian weights of the distance. What no key reaches keeps its
        value.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        keys: What fur is like at a few places. 1 to 1024 items.
        sigma: Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes. 1e-27 to 1e+27 (as
            `units`). Default 0.2.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        distance: How distances are measured. straight: through space. dijkstra: along edges, too long by some
            percent. heat: along the surface by the heat method, slower. Default "dijkstra".
        strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
        """
        return self._run(
            {
                "op": "interpolate", "keys": keys, "stroke": stroke, "brush": brush, "edit_layer": edit_layer,
                "sigma": sigma, "units": units, "distance": distance, "strength": strength,
            },
            Options(author, dry_run, if_match),
        )

    def flow(
        self,
        *,
        curves: Sequence[Sequence[Position]],
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        sigma: Optional[float] = None,
        units: Optional[Units] = None,
        distance: Optional[Literal["straight", "dijkstra", "heat"]] = None,
        inclination: Optional[float] = None,
        strength: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Lays the fur of the whole body along curves drawn on it, from the first point of each to the last.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        curves: Curves on the model, each a list of points that fur follows from the first to the last. 1 to 64 items.
        sigma: Width of the Gaussians, in `units`; at least 0.000001 and at most 1000000 sizes. 1e-27 to 1e+27 (as
            `units`). Default 0.2.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        distance: How distances are measured. straight: through space. dijkstra: along edges, too long by some
            percent. heat: along the surface by the heat method, slower. Default "dijkstra".
        inclination: How far fur leans: 0 upright, 1 lying. The fur keeps its own unless given. 0 to 1 (share).
        strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
        """
        return self._run(
            {
                "op": "flow", "curves": curves, "stroke": stroke, "brush": brush, "edit_layer": edit_layer,
                "sigma": sigma, "units": units, "distance": distance, "inclination": inclination,
                "strength": strength,
            },
            Options(author, dry_run, if_match),
        )

    def smooth(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        t: Optional[float] = None,
        passes: Optional[int] = None,
        keep_inclination: Optional[bool] = None,
        fields: Optional[Sequence[Field]] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Blends each value with the mean of its neighbours, nearer ones counting more.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        t: Share of the mean in each pass; up to 0.5 nothing oscillates. 0 to 1 (share). Default 0.5.
        passes: How often the values are blended. 1 to 10000. Default 3.
        keep_inclination: Smooths headings alone, so that no tuft rises where opposite directions meet. Default false.
        fields: Fields that are smoothed. 1 to 13 items. Default ["direction"].
        """
        return self._run(
            {
                "op": "smooth", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood, "t": t,
                "passes": passes, "keep_inclination": keep_inclination, "fields": fields,
            },
            Options(author, dry_run, if_match),
        )

    def noise(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        seed: Optional[int] = None,
        amount: Optional[float] = None,
        feature_size: Optional[float] = None,
        units: Optional[Units] = None,
        fields: Optional[Sequence[Field]] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Adds random numbers that are a pure function of the seed and the place; inverted it takes them off.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        seed: Other seeds give other noise. 0 to 4294967295. Default 1.
        amount: How large the numbers are: for directions in inclinations; for length, stretch and width as a share of
            the value; for other fields in their own unit. 0 to 10 (varies). Default 0.2.
        feature_size: Size of the noise's features, in `units`. At 0 every vertex moves for itself. 0 to 1e+27 (as
            `units`). Default 0.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        fields: Fields that noise is added to. 1 to 13 items. Default ["direction"].
        """
        return self._run(
            {
                "op": "noise", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "seed": seed, "amount": amount, "feature_size": feature_size, "units": units, "fields": fields,
            },
            Options(author, dry_run, if_match),
        )

    def unify(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        direction: Optional[Direction] = None,
        inclination: Optional[float] = None,
        length: Optional[float] = None,
        units: Optional[Units] = None,
        mean: Optional[Sequence[Field]] = None,
        weight: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Blends to a value, or to the mean under the brush.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        direction: Where fur is turned to. 3 items (any length).
        inclination: How far fur leans: 0 upright, 1 lying. The fur keeps its own unless given. 0 to 1 (share).
        length: Length that fur tends to, in `units`; at most 10 sizes. The fur keeps its own unless given. 0 to 1e+27
            (as `units`).
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        mean: Fields that go to their weighted mean under the brush. 0 to 13 items. Default [].
        weight: How far values go, on top of the brush's own strength. 0 to 1 (share). Default 0.5.
        """
        return self._run(
            {
                "op": "unify", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "direction": direction, "inclination": inclination, "length": length, "units": units, "mean": mean,
                "weight": weight,
            },
            Options(author, dry_run, if_match),
        )

    def part(
        self,
        *,
        stroke: Stroke,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        lean: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """A line that fur leans away from on both sides; inverted fur leans to it.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        lean: Inclination that the fur tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.7.
        """
        return self._run(
            {"op": "part", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "lean": lean},
            Options(author, dry_run, if_match),
        )

    def whorl(
        self,
        *,
        stroke: Stroke,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        turn_degrees: Optional[float] = None,
        lean: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Turns fur round the nearest place of the stroke: a cowlick. Inverted it turns the other way.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        turn_degrees: Way that fur turns, counter-clockwise seen from outside: at 0 it points out, at 90 it circles,
            at 180 it points in. -180 to 180 (degrees). Default 70.
        lean: Inclination that the fur tends to: 0 upright, 1 lying. 0 to 1 (share). Default 0.8.
        """
        return self._run(
            {
                "op": "whorl", "stroke": stroke, "brush": brush, "edit_layer": edit_layer,
                "turn_degrees": turn_degrees, "lean": lean,
            },
            Options(author, dry_run, if_match),
        )

    def length(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        mode: Optional[Literal["set", "add", "scale", "average", "jitter", "min", "max"]] = None,
        value: Optional[float] = None,
        units: Optional[Units] = None,
        seed: Optional[int] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Changes how long fur is.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        mode: How `value` changes the length. average: to the mean under the brush. jitter: by a random share. min,
            max: not under, not over. Default "set".
        value: A length in `units`, at most 10 sizes and below 0 for add only; a factor for scale, at most 1000000; a
            share for jitter, at most 1. -1e+27 to 1e+27 (varies). Default 0.03.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        seed: Other seeds give other random shares; for jitter. 0 to 4294967295. Default 1.
        """
        return self._run(
            {
                "op": "length", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "mode": mode, "value": value, "units": units, "seed": seed,
            },
            Options(author, dry_run, if_match),
        )

    def trim(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        plane: Optional[TrimPlane] = None,
        sphere: Optional[TrimSphere] = None,
        height: Optional[float] = None,
        units: Optional[Units] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Cuts fur by a plane, by a sphere or to a height over the skin, by the way that it leans. A flood cuts
        wholly, whatever the strength.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        plane: Plane that fur is cut by.
        sphere: Sphere that fur is cut by.
        height: Height over the skin that fur is cut to, in `units`; at most 1000000 sizes. 0 to 1e+27 (as `units`).
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        """
        return self._run(
            {
                "op": "trim", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "plane": plane, "sphere": sphere, "height": height, "units": units,
            },
            Options(author, dry_run, if_match),
        )

    def lift(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Raises fur; inverted it lays it down. Fur that stands upright has no heading and stays.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        """
        return self._run(
            {"op": "lift", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood},
            Options(author, dry_run, if_match),
        )

    def erase(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        checkpoint: Optional[str] = None,
        revision: Optional[int] = None,
        fields: Optional[Sequence[Field]] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Goes back to the first groom, or to a checkpoint or a revision of this scene; with a layer and neither
        of them, takes away what the layer adds. The mask stays unless it is named.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        checkpoint: Name of the checkpoint to go back to. Empty: the first groom, or `revision`. Default "".
        revision: Revision of this model to go back to. 0 to 18446744073709551615.
        fields: Fields that go back; all but the mask when empty. 0 to 13 items. Default [].
        """
        return self._run(
            {
                "op": "erase", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "checkpoint": checkpoint, "revision": revision, "fields": fields,
            },
            Options(author, dry_run, if_match),
        )

    def clump(
        self,
        *,
        stroke: Stroke,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        gather: Optional[float] = None,
        amount: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Turns fur to the line of the stroke and gathers its tips; inverted it opens them.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        gather: How far fur turns. 0 to 1 (share). Default 0.3.
        amount: Value that the field clump tends to. 0 to 1 (share). Default 0.6.
        """
        return self._run(
            {
                "op": "clump", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "gather": gather,
                "amount": amount,
            },
            Options(author, dry_run, if_match),
        )

    def curl(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        amount: Optional[float] = None,
        turn_degrees: Optional[float] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Curls fur and turns its heading; inverted it takes the curl out.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        amount: Value that the field curl tends to. 0 to 1 (share). Default 0.6.
        turn_degrees: How far the heading turns, counter-clockwise seen from outside. -180 to 180 (degrees). Default
            0.
        """
        return self._run(
            {
                "op": "curl", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "amount": amount, "turn_degrees": turn_degrees,
            },
            Options(author, dry_run, if_match),
        )

    def paint(
        self,
        *,
        stroke: Optional[Stroke] = None,
        brush: Optional[Brush] = None,
        edit_layer: Optional[str] = None,
        flood: Optional[bool] = None,
        field: Optional[Field] = None,
        value: Optional[float] = None,
        colour: Optional[Colour] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Paints a field; inverted it takes it back to its default.

        stroke: Where a brush goes, as samples in order. It can be sent in parts.
        brush: How far and how strongly a tool reaches round a stroke.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        flood: Works everywhere in place of under a stroke. Default false.
        field: Field that is painted. Not direction, length or stretch, which have tools of their own. Default
            "density".
        value: Value that the field tends to: at most 1, for width and stiffness 4. For a colour how much of the
            coat's own it covers. 0 to 4 (varies). Default 1.
        colour: Colour to paint; for root_colour and tip_colour only. Default "#ffffff".
        """
        return self._run(
            {
                "op": "paint", "stroke": stroke, "brush": brush, "edit_layer": edit_layer, "flood": flood,
                "field": field, "value": value, "colour": colour,
            },
            Options(author, dry_run, if_match),
        )

    def mask(
        self,
        *,
        action: Optional[Literal["select", "grow", "shrink", "smooth", "invert"]] = None,
        all: Optional[MaskAll] = None,
        vertices: Optional[Sequence[int]] = None,
        box: Optional[MaskBox] = None,
        sphere: Optional[MaskSphere] = None,
        part: Optional[MaskPart] = None,
        picture: Optional[MaskPicture] = None,
        combine: Optional[Literal["replace", "add", "subtract", "intersect"]] = None,
        value: Optional[float] = None,
        distance: Optional[float] = None,
        passes: Optional[int] = None,
        units: Optional[Units] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Chooses where tools work: they change what the mask is 1 on, and nothing where it is 0. Brushes paint it
        with `paint`. Only select takes a shape, combine and value; only grow and shrink a distance; only smooth
        passes.

        action: What is done with the mask: select chooses, grow and shrink move its edge, smooth softens it, invert
            swaps it. Default "select".
        all: Everything. What select takes when no shape is given.
        vertices: Numbers of the vertices that are chosen. 1 to 100000 items.
        box: Chooses what lies in a box.
        sphere: Chooses what lies in a sphere.
        part: The connected part of the model that is nearest.
        picture: An uploaded picture, read at the vertices' texture coordinates. luminance: by Rec. 709's weights of
            the file's own numbers, no curve undone.
        combine: How the shape joins the mask that is there. With replace the rest gets 1 - value. Default "replace".
        value: Mask value of what is chosen. 0 to 1 (share). Default 1.
        distance: How far the edge moves along edges of the mesh, in `units`; at most 1000000 sizes. 0 to 1e+27 (as
            `units`). Default 0.02.
        passes: How often the mask is smoothed. 1 to 10000. Default 3.
        units: What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's
            unit. Default "relative".
        """
        return self._run(
            {
                "op": "mask", "action": action, "all": all, "vertices": vertices, "box": box, "sphere": sphere,
                "part": part, "picture": picture, "combine": combine, "value": value, "distance": distance,
                "passes": passes, "units": units,
            },
            Options(author, dry_run, if_match),
        )

    def map(
        self,
        *,
        picture: PictureName,
        field: Optional[Field] = None,
        encoding: Optional[MapEncoding] = None,
        scale: Optional[float] = None,
        units: Optional[Units] = None,
        strength: Optional[float] = None,
        tile: Optional[int] = None,
        edit_layer: Optional[str] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Puts a field in place of what a picture says at the vertices' texture coordinates, on seams the mean of
        what their islands say; or of what a list says of each vertex. The mask holds, unless it is the mask that
        is read. The commands of a batch read at most 8 different pictures.

        picture: The name that the upload of a picture was answered with.
        field: Field that is replaced. Default "length".
        encoding: What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and
            +v in red and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector:
            direction and length as one vector of floats, along +u, +v and the normal. automatic: uv_tangent of
            direction, else value. Default "automatic".
        scale: What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length.
            1e-27 to 1e+27 (as `units`). Default 1.
        units: Unit of a scale of lengths. relative: sizes; world: the model's unit. Default "relative".
        strength: How far the field goes to the picture's. 0 to 1 (share). Default 1.
        tile: UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture
            repeats, and all do. 0 to 9999. Default 0.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        """
        return self._run(
            {
                "op": "map", "picture": picture, "field": field, "encoding": encoding, "scale": scale, "units": units,
                "strength": strength, "tile": tile, "edit_layer": edit_layer,
            },
            Options(author, dry_run, if_match),
        )

    def retarget(
        self,
        *,
        scene: str,
        revision: Optional[int] = None,
        align: Optional[Literal["box", "none"]] = None,
        fields: Optional[Sequence[Field]] = None,
        strength: Optional[float] = None,
        edit_layer: Optional[str] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Takes the fields of another scene, or of this one at another revision, from the nearest places of its
        surface. The mask holds.

        scene: Id of the source, on the same server.
        revision: Revision of the source's model; the present one unless given. 0 to 18446744073709551615.
        align: How the models are laid over each other. box: their boxes lie over each other, axis by axis, and
            lengths stay shares of the size. none: both have the same coordinates, and lengths stay what they are in
            the model's unit. Default "box".
        fields: Fields that are taken; all but the mask when empty. 0 to 13 items. Default [].
        strength: How much it changes: 0 does nothing, 1 all. 0 to 1 (share). Default 1.
        edit_layer: Edit layer that keeps what changes; the groom below all edit layers unless named. Default "".
        """
        return self._run(
            {
                "op": "retarget", "scene": scene, "revision": revision, "align": align, "fields": fields,
                "strength": strength, "edit_layer": edit_layer,
            },
            Options(author, dry_run, if_match),
        )

    def set_blowers(
        self,
        *,
        blowers: Sequence[NamedBlower],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Places all winds that stay, for blow to use by their names, which differ.

        blowers: All winds that stay. 0 to 64 items.
        """
        return self._run(
            {"op": "set_blowers", "blowers": blowers},
            Options(author, dry_run, if_match),
        )

    def set_attractors(
        self,
        *,
        attractors: Sequence[NamedAttractor],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Places all sticks that stay, for attract to use by their names, which differ.

        attractors: All sticks that stay. 0 to 64 items.
        """
        return self._run(
            {"op": "set_attractors", "attractors": attractors},
            Options(author, dry_run, if_match),
        )

    def set_symmetry(
        self,
        *,
        symmetry: Symmetry,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """From now on each tool with a place works on all its images too, as one undo step. Places on the surface
        are mirrored to the nearest ones, so a roughly symmetric model will do. Floods have no images.

        symmetry: The new symmetry; with `planes` empty and `count` 1 there is none.
        """
        return self._run(
            {"op": "set_symmetry", "symmetry": symmetry},
            Options(author, dry_run, if_match),
        )

    def checkpoint(
        self,
        *,
        name: str,
        revision: Optional[int] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Gives this revision a name, or an earlier one; a name that is known moves.

        name: Name of the checkpoint.
        revision: Revision that gets the name; the one that this command makes unless given. 0 to
            18446744073709551615.
        """
        return self._run(
            {"op": "checkpoint", "name": name, "revision": revision},
            Options(author, dry_run, if_match),
        )

    def edit_layer(
        self,
        *,
        name: str,
        action: Optional[Literal["add", "set", "move", "merge_down", "remove"]] = None,
        weight: Optional[float] = None,
        muted: Optional[bool] = None,
        rename: Optional[str] = None,
        above: Optional[str] = None,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Makes, sets, moves, merges or removes an edit layer. What is seen is the groom below and, from the
        lowest layer up, weight times what each adds, held in each field's range. At most 14. Neither of what is
        merged may be muted; the layer that is merged into comes to weight 1.

        action: What is done with the edit layer. Default "add".
        name: Name of the edit layer.
        weight: How much the edit layer counts, for add and set; add takes 1 unless given. Below 0 it does the
            opposite of what was groomed. Tools change edit layers of at least .05 or at most -.05. -4 to 4 (factor).
        muted: Whether the edit layer is left out, for add and set.
        rename: The new name, for set. Default "".
        above: Edit layer that it comes to lie on, or "" for none. For add, where it lies on top unless given, and
            move, where it is required.
        """
        return self._run(
            {
                "op": "edit_layer", "name": name, "action": action, "weight": weight, "muted": muted,
                "rename": rename, "above": above,
            },
            Options(author, dry_run, if_match),
        )

    def set_coat(
        self,
        *,
        coat: Coat,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Sets how the strands of the fur are made: their form, colours and markings.

        coat: The new coat.
        """
        return self._run(
            {"op": "set_coat", "coat": coat},
            Options(author, dry_run, if_match),
        )

    def set_look(
        self,
        *,
        look: Look,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Sets how fur is shaded.

        look: The new look.
        """
        return self._run(
            {"op": "set_look", "look": look},
            Options(author, dry_run, if_match),
        )

    def set_lights(
        self,
        *,
        lights: Sequence[Light],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Places all lights of the scene; an empty list leaves the light from all around alone.

        lights: All lights of the scene. 0 to 8 items.
        """
        return self._run(
            {"op": "set_lights", "lights": lights},
            Options(author, dry_run, if_match),
        )

    def set_environment(
        self,
        *,
        environment: Environment,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Sets the light from all around.

        environment: The new light from all around.
        """
        return self._run(
            {"op": "set_environment", "environment": environment},
            Options(author, dry_run, if_match),
        )

    def set_ground(
        self,
        *,
        ground: Ground,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Sets a ground that catches shadow.

        ground: The new ground.
        """
        return self._run(
            {"op": "set_ground", "ground": ground},
            Options(author, dry_run, if_match),
        )

    def set_eyes(
        self,
        *,
        eyes: Sequence[Eye],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Places all eyes of the scene; an empty list takes them away. A new creature has two.

        eyes: All eyes of the scene. 0 to 8 items.
        """
        return self._run(
            {"op": "set_eyes", "eyes": eyes},
            Options(author, dry_run, if_match),
        )

    def set_curves(
        self,
        *,
        groups: Sequence[CurveGroup],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Places all whiskers, lashes and brows of the scene; an empty list takes them away. At most 4096 curves
        in all, filled ones too. A new creature has some.

        groups: All groups of curves of the scene. 0 to 16 items.
        """
        return self._run(
            {"op": "set_curves", "groups": groups},
            Options(author, dry_run, if_match),
        )

    def set_skin(
        self,
        *,
        regions: Sequence[SkinRegion],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Places all regions of bare skin; an empty list takes them away. A new creature has a nose, lips, ears
        and pads.

        regions: All regions of bare skin. 0 to 64 items.
        """
        return self._run(
            {"op": "set_skin", "regions": regions},
            Options(author, dry_run, if_match),
        )

    def set_skin_texture(
        self,
        *,
        picture: Union[Literal["own"], PictureName],
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Lays a picture on the model by its texture coordinates, in place of all colours of its own. `picture` is
        the name that the log has after an upload to `skin_texture`, made from the pixels alone; a picture that no
        scene of this server has used is refused. `own` takes it off again.

        picture: Name of an uploaded picture, or `own` for the model's own colours.
        """
        return self._run(
            {"op": "set_skin_texture", "picture": picture},
            Options(author, dry_run, if_match),
        )

    def set_wind(
        self,
        *,
        wind: Wind,
        author: Optional[str] = None,
        dry_run: bool = False,
        if_match: Optional[int] = None,
    ) -> R:
        """Sets the wind that moves the fur, and the time of the scene.

        wind: The new wind.
        """
        return self._run(
            {"op": "set_wind", "wind": wind},
            Options(author, dry_run, if_match),
        )

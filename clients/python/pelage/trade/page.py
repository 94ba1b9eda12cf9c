"""The report as one HTML page."""

from __future__ import annotations

from typing import List, Optional, Sequence

from .choices import Mean, best_within, cheapest_at, means_over
from .markup import Content, Element, document, image, items, table, tag
from .plots import TIER_COLOURS, knob_plots, scatter_plot, strands_plot, tier_plot
from .sweep import Report, Shown
from .table import Row, milliseconds, swept_scenes

BUDGETS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)  # milliseconds
ERRORS = (0.2, 0.16, 0.14, 0.12, 0.1, 0.08)
NO_DEARER = 1.02  # factor by which measured costs vary from run to run
MAX_NOISE = 1 / 3  # largest ratio of the truth's noise to a measured error at which the error is trusted


def page(report: Report) -> str:
    """Returns the page, which has no external resources."""
    rows, scenes = report.rows, swept_scenes(report.rows)
    scatters = [tag("div", tag("h3", scene), scatter_plot(rows, scene)) for scene in scenes]
    knobs = [tag("div", tag("h3", scene), knob_plots(rows, scene)) for scene in scenes]
    return document("Speed for accuracy", [
        *introduction(report),
        tag("h2", "What to choose when"), *advice(rows),
        tag("h2", "Side by side"),
        tag("p", "Below each picture its error map: black is none, yellow is as wrong as can be."),
        *gallery(report.pictures),
        tag("h2", "Where the tiers lie"), tier_plot(rows), tier_table(rows),
        tag("h2", "Error against time"),
        tag("p", "Each dot is a setting; rest the pointer on it for its name. Nothing lies below the line: it is the "
                 "best that each time buys."),
        tag("div", *scatters, class_="panels"),
        tag("h2", "What each knob buys"),
        tag("p", "One knob is turned, the others stay as in interactive. Left is faster, down is better: a good knob "
                 "goes down and hardly to the right."),
        *knobs,
        tag("h2", "Error against strands"),
        tag("p", "Strands that are kept get wider, up to 1.5 pixels. Where they are so wide already, a smaller number "
                 "keeps no fewer of them."),
        strands_plot(rows),
        tag("h2", "Is it sound?"), checks(rows), all_rows(rows),
    ])


def introduction(report: Report) -> List[Element]:
    size, repeats = report.options.size, report.options.repeats
    of_cpu = any(row.cpu_ms > 0 for row in report.rows)
    time = "milliseconds of CPU on all threads" if of_cpu else "wall milliseconds"
    return [
        tag("p", "How much time each quality takes, and how far its picture is from the truth. Drawn by ",
            tag("b", report.renderer), f" at {size} x {size} pixels. Another machine has other times: run ",
            tag("code", "pelage trade"), " there."),
        tag("p", tag("b", "Error"), " is FLIP, the difference that an eye sees when two pictures are swapped in "
            "place, from 0 to 1, over the fur only. ", tag("b", "Silhouette"), " is the same in a band of 8 pixels to "
            "each side of its edge. ", tag("b", "Time"), f" is {time} of drawing, without sending and encoding: the "
            f"least of {repeats}."),
        tag("p", "The ", tag("b", "truth"), f" traces every strand of the same fur, in {report.options.passes} passes. "
            "Other qualities rasterize them, or a share of them."),
    ]


def advice(rows: Sequence[Row]) -> List[Element]:
    scenes = swept_scenes(rows)
    settings = means_over(rows, scenes)
    if not settings:
        return [tag("p", "Not enough was measured to say.")]
    tiers = [mean for tier in TIER_COLOURS for mean in settings if mean.name == tier]
    over = "one scene" if len(scenes) == 1 else f"{len(scenes)} scenes"
    return [
        tag("p", f"Means over {over} on which every setting was tried. Choose by the time that you have, or by the "
            "error that you can live with: strands that are moved by a tenth, a quarter or half of a pixel have .06, "
            ".12 or .19."),
        tag("div", tag("div", budget_table(settings)), tag("div", error_table(settings)), class_="pair"),
        items([judgement(settings, tier) for tier in tiers]),
    ]


def cells_of(wish: str, choice: Optional[Mean]) -> List[str]:
    if choice is None:
        return [wish, "nothing that was measured", "", "", ""]
    return [wish, choice.name, milliseconds(choice.cost), f"{choice.flip:.4f}", f"{choice.silhouette:.4f}"]


def budget_table(settings: Sequence[Mean]) -> Element:
    dearest = max(mean.cost for mean in settings)
    rows: List[List[str]] = []
    for budget in BUDGETS:
        choice = best_within(settings, budget)
        buys_more = choice is not None and budget <= 2 * dearest and not (rows and rows[-1][1] == choice.name)
        if buys_more:
            rows.append(cells_of(milliseconds(budget), choice))
    return table(["so many ms", "choose", "ms", "error", "silhouette"], rows)


def error_table(settings: Sequence[Mean]) -> Element:
    rows = [cells_of(f"{error:.3f}", cheapest_at(settings, error)) for error in ERRORS]
    return table(["error of at most", "choose", "ms", "error", "silhouette"], rows)


def judgement(settings: Sequence[Mean], tier: Mean) -> List[Content]:
    """Describes if another setting is as cheap and better."""
    better = best_within(settings, tier.cost * NO_DEARER)
    verdict = "Nothing measured is better for its time."
    if better and better.flip <= 0.95 * tier.flip:
        verdict = f"For the same time, {better.name} has {better.flip:.4f}."
    return [tag("b", tier.name), f" takes {milliseconds(tier.cost)} ms with an error of {tier.flip:.4f} (silhouette "
            f"{tier.silhouette:.4f}). {verdict}"]


def gallery(pictures: Sequence[Shown]) -> List[Element]:
    parts: List[Element] = []
    for scene in dict.fromkeys(picture.scene for picture in pictures):
        figures = [figure(picture) for picture in pictures if picture.scene == scene]
        parts += [tag("h3", scene), tag("div", *figures, class_="pictures")]
    return parts


def figure(picture: Shown) -> Element:
    images = [image(picture.image, "jpeg", f"{picture.name}, {picture.scene}")]
    if picture.map:
        images.append(image(picture.map, "png", f"error of {picture.name}"))
    return tag("figure", *images, tag("figcaption", tag("b", picture.name), f" {picture.caption}"))


def folded(summary: str, content: Element) -> Element:
    return tag("details", tag("summary", summary), tag("div", content, class_="all"))


def tier_table(rows: Sequence[Row]) -> Element:
    head = ["tier", "scene", "error", "95 of 100 pixels under", "silhouette", "light over truth",
            "coverage over truth", "ms"]
    tiers = [row for tier in TIER_COLOURS for row in rows if (row.series, row.value) == ("tier", tier)]
    lines = [[row.value, row.scene, f"{row.flip:.4f}", f"{row.flip_95:.3f}", f"{row.silhouette:.4f}",
              f"{row.luminance:.3f}", f"{row.coverage:.3f}", milliseconds(row.cost)] for row in tiers]
    return folded("The figures of the tiers", table(head, lines))


def all_rows(rows: Sequence[Row]) -> Element:
    head = ["scene", "setting", "error", "95%", "silhouette", "ms", "CPU ms"]
    lines = [[row.scene, row.name, f"{row.flip:.4f}", f"{row.flip_95:.3f}", f"{row.silhouette:.4f}",
              milliseconds(row.draw_ms), milliseconds(row.cpu_ms) if row.cpu_ms > 0 else ""] for row in rows]
    return folded("Everything that was measured; results.csv has it with all knobs", table(head, lines))


def checks(rows: Sequence[Row]) -> Element:
    """Describes the accuracy of the truth and the number of non-finite pixels."""
    floor = max((row.floor for row in rows), default=0.0)
    noisy = sum(row.floor > MAX_NOISE * row.flip for row in rows)
    verdict = "That is little beside every error: more passes would change them by about a hundredth."
    if noisy:
        verdict = f"That is over a third of {noisy} errors: take more passes."
    broken = str(sum(row.non_finite for row in rows))
    return items([
        ["Pixels that are not finite: ", tag("b", broken), f", in {len(rows)} frames."],
        [f"Noise of the truth, which is its difference from half its passes, is at most {floor:.4f}. {verdict}"],
    ])

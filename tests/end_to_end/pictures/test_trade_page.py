"""What pelage trade makes of its rows: the table, choices, plots and the page. No server runs."""

import sys
import unittest
import xml.etree.ElementTree as ElementTree

from support.server import REPOSITORY

sys.path.insert(0, str(REPOSITORY / "clients" / "python"))
from pelage.trade import choices, plots, table  # noqa: E402
from pelage.trade.cases import settings_for  # noqa: E402
from pelage.trade.page import page  # noqa: E402
from pelage.trade.sweep import Options, Report, Shown  # noqa: E402


def row_of(scene, series, value, cost, flip, **more):
    row = table.Row(scene, 64, 256, series, value, 1.5, 2, 1.0, flip, 2 * flip, 1.5 * flip, 3 * flip, 1.0, 1.0, 0.0, 0, cost,
                    0.0, f'{{"of":"{series} {value}"}}')
    return row._replace(**more)


def some_rows():
    """Two scenes with tiers, a knob and a grid, one of tiers alone; names that HTML has to escape."""
    rows = []
    for scene in ('a <b> & "c"', "second, far"):
        rows += [row_of(scene, "tier", "draft", 10, 0.08), row_of(scene, "tier", "interactive", 40, 0.03),
                 row_of(scene, "tier", "detailed", 300, 0.012), row_of(scene, "strands", "0.4", 20, 0.06, strands=0.4),
                 row_of(scene, "strands", "3", 39, 0.02, strands=3.0), row_of(scene, "grid", "2 x 1 x 0.5", 5, 0.12)]
    return [*rows, row_of("only tiers", "tier", "draft", 10, 0.08)]


def report_of(rows, pictures=()):
    return Report("a <GL> & more", Options(False, 64, 256, 2), rows, list(pictures))


def text_of(element):
    return ElementTree.tostring(element, encoding="unicode")


class Table(unittest.TestCase):
    def test_reads_back_to_the_same_rows(self):
        rows = [row._replace(flip=1 / 3, cpu_ms=1e-17, non_finite=7, knobs='a"b,\nc') for row in some_rows()]
        self.assertEqual(table.from_csv(table.to_csv(rows)), rows)

    def test_refuses_other_columns_and_broken_lines(self):
        good = table.to_csv(some_rows())
        for text, why in (("a,b\r\n", "other columns"), ("", "other columns"), (f"{good}one,two\r\n", "Row 14"),
                          (good.replace(",64,", ",6x,", 1), "Row 1 ")):
            with self.assertRaisesRegex(ValueError, why):
                table.from_csv(text)


class Choices(unittest.TestCase):
    def means(self):
        rows = some_rows()
        return choices.means_over(rows, table.swept_scenes(rows))

    def test_the_front_keeps_what_nothing_beats_in_both(self):
        points = [(4, 0.1), (1, 0.9), (2, 0.5), (3, 0.6), (2, 0.4)]
        self.assertEqual(choices.pareto_front(points), [(1, 0.9), (2, 0.4), (4, 0.1)])
        self.assertEqual(choices.pareto_front([(1, 2), (1, 2), (1, 3)]), [(1, 2)])
        self.assertEqual(choices.pareto_front([]), [])

    def test_means_are_of_settings_that_all_scenes_have(self):
        means = self.means()
        self.assertEqual(len(means), 6)
        self.assertEqual(means[0].name, "draft")
        self.assertAlmostEqual(means[0].flip, 0.08)
        self.assertAlmostEqual(means[0].cost, 10)
        self.assertEqual(len(choices.means_over(some_rows(), table.scenes_of(some_rows()))), 1)

    def test_best_within_a_time_and_cheapest_at_an_error(self):
        means = self.means()
        self.assertEqual(choices.best_within(means, 39.5).name, "interactive with strands 3")
        self.assertEqual(choices.cheapest_at(means, 0.08).name, "draft")
        self.assertIsNone(choices.best_within(means, 1))
        self.assertIsNone(choices.cheapest_at(means, 0.001))


class Settings(unittest.TestCase):
    def test_each_is_named_once(self):
        for swept, quick, count in ((True, False, 68), (False, False, 11), (True, True, 18)):
            settings = settings_for(swept, quick)
            self.assertEqual(len({setting[:2] for setting in settings}), len(settings))
            self.assertEqual(len(settings), count)


class Page(unittest.TestCase):
    def parsed(self, report):
        text = page(report)
        ElementTree.fromstring(text.split("\n", 1)[1])  # without the doctype
        return text

    def test_is_well_formed_and_needs_nothing_else(self):
        pictures = [Shown("second, far", "truth", "traced", b"bytes"), Shown("second, far", "draft", "error", b"bytes", b"map")]
        text = self.parsed(report_of(some_rows(), pictures))
        for absent in ("http", "nan", "<b> &"):
            self.assertNotIn(absent, text)
        for present in ("a &lt;GL&gt; &amp; more</b> at 64 x 64 pixels", "data:image/jpeg;base64,Ynl0ZXM=", "data:image/png;base64,bWFw",
                        "For the same time, interactive with strands 3 has 0.0200."):
            self.assertIn(present, text)

    def test_of_nothing_is_a_page_as_well(self):
        self.assertIn("Not enough", self.parsed(report_of([])))

    def test_says_when_the_truth_is_noisy(self):
        rows = some_rows()
        self.assertIn("little beside every error", page(report_of(rows)))
        noisy = [row._replace(floor=0.02) for row in rows[:3]]  # beside errors of .08, .03 and .012
        self.assertIn("over a third of 2 errors: take more passes", page(report_of([*noisy, *rows[3:]])))


class Plots(unittest.TestCase):
    def test_axes_are_logarithmic_and_hold_their_area(self):
        axis = plots.Axis(1, 100, 10, 110)
        self.assertEqual([axis(value) for value in (1, 10, 1e9, 0)], [10, 60, 110, 10])
        self.assertEqual([round(tick, 6) for tick in axis.ticks(10)], [1, 2, 5, 10, 20, 50, 100])
        self.assertEqual(axis.ticks(30), [1, 10, 100])

    def test_they_show_the_tiers_and_the_knobs(self):
        rows = some_rows()
        scatter = text_of(plots.scatter_plot(rows, "second, far"))
        self.assertIn("draft: 10 ms, FLIP 0.0800", scatter)
        self.assertIn("What strands buys", text_of(plots.knob_plots(rows, "second, far")))
        self.assertIn("second, far: 0.4 strands a pixel, FLIP 0.0600", text_of(plots.strands_plot(rows)))
        self.assertIn("only tiers", text_of(plots.tier_plot(rows)))


if __name__ == "__main__":
    unittest.main()

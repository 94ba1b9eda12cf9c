"""Frame ranges and their chunks."""

import random
import unittest

import support  # noqa: F401
from pelage.farm.ranges import MAX_CHUNKS, chunk_from, chunks_of, frames_of, range_of, tiled_chunks_of


class Ranges(unittest.TestCase):
    def test_reading(self):
        self.assertEqual(frames_of("1-4"), [1, 2, 3, 4])
        self.assertEqual(frames_of("1-10:4"), [1, 5, 9])
        self.assertEqual(frames_of("1-10x4,20"), [1, 5, 9, 20])
        self.assertEqual(frames_of("-5--3,-1-1"), [-5, -4, -3, -1, 0, 1])
        for text in ("", "a", "1-", "1-5x0", "1--", "1,,2"):
            with self.assertRaises(ValueError, msg=text):
                frames_of(text)

    def test_writing(self):
        for frames, text in (([1], "1"), ([1, 2], "1-2"), ([1, 3], "1,3"), ([1, 3, 5, 9], "1-5x2,9"), ([-5, -4, -3], "-5--3"),
                             ([1, 2, 3, 10, 20, 30, 31], "1-3,10-30x10,31"), ([], "")):
            self.assertEqual(range_of(frames), text)

    def test_what_is_written_reads_back(self):
        rng = random.Random(1)
        for _ in range(2000):
            frames = sorted(rng.sample(range(-30, 60), rng.randint(1, 40)))
            self.assertEqual(frames_of(range_of(frames)), frames)


class Chunks(unittest.TestCase):
    def sizes(self, *arguments):
        return [len(chunk) for chunk in chunks_of(*arguments)]

    def test_a_chunk_takes_about_its_seconds(self):
        for cost, seconds in ((10, 120), (0.5, 60), (7, 100)):
            sizes = self.sizes(range(1000), cost, seconds)
            self.assertLessEqual(max(sizes) * cost, seconds)
            self.assertGreater((max(sizes) + 1) * cost, seconds * 0.8)
            self.assertLessEqual(max(sizes) - min(sizes), 1)

    def test_no_frame_is_lost_or_drawn_twice(self):
        rng = random.Random(2)
        for _ in range(500):
            frames = list(range(1, rng.randint(2, 3000)))
            chunks = chunks_of(frames, rng.uniform(0.01, 300), rng.uniform(1, 600), rng.randint(0, 50))
            self.assertEqual([frame for chunk in chunks for frame in chunk], frames)
            self.assertLessEqual(len(chunks), MAX_CHUNKS)
            self.assertNotIn([], chunks)

    def test_costly_frames_are_alone(self):
        self.assertEqual(self.sizes([1, 2, 3], 500, 120), [1, 1, 1])

    def test_all_nodes_have_work(self):
        self.assertEqual(self.sizes(range(24), 0.1, 120, 8), [3] * 8)
        self.assertEqual(self.sizes(range(3), 0.1, 120, 8), [1] * 3)
        self.assertEqual(self.sizes(range(24), 0.1, 120), [24])

    def test_tiles_are_chunks_of_their_own(self):
        chunks = tiled_chunks_of([1, 2, 3], 2, 100, 100, 1)
        self.assertEqual([(chunk.frames, chunk.tile) for chunk in chunks], [([1], 1), ([1], 2), ([2, 3], 1), ([2, 3], 2)])
        rng = random.Random(3)
        for _ in range(50):
            frames, tiles = list(range(1, rng.randint(2, 100))), rng.randint(1, 256)
            chunks = tiled_chunks_of(frames, tiles, rng.uniform(0.01, 3000), rng.uniform(1, 600), rng.randint(0, 50))
            self.assertLessEqual(len(chunks), MAX_CHUNKS)
            parts = sorted((frame, chunk.tile) for chunk in chunks for frame in chunk.frames)
            self.assertEqual(parts, [(frame, tile) for frame in frames for tile in range(1, tiles + 1)])
            self.assertEqual([chunk_from(chunk.to_text()) for chunk in chunks], chunks)
        self.assertEqual({chunk.tile for chunk in tiled_chunks_of([1, 2], 0, 1, 1, 1)}, {0})


if __name__ == "__main__":
    unittest.main()

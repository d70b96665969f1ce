#!/usr/bin/env python3
"""What scripts/own_headers.py finds in a small project: includes that are missing, and nothing else."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent.parent / "scripts"))
from own_headers import OwnHeaders  # noqa: E402

ball = """
#pragma once
#define CHECKED(x) (x)
namespace murosimf::soccer {
class Player;  // only announced
struct Ball {
  double radius() const;
};
enum class Side { left, right };
inline constexpr double most_speed = 10;
[[nodiscard]] Ball rolled(const Ball& ball, double seconds);
template <class T>
T turned(const T& what);
}
"""


class Missing(unittest.TestCase):
    def found(self, code, reached=()):
        texts = {"murosimf/soccer/ball.h": ball, "murosimf/soccer/game.cpp": code, "murosimf/soccer/said.h": "class Ball;"}
        return [message.split()[0] for _, message in OwnHeaders(texts).missing("murosimf/soccer/game.cpp", set(reached))]

    def test_names_what_is_used_without_its_header(self):
        self.assertEqual(self.found("Ball ball;"), ["Ball"])
        self.assertEqual(self.found("void f() { g(soccer::Side::left); }"), ["Side"])
        self.assertEqual(self.found("void f() { rolled({}, 1); }"), ["rolled"])
        self.assertEqual(self.found("int x = turned(1) + soccer::most_speed;"), ["turned", "most_speed"])
        self.assertEqual(self.found("int x = CHECKED(1);"), ["CHECKED"])

    def test_says_the_line(self):
        texts = {"murosimf/a.h": ball, "murosimf/b.cpp": '// Ball\nR"(Ball)";\n\nBall ball;'}
        self.assertEqual([line for line, _ in OwnHeaders(texts).missing("murosimf/b.cpp", set())], [4])

    def test_is_content_with_the_header_or_one_that_announces_it(self):
        self.assertEqual(self.found("Ball ball = rolled(Ball(), 1);", ["murosimf/soccer/ball.h"]), [])
        self.assertEqual(self.found("Ball* ball;", ["murosimf/soccer/said.h"]), [])

    def test_leaves_what_is_not_the_headers(self):
        self.assertEqual(self.found("class Ball; Ball* ball;"), [])  # announced here
        self.assertEqual(self.found("void f() { game.rolled(); game->turned(1); }"), [])  # members
        self.assertEqual(self.found("void f() { other::Ball ball; std::rolled(); ::turned(1); }"), [])  # of others
        self.assertEqual(self.found("int rolled(int); int x = rolled(1);"), [])  # its own
        self.assertEqual(self.found("TEST(Ball, IsRound) {}"), [])
        self.assertEqual(self.found('// Ball\nconst char* text = "Ball"; /* Ball */'), [])
        self.assertEqual(self.found("#include <other/Ball.hpp>\nusing namespace other;\nBall ball;"), [])
        self.assertEqual(self.found("#include <unistd.h>\nint x = rolled(1);"), [])  # the system's, perhaps
        self.assertEqual(self.found("#include <unistd.h>\nint x = soccer::rolled(1);"), ["rolled"])
        self.assertEqual(self.found("Player* player;"), [])  # no header defines it


if __name__ == "__main__":
    unittest.main()

"""Writes outlines.txt from a TrueType face: python3 outlines.py DejaVuSans.ttf > outlines.txt (needs fonttools)."""

import sys

from fontTools.pens.basePen import BasePen
from fontTools.ttLib import TTFont

RANGES = """20-7E A0 A7 B0-B3 B5 B7 B9 BC-BE C0-FF 391-3A9 3B1-3C9 3D1 3D5 2010-2015 2018-201A 201C-201E 2022 2026 2032-2034
2070 2071 2074-208E 2090-209C 2190-2193 2202 2206 2207 2212 221A 221E 2225 2248 2260 2264 2265 FFFD"""


class Pen(BasePen):
    """Collects M, L, Q and Z in units of the face."""

    def __init__(self, glyphs):
        super().__init__(glyphs)
        self.text = ""

    def _add(self, letter, *places):
        self.text += letter + " ".join(f"{round(x)} {round(y)}" for x, y in places)

    def _moveTo(self, place):
        self._add("M", place)

    def _lineTo(self, place):
        self._add("L", place)

    def _qCurveToOne(self, control, end):
        self._add("Q", control, end)

    def _closePath(self):
        self.text += "Z"


face = TTFont(sys.argv[1])
glyphs, names = face.getGlyphSet(), face.getBestCmap()
print(f"# {face['name'].getDebugName(5)} of {face['name'].getDebugName(1)}; units of an em: {face['head'].unitsPerEm}")
print("# letter, width, outline: Move, Line, Quadratic, Z; x to the right, y up")
for part in RANGES.split():
    first, last = (part.split("-") * 2)[:2]
    for code in range(int(first, 16), int(last, 16) + 1):
        if code in names:
            pen = Pen(glyphs)
            glyphs[names[code]].draw(pen)
            print(f"{code:X} {glyphs[names[code]].width} {pen.text}".rstrip())

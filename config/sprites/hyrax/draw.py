#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the sprite sheet of the hyrax: writes sheet.svg and renders it to sheet.png beside itself.

Run: python3 draw.py (needs rsvg-convert from librsvg). SHEET below lists the cells in order.
"""

import math
import pathlib
import subprocess
import typing

CELL = 128  # side of a cell [px]
COLUMNS = 6
SCALE = 0.94  # pixels per drawing unit: leaves room for whiskers and for the widest squash
CENTRE = 64  # x of the anchor, in pixels and in drawing units
GROUND = 120  # y of the soles in drawing units; in pixels, y of the lower edge of their outline
EDGE = 2.2  # visible width of the outline

OUTLINE = "#35271e"
FUR = "url(#fur)"
FUR_DARK = "#755f4b"
FUR_SHADE = "#6b5745"
FUR_LOCK = "#77624d"
FUR_STROKE = "#64503d"
CREAM = "#efe3c8"
CREAM_SHADE = "#cdb997"
GOLD = "#c7a562"
FOOT = "#4b403b"
NAIL = "#8d7f77"
BLACK = "#1d1817"
TUSK = "#fffaf0"
WHISKER = "#85715c"  # a middle tone shows on light and dark wallpaper alike

GRADIENT = ('<linearGradient id="fur" gradientUnits="userSpaceOnUse" x1="20" y1="30" x2="90" '
            'y2="125"><stop offset="0" stop-color="#b29c82"/><stop offset=".45" '
            'stop-color="#947e66"/><stop offset="1" stop-color="#7d6853"/></linearGradient>')
# Thirty-two levels of alpha: leaves no pixel that is too faint to see but still catches the mouse.
LEVELS = " ".join(f"{level / 31:.4f}" for level in range(32))
CRISP = ('<filter id="crisp" filterUnits="userSpaceOnUse" x="0" y="0" width="100%" height="100%" '
         'color-interpolation-filters="sRGB"><feComponentTransfer><feFuncA type="discrete" '
         f'tableValues="{LEVELS}"/></feComponentTransfer></filter>')

path_names = {}  # path -> id: what is outlined, filled and clipped is written only once
clip_paths = {}  # id -> element

class Shape(typing.NamedTuple):
    """A filled path; at = (x, y, angle) places it."""
    path: str
    colour: str = FUR
    at: tuple = ()

class Limb(typing.NamedTuple):
    """Shapes that share the outline of the body, and the lines drawn over them."""
    shapes: list
    lines: str

# Paths -------------------------------------------------------------------------------------------

def number(value):
    text = f"{value:.1f}"
    return "0" if text == "-0.0" else text.removesuffix(".0")

def pair(x, y):
    return f"{number(x)} {number(y)}"

def on_curve(start, first, second, end, t):
    u = 1 - t
    return [u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d
            for a, b, c, d in zip(start, first, second, end)]

def tuft(start, end, length, lean):
    """A lock of fur on the outer side of start to end: a slow rise, a quick fall."""
    along_x, along_y = end[0] - start[0], end[1] - start[1]
    size = math.hypot(along_x, along_y)
    out_x, out_y = -along_y / size * length, along_x / size * length

    def at(along, out):
        return pair(start[0] + along_x * along + out_x * out,
                    start[1] + along_y * along + out_y * out)
    return f"Q{at(lean * .4, .75)} {at(lean, 1)}Q{at((lean + 1) / 2, 0)} {at(1, 0)}"

def curve(points):
    """A closed Catmull-Rom curve, counterclockwise on screen.

    A point (x, y, count, length, lean) puts so many tufts on the stretch that starts at it.
    """
    path = f"M{pair(*points[0][:2])}"
    for i, start in enumerate(points):
        before, end, after = (points[(i + k) % len(points)] for k in (-1, 1, 2))
        first = [start[a] + (end[a] - before[a]) / 6 for a in (0, 1)]
        second = [end[a] - (after[a] - start[a]) / 6 for a in (0, 1)]
        if len(start) == 2:
            path += f"C{pair(*first)} {pair(*second)} {pair(*end[:2])}"
            continue
        count, length, lean = start[2:]
        previous = start[:2]
        for step in range(1, int(count) + 1):
            following = on_curve(start[:2], first, second, end[:2], step / count)
            uneven = (1.0, 0.65, 1.2, 0.8)[(i + step) % 4]
            path += tuft(previous, following, length * uneven, lean)
            previous = following
    return path + "Z"

def smooth(text, raised=0, above=CELL):
    """curve() through "x y, x y count length lean, ..."; raises the points above a height."""
    points = [[float(field) for field in point.split()] for point in text.split(",")]
    return curve([(x, y - raised * (y < above), *fur) for x, y, *fur in points])

def ellipse(x, y, rx, ry):
    half = f"a{pair(rx, ry)} 0 1 0 "
    return f"M{pair(x - rx, y)}{half}{pair(2 * rx, 0)}{half}{pair(-2 * rx, 0)}Z"

# SVG elements ------------------------------------------------------------------------------------

def shared(path, attributes=""):
    name = path_names.setdefault(path, f"p{len(path_names)}")
    return f'<use href="#{name}"{attributes}/>'

def fill(path, colour):
    return shared(path, f' fill="{colour}"')

def line(path, colour=OUTLINE, width=1.6):
    return (f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}" '
            'stroke-linecap="round" stroke-linejoin="round"/>')

def group(content, x=0, y=0, angle=0, sx=1, sy=1):
    return (f'<g transform="translate({x:g} {y:g})rotate({angle:g})scale({sx:g} {sy:g})">'
            f'{content}</g>')

def placed(content, at):
    return group(content, *at) if at else content

def painted(shapes):
    return "".join(placed(fill(shape.path, shape.colour), shape.at) for shape in shapes)

def outlined(shapes):
    """The shapes in one common outline, so that they read as one body."""
    edges = "".join(placed(shared(shape.path), shape.at) for shape in shapes)
    return (f'<g fill="{OUTLINE}" stroke="{OUTLINE}" stroke-width="{2 * EDGE}" '
            f'stroke-linejoin="round">{edges}</g>{painted(shapes)}')

def clipped(path, content):
    use = shared(path)
    name = "c" + path_names[path]
    clip_paths[name] = f'<clipPath id="{name}">{use}</clipPath>'
    return f'<g clip-path="url(#{name})">{content}</g>'

# Head: coordinates around its centre, the nose on the right ---------------------------------------

HEAD = smooth("9 -23.5, -7 -24.5 3 1.6 .8, -20 -17, -27 -2 2 2 .9, -25 12, -14 22, 2 25, 14 23.4,"
              "25 19.5, 35 13, 39.6 5, 36 -2, 27 -9, 20 -18.5")

def ear(angle):
    """Open towards the face, so that it grows out of the fur instead of sitting on it."""
    rim = "M5 -5.4Q.5 -8.8 -4.4 -7Q-9.4 -4 -8.2 2.4Q-6.4 7.4 -.6 7.6"
    hollow = "M3 -3.4Q-1.6 -6 -4.8 -2.8Q-6.2 2 -2.4 4.8Q-1.6 0 3 -3.4Z"
    hair = line("M2.8 -2.6Q-.6 .4 -1 4.4M4.6 -.6Q2 1.6 1.6 4.6", CREAM, 1.3)
    return group(fill(rim, "#ab947a") + fill(hollow, "#4a372d") + line(rim, OUTLINE, 2) + hair,
                 -20, -6, angle)

def eye(x, y, width, lid, look):
    """A bead eye; lid 0 is open, 1 closed."""
    height = 5.4
    if lid > .85:
        return line(f"M{pair(x - width - .4, y + .6)}Q{pair(x, y + 5)} "
                    f"{pair(x + width + .4, y + .6)}", BLACK, 2)
    top = y - height + 2 * height * lid
    ball = ellipse(x, y, width, height)
    gleam = ellipse(x - width * .3 + look[0], y - 1.9 + look[1], width * .38, 1.9)
    glow = ellipse(x + width * .3 + look[0] / 2, y + 2.5 + look[1] / 2, width * .24, 1)
    skin = f"M{pair(x - 8, y - 8)}h16V{number(top)}Q{pair(x, top - 1.2)} {pair(x - 8, top)}Z"
    cover = fill(skin, FUR_DARK) if lid else ""
    rim = line(f"M{pair(x - width - .5, top + 2.6)}Q{pair(x, top - 2)} "
               f"{pair(x + width + .3, top + 2.6)}", BLACK)
    inside = fill(gleam, "#fff") + fill(glow, "#b0957b") + cover
    return fill(ball, BLACK) + clipped(ball, inside) + rim

def brows(turn, lift, tilt):
    """Dark strokes on pale spots; tilt > 0 lifts the inner ends: worried, < 0: cross."""
    spot = fill(smooth("6.4 -3.6, 0 -5, -6.8 -2, -7.2 2.4, 0 4.4, 7 3"), CREAM)
    stroke = line("M-4.4 .7Q.2 -2 4.6 -.9", OUTLINE, 2.2)
    places = ((2.5 + turn, -13.8 - lift, -tilt, 1), (22 + turn * .6, -14 - lift, tilt, -.62))
    return clipped(HEAD, "".join(group(spot, *place) for place in places)) + \
        "".join(group(stroke, *place) for place in places)

def mouth(kind):
    """The split upper lip under the nose, with the tip of a tusk."""
    split = "M34.6 5.8Q34.2 9 32.4 11"
    if kind == "open":
        gape = smooth("32 11, 26 12.6, 22 15, 25 19, 31 17.4")
        return fill(gape, "#5a2b2a") + line(gape + split + "Q34 13 36.4 12.4", OUTLINE, 1.5) + \
            fill("M27.6 12.6L29 16.2L30.6 12Z", TUSK)
    corner = {"calm": "Q27 16.4 17.5 13Q16 12.2 15.6 10.6", "cross": "Q26 12 19 15.6"}[kind]
    return line(f"{split}{corner}M32.4 11.2Q34 13 36.6 12.4", OUTLINE, 1.5) + \
        fill("M27.6 14.3L28.7 17.2L30.7 12.9Z", TUSK)

def head(lid=0, look=(0, 0), tilt=16, lift=0, ears=0, blow=0, turn=0, lips="calm"):
    """The face; turn < 0 moves its features towards the viewer, blow lifts the whiskers."""
    shade = smooth("-30 8, -20 12, -8 17, 4 18, 16 19, 38 16, 30 34, -20 34")
    crown = smooth("14 -30, -6 -30, -22 -17 2 2 .5, -8 -19, 6 -19.5, 12 -16, 13.5 -8, 19 -1,"
                   "28 1.5, 35 0, 34 -12")
    muzzle = smooth("39 9, 29 6.5, 21 7, 14 12 2 1.5 .2, 16 20, 24 21, 39 19")
    face = clipped(HEAD, fill(shade, FUR_SHADE) + fill(crown, FUR_DARK) + fill(muzzle, CREAM_SHADE))
    jaw = line("M-26 9Q-22.5 18.6 -13 22.3Q-4 25 3 25.2", "#4d3b2d", 1.4)
    cheek = line("M-18 4Q-20 8 -19 11M-13 10Q-15 14 -13.5 17M-9 4Q-11 8 -10 11M-4 12Q-6 15 -4.5 17",
                 FUR_STROKE, 1.2)
    eyes = eye(5 + turn, -3, 5, lid, look) + eye(22.5 + turn * .6, -5, 3.3, lid, look)
    nose = fill(smooth("38.6 -.8, 33.8 -2.4, 29.8 -.4, 31.2 3.6, 35 6.2, 39.6 4"), BLACK) + \
        line("M33.2 0Q34.8 -1 36.4 -.4", "#83756f", 1.2)
    whiskers = line(f"M22 9.5Q12 10 4 {number(14 - blow)}M23 12Q15 16 9 {number(22 - blow)}"
                    f"M25 15Q20 21 15 {number(29 - blow)}", OUTLINE, .7)
    roots = "".join(fill(ellipse(*at, .7, .7), OUTLINE) for at in ((24.5, 9), (28, 10), (24, 12.2)))
    return (face + jaw + cheek + brows(turn, lift, tilt) + eyes + nose + mouth(lips) + roots +
            whiskers + ear(ears))

def far_whiskers(blow=0):
    """What the head leaves visible of the whiskers behind it."""
    return line(f"M30 10Q38 10 43 {number(7 - blow)}M30 12Q38 15 42.5 {number(16 - blow)}"
                f"M10 -16Q13 -23 18 {number(-29 - blow / 3)}"
                f"M22 -14Q26 -20 31 {number(-23 - blow / 3)}", WHISKER, 1)

# Body --------------------------------------------------------------------------------------------

def paw(x, y=GROUND, angle=0, toes=4, width=19):
    """A blunt rubbery foot with hoof-like nails; (x, y) is the middle of its sole."""
    path = curve([(width * .3, -9), (-width * .3, -9), (-width * .5, -5), (-width * .46, -.9),
                  (0, -.3), (width * .45, -.7), (width * .53, -4.6)])
    toe_ends = [width * (.43 - k * .23) for k in range(toes)]
    seams = "".join(f"M{pair(end, -.8)}q-1 -2.4 -.4 -4.6" for end in toe_ends[1:])
    nails = "".join(f"M{pair(end - 1.4, -1.6)}h-1" for end in toe_ends)
    at = (x, y, angle)
    return Limb([Shape(path, FOOT, at)],
                placed(line(seams, OUTLINE, 1.1) + line(nails, NAIL, 1.3), at))

def limb(hip, sole, angle=0, width=16, toes=4, colour=FUR):
    """A short leg from hip to the paw at sole; angle turns the paw."""
    turn = math.radians(angle)
    ankle = (sole[0] + 6 * math.sin(turn) - 1, sole[1] - 6 * math.cos(turn))
    along = (ankle[0] - hip[0], ankle[1] - hip[1])
    size = math.hypot(*along)

    def at(forward, side):
        return (hip[0] + along[0] * forward - along[1] / size * side * width,
                hip[1] + along[1] * forward + along[0] / size * side * width)
    path = curve([at(0, .52), at(.5, .48), at(1, .42), at(1.1, 0), at(1, -.42), at(.5, -.48),
                  at(0, -.52), at(-.3, 0)])
    end = paw(*sole, angle, toes)
    sides = "".join(f"M{pair(*at(.35, s * .5))}L{pair(*at(.9, s * .44))}" for s in (1, -1))
    return Limb([Shape(path, colour), *end.shapes], line(sides) + painted(end.shapes) + end.lines)

def folded(x, width, thigh):
    """A hind leg under the body: the foot and the line of the thigh."""
    foot = paw(x, toes=3, width=width)
    return Limb(foot.shapes, foot.lines + line(thigh, OUTLINE, 1.7))

def fur(*locks):
    """Locks (x, y, dx, dy) on the coat, in pairs: broad at the root, ending in a point."""
    path = ""
    for x, y, dx, dy in locks:
        for aside, size in ((0, 1.5), (.6, 1)):
            tip_x, tip_y = dx * size, dy * size
            path += (f"M{pair(x + dy * aside, y - dx * aside)}q{pair(tip_x * .7, tip_y * .3)} "
                     f"{pair(tip_x, tip_y)}q{pair(-tip_x * .3, -tip_y * .7)} "
                     f"{pair(dy * .28 - tip_x, -dx * .28 - tip_y)}Z")
    return fill(path, FUR_LOCK)

def dorsal_spot(x, y, angle):
    """The gland on the back: yellow hair that points to the rump, in a darker patch."""
    patch = smooth("9 -1, 0 -4.2, -9 -3.6 3 2.2 .6, -9 3.2, 0 3.8")
    hair = smooth("6 0, 0 -2.4, -5 -2 3 3 .5, -4.6 2.2, 0 2.4")
    return group(fill(patch, FUR_SHADE) + fill(hair, GOLD), x, y, angle)

def animal(body, head_at, near, far, shade, belly, marks, face):
    """One pose, from the far limbs to the head."""
    picture = outlined([s for leg in far for s in leg.shapes]) + "".join(leg.lines for leg in far)
    picture += placed(far_whiskers(face.get("blow", 0)), head_at)
    picture += outlined([Shape(body), *(s for leg in near for s in leg.shapes),
                         Shape(HEAD, FUR, head_at)])
    picture += clipped(body, fill(shade, FUR_SHADE) + fill(belly, CREAM)) + marks
    picture += "".join(painted(leg.shapes) + leg.lines for leg in near)
    return picture + placed(fill(HEAD, FUR) + head(**face), head_at)

# Poses -------------------------------------------------------------------------------------------

def sit(nod=0, **face):
    body = smooth("70 36, 52 36 3 1.8 .9, 32 45 3 2.2 .9, 16 64 3 2.2 .9, 9.5 90 2 2 .9, 14 111,"
                  "30 119, 58 119, 80 115, 98 100 3 2.2 .2, 103 80, 92 55")
    shade = smooth("96 60, 88 74, 74 71, 60 64, 60 76, 68 86, 70 100, 64 113, 40 113, 22 108, 4 92,"
                   "0 130, 120 130")
    belly = smooth("97 62, 91 74, 86 88, 76 98, 68 108, 60 125, 110 125, 112 70")
    near = [folded(48, 27, "M27 89Q36 80 48 84Q61 91 59 105Q58 110 54 112"),
            limb((82, 88), (86, GROUND), width=18)]
    far = [limb((95, 92), (98, GROUND - 2), colour=FUR_SHADE)]
    marks = dorsal_spot(39, 53, -33) + fur((30, 66, -4, 6), (22, 80, -2, 6), (42, 70, -4, 5),
                                           (28, 100, -1, 5), (46, 94, 0, 6), (17, 96, 0, 6))
    return animal(body, (81, 52, nod), near, far, shade, belly, marks, face)

def step(phase, reach=8):
    """Offset (x, height) of a sole: three fifths of the cycle on the ground."""
    phase %= 1
    if phase < .6:
        return reach * (1 - 2 * phase / .6), 0
    swing = (phase - .6) / .4
    return reach * (2 * swing - 1), 5 * math.sin(math.pi * swing)

def walk(phase):
    bob = 1.2 * math.cos(4 * math.pi * phase)

    def leg(x, offset, colour=FUR, depth=0):
        forward, height = step(phase + offset)
        sole = (x + forward, GROUND - height - depth)
        return limb((x, 92 + bob), sole, -height * 3, 17, 4, colour)
    body = smooth("72 44, 52 40 3 1.8 .9, 30 45 3 2.2 .9, 14 60 3 2.2 .9, 9 80, 15 96, 30 105,"
                  "50 107 3 1.8 .2, 74 106, 96 98 2 2 .2, 102 82, 92 60", -bob)
    shade = smooth("96 66, 86 84, 70 84, 62 72, 60 86, 60 96, 40 97, 22 94, 4 78, 0 130, 120 130")
    belly = smooth("100 74, 88 86, 74 96, 52 101, 36 105, 36 125, 110 125, 112 80")
    near = [leg(30, 0), leg(80, .25)]
    far = [leg(44, .5, FUR_SHADE, 1), leg(93, .75, FUR_SHADE, 1)]
    marks = dorsal_spot(42, 54, -12) + fur((26, 62, -5, 5), (20, 78, -3, 6), (36, 76, -5, 4),
                                           (50, 82, -5, 4), (32, 90, -4, 4))
    return animal(body, (81, 58 + bob * .6, 3), near, far, shade, belly, marks, {})

def fall(kick, **face):
    body = smooth("74 35, 54 31 3 3 .6, 33 37 3 4 .5, 17 53 3 3.4 .2, 12 74, 22 92, 42 99 2 1.6 .3,"
                  "62 100, 82 96, 97 85, 101 67, 92 47")
    shade = smooth("96 57, 86 75, 70 75, 62 63, 60 77, 58 87, 40 90, 24 87, 6 73, 0 130, 120 130")
    belly = smooth("100 65, 88 77, 74 89, 52 94, 36 98, 36 125, 110 125, 112 80")
    near = [limb((29, 83), (9 - kick, 100 + 2 * kick), 74 + 6 * kick, 19, 3),
            limb((78, 87), (95 + 2 * kick, 106 - 1.5 * kick), -42 - 6 * kick, 18)]
    far = [limb((44, 91), (34 - kick, 110.5 - kick), 56 - 5 * kick, 18, 3, FUR_SHADE),
           limb((94, 79), (115 + kick, 89 - 2 * kick), -58 - 6 * kick, 16, 4, FUR_SHADE)]
    marks = dorsal_spot(42, 45, -14) + fur((26, 57, -4, -4), (22, 71, -5, -3), (38, 67, -4, -4),
                                           (54, 75, -4, -4), (46, 85, -4, -3))
    return animal(body, (81, 52, 4), near, far, shade, belly, marks, face)

def held(swing, **face):
    body = smooth("63 21, 57 17.5, 50 19, 45 28, 34 41 3 2 .9, 20 62 3 2.2 .9, 14 86 2 2 .9,"
                  "20 104, 40 113, 64 111, 82 98 2 2 .2, 90 76, 86 48, 70 24")
    shade = smooth("94 54, 82 66, 66 72, 56 62, 54 78, 58 92, 50 104, 34 107, 20 98, 10 80, 4 122,"
                   "100 120")
    belly = smooth("94 58, 86 74, 76 84, 68 98, 62 118, 100 116, 104 70")
    near = [limb((38, 98), (44 - swing, 119), 50 - 4 * swing, 20, 3),
            limb((73, 78), (79 - swing, 99), 60 - 4 * swing, 16)]
    far = [limb((62, 100), (67 - swing, 118), 46 - 4 * swing, 18, 3, FUR_SHADE),
           limb((88, 78), (98 - swing, 93), 48 - 4 * swing, 15, 4, FUR_SHADE)]
    folds = line("M52 22Q51 28 47 33M56 21.5Q57 28 55 34M60 23Q63 26 63 30", FUR_STROKE, 1.4)
    marks = folds + dorsal_spot(31, 62, -60) + fur((40, 50, -4, 6), (26, 80, -2, 6),
                                                   (42, 70, -3, 6), (30, 94, 0, 6), (50, 88, -1, 6))
    picture = animal(body, (81, 48, -4), near, far, shade, belly, marks, face)
    return group(group(picture, -55, -18), 55, 13, swing * 2.5)

def rest(breath, **face):
    body = smooth("72 72, 54 64 3 1.8 .9, 33 67 3 2.2 .9, 16 82 3 2.2 .9, 8.5 103, 15 116,"
                  "34 119.5, 60 119.5, 86 119, 102 112, 98 90", breath, 90)
    shade = smooth("96 86, 70 92, 60 86, 57 100, 62 111, 40 113, 22 111, 4 98, 0 130, 120 130")
    near = [folded(38, 24, "M22 104Q30 95 42 99Q51 104 48 112")]
    marks = dorsal_spot(42, 79 - breath, -14) + fur((28, 88 - breath, -4, 5), (18, 100, -2, 5),
                                                    (42, 90, -5, 4), (56, 84 - breath, -5, 4))
    return animal(body, (82, 91 - breath * .35, 4), near, [paw(104)], shade, "M0 0", marks, face)

def squash(picture, across, up):
    """Scales about the point between the feet."""
    return group(picture, CENTRE * (1 - across), (GROUND + EDGE) * (1 - up), 0, across, up)

SHEET = [
    # idle: calm, half a blink, a blink, turning, turned, a twitch of the ear
    sit(), sit(lid=.5), sit(lid=1), sit(nod=-4, turn=-3.5, look=(-.5, -.4), lift=.6),
    sit(nod=-8, turn=-7, look=(-.8, -.8), lift=1.2, tilt=22), sit(ears=-24, lift=.4),
    *(walk(k / 6) for k in range(6)),
    *(fall(k, tilt=24, lift=1.5, ears=30 + 8 * k, blow=9 + 2 * k, lips="open")
      for k in (-1.4, 0, 1.4)),
    *(held(k, tilt=-20, lid=.2, ears=-10 + 4 * k, lips="cross") for k in (-1, 0, 1)),
    # land: impact, recovery, overshoot
    squash(sit(lid=1, tilt=20, ears=-30), 1.06, .78),
    squash(sit(lid=.5, tilt=20, ears=-16), 1.03, .92), squash(sit(lift=1, ears=8), .98, 1.03),
    *(rest(k, lid=1, tilt=12, ears=-18) for k in (0, 1, 2)),
]

# Output ------------------------------------------------------------------------------------------

def sheet_svg():
    left, top = CENTRE * (1 - SCALE), GROUND - (GROUND + EDGE) * SCALE
    cells = "\n".join(group(picture, i % COLUMNS * CELL + left, i // COLUMNS * CELL + top, 0, SCALE,
                            SCALE) for i, picture in enumerate(SHEET))
    paths = "\n".join(f'<path id="{name}" d="{path}"/>' for path, name in path_names.items())
    clips = "\n".join(clip_paths.values())
    size = f'width="{COLUMNS * CELL}" height="{-(-len(SHEET) // COLUMNS) * CELL}"'
    return (f'<svg xmlns="http://www.w3.org/2000/svg" {size}>\n<defs>\n{GRADIENT}\n{CRISP}\n'
            f'{paths}\n{clips}\n</defs>\n<g filter="url(#crisp)">\n{cells}\n</g>\n</svg>\n')

def main():
    sheet = pathlib.Path(__file__).resolve().with_name("sheet.svg")
    sheet.write_text(sheet_svg(), encoding="utf-8", newline="\n")
    subprocess.run(["rsvg-convert", "-o", sheet.with_suffix(".png"), sheet], check=True)

if __name__ == "__main__":
    main()

"""A small packer of boxes side by side and one on another, with a mistake in it.

It keeps a skyline and lays each box where it comes to lie lowest. A box is accepted where its centre is above what carries it:
true for that box alone, and not enough, for it may tip the box below with it. pack_safely asks the library instead.
"""
import stonepack

WIDTH = 1200                                            # of the pallet [mm]; boxes are (width, height)


class Skyline:
    """Placed boxes (left, bottom, width, height) [mm]."""

    def __init__(self):
        self.placed = []

    def rest(self, left, width):
        """(bottom, what carries there: from, to) of a box laid down at `left`."""
        under = [(0, 0, WIDTH)] + [(b + h, x, x + w) for x, b, w, h in self.placed if x < left + width and left < x + w]
        bottom = max(top for top, _, _ in under)
        carrying = [(max(x0, left), min(x1, left + width)) for top, x0, x1 in under if top == bottom]
        return bottom, min(x0 for x0, _ in carrying), max(x1 for _, x1 in carrying)

    def places(self, width):
        """Flush with the pallet, or with an edge of a box that lies."""
        edges = [0, WIDTH] + [e for x, _, w, _ in self.placed for e in (x, x + w)]
        return sorted({e for e in edges if e + width <= WIDTH} | {e - width for e in edges if 0 <= e - width})


def pack(boxes, is_good=None):
    """Boxes as (left, bottom, width, height), in their order; those that find no place are left out."""
    sky = Skyline()
    for width, height in boxes:
        for bottom, left, x0, x1 in sorted((sky.rest(x, width)[0], x) + sky.rest(x, width)[1:] for x in sky.places(width)):
            box = (left, bottom, width, height)
            if is_good(sky.placed + [box]) if is_good else x0 <= left + width / 2 <= x1:         # the mistake: this box alone
                sky.placed.append(box)
                break
    return sky.placed


def scene_of(placed):
    scene = stonepack.Scene(mu=0.5)
    scene.box((WIDTH / 1000, 0.4, 0.1), (WIDTH / 2000, 0, -0.05), name="pallet", fixed=True)
    for k, (left, bottom, width, height) in enumerate(placed):
        scene.box((width / 1000, 0.4, height / 1000), ((left + width / 2) / 1000, 0, (bottom + height / 2) / 1000),
                  name="box%d" % (k + 1))
    return scene


def pack_safely(boxes):
    return pack(boxes, lambda placed: scene_of(placed).check(localise=False).stable)

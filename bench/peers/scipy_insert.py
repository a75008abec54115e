#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scipy.interpolate.insert, a knot a call, on the case that internode_bench --case wrote.

usage: scipy_insert.py FOLDER      prints processor seconds and the largest difference relative to the largest coordinate
"""
import pathlib
import sys
import time

import numpy
from scipy.interpolate import insert

folder = pathlib.Path(sys.argv[1])
coarse, inserted = (numpy.fromfile(folder / f"{name}.f64") for name in ("coarse", "inserted"))
points, fine = (numpy.fromfile(folder / f"{name}.f64").reshape(-1, 3) for name in ("points", "fine"))
padding = numpy.zeros(4)
curve = (coarse, [numpy.append(column, padding) for column in points.T], 3)
start = time.process_time()
for knot in inserted:
    curve = insert(knot, curve)
seconds = time.process_time() - start
result = numpy.stack([column[: len(fine)] for column in curve[1]], axis=1)
print(seconds, numpy.abs(result - fine).max() / numpy.abs(fine).max())

; grbl: a quarter circle: 56 chords keep 0.001 mm (90 degrees over 1.6206 degrees)
G21 G90
G0 X0 Y0 Z0
G1 X0 Y10 F500
G3 X-10 Y0 R10
M30

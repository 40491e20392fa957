(a no-break space stands between X and its number)
G21 G90 G0 X0 Y0 Z5
G1 X 5 F100
M30

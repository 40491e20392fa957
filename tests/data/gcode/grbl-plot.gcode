; grbl: lower case, no end of the program
g21
g90
g0 z3
g0 x0 y0
g1 z-0.5 f60
g1 x10 f600
g1 y10
g0 z3
m5

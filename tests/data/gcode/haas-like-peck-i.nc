%
O01012
(Haas: I and J shrink the pecks of G83, which no other control does)
G21 G90 G00 X0. Y0. Z5. S900 M03
G83 Z-20. R2. I5. J1. K1. F80.
M30
%

// Two squares of 2 x 2 cells side by side; the right one is clockwise. Groups of all kinds.
Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {4, 0, 0};
Point(4) = {4, 2, 0}; Point(5) = {2, 2, 0}; Point(6) = {0, 2, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {7, -4, -3, -2}; Plane Surface(2) = {2};
Transfinite Curve {1 : 7} = 3;
Transfinite Surface {1, 2};
Recombine Surface {1, 2};
Physical Surface("soft", 1) = {1};
Physical Surface("hard one", 2) = {2};
Physical Curve("bottom", 3) = {1, 2};
Physical Curve("seam", 4) = {7};
Physical Curve("nowhere", 5) = {};
Physical Curve(9) = {4, 5};
Physical Point("corner", 6) = {4};

// A quarter of a disk, without groups: gmsh then writes everything, the centre of the arc too.
Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {0, 2, 0}; Point(4) = {1, 0, 0}; Point(5) = {0, 1, 0};
Circle(1) = {2, 1, 3}; Line(2) = {3, 5}; Circle(3) = {5, 1, 4}; Line(4) = {4, 2};
Curve Loop(1) = {1 : 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 4; Transfinite Curve {2, 4} = 3;
Transfinite Surface {1};
Recombine Surface {1};

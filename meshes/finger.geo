// The finger of a soft gripper, 60 mm long, as finger.step has it: gmsh -0 finger.geo -o finger.step
// It tapers from its root to its tip, has a slot that makes it bend, and a flat side x = 0 that grips.
SetFactory("OpenCASCADE");
Point(1) = {0, -8, 0};
Point(2) = {16, -8, 0};
Point(3) = {16, 8, 0};
Point(4) = {0, 8, 0};
Point(5) = {0, -6, 60};
Point(6) = {7, -6, 60};
Point(7) = {7, 6, 60};
Point(8) = {0, 6, 60};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 5};
Curve Loop(1) = {1 : 4};
Curve Loop(2) = {5 : 8};
Ruled ThruSections(1) = {1, 2};
Box(2) = {5, -10, 12, 4, 20, 24};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

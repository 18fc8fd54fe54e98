// A pillar with a widened foot, in plane strain: quadrilaterals only. Lengths in nm.
//     gmsh -2 pillar.geo -format msh41 -o pillar.msh
foot = 15;   // half width of the foot
stem = 8;    // half width of the stem
rim = 2;     // height of the foot's rim
bend = 7;    // radius of the fillet between foot and stem
height = 40;

Point(1) = {-foot, 0, 0};
Point(2) = {foot, 0, 0};
Point(3) = {foot, rim, 0};
Point(4) = {foot, rim + bend, 0};  // centre of the right fillet
Point(5) = {stem, rim + bend, 0};
Point(6) = {stem, height, 0};
Point(7) = {-stem, height, 0};
Point(8) = {-stem, rim + bend, 0};
Point(9) = {-foot, rim + bend, 0};  // centre of the left fillet
Point(10) = {-foot, rim, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 4, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Circle(7) = {8, 9, 10};
Line(8) = {10, 1};
Curve Loop(1) = {1 : 8};
Plane Surface(1) = {1};

// The names that the scene uses.
Physical Surface("pillar") = {1};
Physical Curve("foot") = {1};
Physical Curve("head") = {5};
Physical Point("rim") = {2};

// Small cells at the foot, larger ones above.
MeshSize {1, 2, 3, 10} = 2;
MeshSize {5, 8} = 4;
MeshSize {6, 7} = 8;

// Quadrilaterals only: triangles are recombined, and the rest is divided.
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.SubdivisionAlgorithm = 1;

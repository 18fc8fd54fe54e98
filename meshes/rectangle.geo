// A rectangle of triangles with the names of a Box: its cells are fine along a part of the bottom.
DefineConstant[
  left = 0, bottom = 0,        // its lower left corner
  length = 1, height = 1,
  from = 0, to = 1,            // the part of the bottom, within it
  fine = 0.1,                  // size of the cells there
  coarse = 0.3,                // size of the largest cells
  growth = 0.5                 // change of the size over the distance from the part
];

Point(1) = {left, bottom, 0};
Point(2) = {left + length, bottom, 0};
Point(3) = {left + length, bottom + height, 0};
Point(4) = {left, bottom + height, 0};
first = 1;
last = 2;
below[] = {};
If (from > left)
  first = 5;
  Point(first) = {from, bottom, 0};
  Line(1) = {1, first};
  below[] += 1;
EndIf
If (to < left + length)
  last = 6;
  Point(last) = {to, bottom, 0};
EndIf
Line(2) = {first, last};
below[] += 2;
If (to < left + length)
  Line(3) = {last, 2};
  below[] += 3;
EndIf
Line(4) = {2, 3};
Line(5) = {3, 4};
Line(6) = {4, 1};
Curve Loop(1) = {below[], 4 : 6};
Plane Surface(1) = {1};

Field[1] = Distance;
Field[1].CurvesList = {2};
Field[1].NumPointsPerCurve = 1000;
Field[2] = MathEval;
Field[2].F = Sprintf("Min(%g, %g + %g*F1)", coarse, fine, growth);
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

Physical Surface("body") = {1};
Physical Curve("bottom") = {below[]};
Physical Curve("right") = {4};
Physical Curve("top") = {5};
Physical Curve("left") = {6};

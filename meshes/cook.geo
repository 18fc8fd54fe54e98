// Cook's membrane: a panel that tapers, clamped at its left and sheared upwards at its right. Lengths in mm.
DefineConstant[
  divisions = 8,   // of each side, if structured
  structured = 1,  // 0: cells of the size that the scene asks for
  triangles = 0    // 1: triangles in place of quadrilaterals
];

Point(1) = {0, 0, 0};
Point(2) = {48, 44, 0};
Point(3) = {48, 60, 0};
Point(4) = {0, 44, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};

Physical Surface("panel") = {1};
Physical Curve("clamped") = {4};
Physical Curve("sheared") = {2};

If (structured)
  Transfinite Curve {1 : 4} = divisions + 1;
  Transfinite Surface {1};
EndIf
If (!triangles)
  Recombine Surface {1};
EndIf

// A quarter of a cylinder (R = 20) and a quarter of a block, meshed apart: their nodes do not match.
// gmsh -2 -format msh41 cylinder-between-blocks.geo
R = 20; B = 60; fine = 0.12; coarse = 5;
Mesh.RecombineAll = 1;
Mesh.Algorithm = 8;
Mesh.SubdivisionAlgorithm = 1;
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.HighOrderOptimize = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

Point(1) = {0, 0, 0};
Point(2) = {R, R, 0};
Point(3) = {0, R, 0};
Circle(1) = {1, 3, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};

Point(11) = {0, 0, 0};
Point(12) = {0, -B, 0};
Point(13) = {B, -B, 0};
Point(14) = {B, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(2) = {2};

Field[1] = MathEval;
Field[1].F = Sprintf("min(%g, %g + 0.28*max(0, sqrt(x*x+y*y)-1.6))", coarse, 2*fine);
Field[2] = MathEval;
Field[2].F = Sprintf("min(%g, %g + 0.28*max(0, sqrt(x*x+y*y)-1.6))", 3*coarse, 2.7*fine);
Field[3] = Restrict;
Field[3].InField = 1;
Field[3].SurfacesList = {1};
Field[4] = Restrict;
Field[4].InField = 2;
Field[4].SurfacesList = {2};
Field[5] = Min;
Field[5].FieldsList = {3, 4};
Background Field = 5;

Physical Surface("cylinder") = {1};
Physical Surface("block") = {2};
Physical Curve("surface") = {1};
Physical Curve("middle") = {2};
Physical Curve("axis") = {3};
Physical Curve("left") = {11};
Physical Curve("bottom") = {12};
Physical Curve("right") = {13};
Physical Curve("top") = {14};

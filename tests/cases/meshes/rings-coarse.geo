// The rings of rings.geo, of fewer cells of 4 nodes.
// gmsh -2 -format msh41 rings-coarse.geo
Include "rings.geo";
Mesh.ElementOrder = 1;
Transfinite Curve {12, 14} = 10;
Transfinite Curve {11, 13} = 4;
Transfinite Curve {22, 24} = 8;
Transfinite Curve {21, 23} = 5;

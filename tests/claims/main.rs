//! One module per link of the chain; every test name is a claim.

mod cells;
mod facing;
mod iterate;
mod problem;
mod spacing;
mod workbench;

mod accuracy;
mod accuracy_across;
mod algorithm;
#[path = "../architecture.rs"]
mod architecture;
mod atlas;
mod both_sides;
mod condensation;
mod contact;
mod converged;
mod cross_code;
mod cures;
mod digitised;
mod elasticity;
mod errors;
mod fast_paths;
mod formulation;
mod gmsh;
mod incompressible;
mod limits;
mod measure;
mod mesh;
mod oracles;
mod outputs;
mod pictures;
mod reactions;
mod scene;
mod scene_file;
mod scene_fuzz;
mod scene_gap;
mod scene_lists;
mod scene_mistakes;
mod scene_table;
mod scene_unsupported;
mod several_contacts;
mod shared_mesh;
mod soft_springs;
mod stability;
mod timings;

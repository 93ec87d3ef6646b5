//! Reads whatever bytes as a Gmsh mesh.
#![no_main]

#[path = "../read.rs"]
mod read;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::tell(read::mesh(bytes)));

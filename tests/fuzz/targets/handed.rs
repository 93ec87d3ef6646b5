//! Reads and judges whatever bytes as the answer that another code hands in.
#![no_main]

#[path = "../read.rs"]
mod read;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::tell(read::handed(bytes)));

//! The other codes, asked now through Python instead of read from `oracles/frozen`.
//!
//! A crate of its own, so that the suite is compiled without Python, and once. `cargo test --workspace` asks the codes,
//! and `cargo run --release -p contact-vv-live` freezes what they answer; `oracles/setup.sh` installs what both need.
//!
//! * [`interpreter`] — one Python on one thread.
//! * [`asked`] — what is handed over to a code, and what it answers.
//! * [`newest`] — today's dolfinx, in a process of its own.
//! * [`mod@freeze`] — asks every code for everything, and writes `oracles/frozen`.

pub mod asked;
pub mod freeze;
pub mod interpreter;
pub mod newest;

use contact_vv::oracle::cross_code::live::Live;

/// The codes that `oracles/setup.sh` installs.
pub const LIVE: Live = Live { discrete: asked::discrete, independent: asked::independent, versions: asked::versions };

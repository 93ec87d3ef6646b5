//! One module per link of the chain; every test name is a claim.

mod digitised;
mod oracles;

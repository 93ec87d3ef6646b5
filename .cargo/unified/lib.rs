//! Nothing: this package asks for features of others, as its Cargo.toml says.

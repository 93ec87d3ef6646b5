//! Values of an option that are the members of an enum, with the first lines of their documentation as help.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// The parser of such an option, from all members with their names; other words are refused by clap, which names the members.
pub fn choice<T: Copy + Send + Sync>(
    told: &'static [(T, &'static str, &'static str)],
) -> impl TypedValueParser<Value = T> {
    let value = |(_, name, help): &(T, &'static str, &'static str)| {
        PossibleValue::new(*name).help(help.trim().trim_end_matches('.'))
    };
    PossibleValuesParser::new(told.iter().map(value)).try_map(|given| {
        let found = told.iter().find(|(_, name, _)| *name == given);
        found.map(|(member, ..)| *member).ok_or("no such value")
    })
}

//! A number as JSON has it.

use schemars::Schema;

/// A number; null where it is not known, or has no limit.
pub type Number = Option<f64>;

/// Says that null may stand where a number may: JSON has neither NaN nor infinity.
pub(super) fn or_null(schema: &mut Schema) {
    if schema.get("type").is_some_and(|kind| kind == "number") {
        schema.insert("type".into(), ["number", "null"].into());
    }
}

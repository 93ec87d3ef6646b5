//! What a mistyped name may have meant.

/// Likeness (Jaro, 0 to 1) from which on a name may have been meant; that of the command line's own suggestions.
const ALIKE: f64 = 0.7;

/// The known name most like a mistyped one; none where no name is like it.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_lowercase();
    let alike = known.into_iter().map(|known| (strsim::jaro(&name, &known.to_lowercase()), known));
    alike.filter(|(likeness, _)| *likeness > ALIKE).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, known)| known)
}

/// `did you mean …? ` before a remedy; nothing where no known name is like it.
pub fn meant<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |nearest| format!("did you mean `{nearest}`? "))
}

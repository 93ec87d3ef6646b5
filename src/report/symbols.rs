//! Symbols, defined on every page that uses them, before it does.

/// A symbol: as it is defined, and as it stands in texts.
pub struct Symbol {
    /// Name and definition.
    pub definition: &'static str,
    /// What tells that a text uses it.
    pub marks: &'static [&'static str],
}

/// All symbols of the pages.
pub const SYMBOLS: [Symbol; 17] = [
    Symbol {
        definition: "κ₀ = k ℓ/E*: initial stiffness k of the contact springs per area, made a pure number by the length ℓ of the scene \
                     (Hertz's half-width, or the radius of the pin) and the contact modulus E* (1/E* = Σ (1−ν²)/E in plane strain, Σ 1/E in \
                     plane stress)",
        marks: &["κ₀"],
    },
    Symbol { definition: "κ = k ℓ/E*: the same of any spring", marks: &["κ ", "κ*"] },
    Symbol { definition: "p₀: largest pressure", marks: &["p₀"] },
    Symbol {
        definition: "a: half-width of the contact",
        marks: &["a/R", " a within", "p₀ and a", "p₀ or a", "p₀, a", "/a", "/ a", "a [mm]", " a /", "% in a"],
    },
    Symbol { definition: "R: radius", marks: &["a/R", "R =", " R t ", "eye 1", "2R"] },
    Symbol { definition: "θ: angle from the load line", marks: &["θ"] },
    Symbol { definition: "L: how far candidates reach", marks: &["L/a", "L²"] },
    Symbol { definition: "h: size of an element", marks: &["h/a", "h / a"] },
    Symbol { definition: "L2(p): error of the pressure profile, relative in the L2 norm", marks: &["L2(p)"] },
    Symbol {
        definition: "w, g, p: approach, initial gap and pressure of a contact point",
        marks: &["w/g", "p/g", "p/w", "g/p̄"],
    },
    Symbol {
        definition: "k₀, k*: spring stiffness at the start and at the end; K₀, K* the matrices of them, S that of the bodies as the contact sees them",
        marks: &["K₀", "k₀"],
    },
    Symbol { definition: "F, t, c: load, thickness, clearance", marks: &["t c/F", "R t p"] },
    Symbol { definition: "ε: half-angle of the contact", marks: &["ε = 30°", "ε = 60°", "ε = 80°"] },
    Symbol { definition: "u/g: displacement over the gap", marks: &["u/g"] },
    Symbol { definition: "u: standard uncertainty", marks: &["± u", "u_val", "u, "] },
    Symbol {
        definition: "E, u_val: difference of two values, and its standard uncertainty from all sources (ASME V&V 20)",
        marks: &["u_val"],
    },
    Symbol { definition: "dofs: degrees of freedom", marks: &["dofs"] },
];

/// The definitions of the symbols that a text uses; empty where it uses none.
pub fn of(text: &str) -> String {
    let used = SYMBOLS.iter().filter(|symbol| symbol.marks.iter().any(|mark| text.contains(mark)));
    let definitions: Vec<&str> = used.map(|symbol| symbol.definition).collect();
    if definitions.is_empty() { String::new() } else { format!("*Symbols.* {}.\n\n", definitions.join("; ")) }
}

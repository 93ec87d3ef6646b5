//! Examples that the help of each command ends with.

/// Of the program.
pub const ALL: &str = "\
Examples:
  contact-vv list
  contact-vv solve cylinder --plot cylinder.svg
  contact-vv new press-fit > mine.toml
  contact-vv solve mine.toml --csv profile.csv --vtu fields.vtu
  contact-vv verify tests/cases
  contact-vv report --check

In a checkout, `cargo run --release --` stands for `contact-vv`.";

/// Of `report`.
pub const REPORT: &str = "\
Examples:
  contact-vv report
  contact-vv report --only cylinder
  contact-vv report --check";

/// Of `solve`.
pub const SOLVE: &str = "\
Examples:
  contact-vv solve cylinder
  contact-vv solve cylinder --element line --algorithm constant --json -
  contact-vv solve cylinder --a-over-r 0.1 --resolution 32 --plot cylinder.svg
  contact-vv solve tests/cases/press-fit.toml --csv profile.csv --vtu fields.vtu
  contact-vv solve tests/cases/cylinder-on-block.toml --accuracy \"0.3 %\"";

/// Of `compare`.
pub const COMPARE: &str = "\
Examples:
  contact-vv compare cylinder
  contact-vv compare mine.toml --json - --plot compared.svg
  contact-vv compare pin-rod --formulations line.varying,line.varying+newton";

/// Of `verify`.
pub const VERIFY: &str = "\
Examples:
  contact-vv verify tests/cases
  contact-vv verify mine.toml other.toml --json";

/// Of `scoreboard`.
pub const SCOREBOARD: &str = "\
Examples:
  contact-vv scoreboard";

/// Of `export`.
pub const EXPORT: &str = "\
Examples:
  contact-vv export cylinder elsewhere
  contact-vv export mine.toml elsewhere
  contact-vv export cylinder elsewhere --condensed";

/// Of `judge`.
pub const JUDGE: &str = "\
Examples:
  contact-vv judge cylinder theirs.csv
  contact-vv judge cylinder theirs.csv --column pressure=CPRESS --unit pressure=MPa --unit position=mm
  contact-vv judge mine.toml forces.csv --order 2 --tolerance \"0.5 %\"
  contact-vv judge cylinder theirs.json --markdown
  contact-vv judge cylinder results/one.csv results/two.csv --junit verdicts.xml";

/// Of `verdicts`.
pub const VERDICTS: &str = "\
Examples:
  contact-vv verdicts > verdicts.jsonl";

/// Of `list`.
pub const LIST: &str = "\
Examples:
  contact-vv list
  contact-vv list --json
  contact-vv list --references > references.json";

/// Of `new`.
pub const NEW: &str = "\
Examples:
  contact-vv new
  contact-vv new cylinder > mine.toml
  contact-vv new gmsh > mine.toml && contact-vv new mesh > rings.msh";

/// Of `schema`.
pub const SCHEMA: &str = "\
Examples:
  contact-vv schema > schema.json
  contact-vv schema answer > answer-schema.json
  contact-vv schema references > references-schema.json";

/// Of `completions`.
pub const COMPLETIONS: &str = "\
Examples:
  contact-vv completions bash > ~/.local/share/bash-completion/completions/contact-vv
  contact-vv completions zsh > ~/.zfunc/_contact-vv";

/// Of `man`.
pub const MAN: &str = "\
Examples:
  contact-vv man > contact-vv.1
  contact-vv man ~/.local/share/man/man1";

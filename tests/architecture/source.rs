//! A source file below `src`: its module, and the words, paths and imports that its syntax holds.

use contact_vv::checkout::root;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::visit::{self, Visit};

/// A Rust file.
pub struct Source {
    /// Path below `src`, such as `mesh/outline/mod.rs`.
    pub file: String,
    /// Names of its module and of those around it, such as `mesh`, `outline`; none for `lib.rs`.
    pub module: Vec<String>,
    /// Its words; text in quotes is empty, comments are left out.
    pub words: Vec<String>,
    /// What it imports by `use`.
    pub uses: Vec<Use>,
    /// Every other path of its code.
    pub paths: Vec<Vec<String>>,
    /// Names of its traits.
    pub traits: Vec<String>,
    /// How many lines it has.
    pub lines: usize,
}

/// One name that `use` brings.
pub struct Use {
    /// Where it comes from; ends in `*` if all names do.
    pub path: Vec<String>,
    /// What it is called here.
    pub name: String,
    /// Whether others may import it from here.
    pub public: bool,
}

impl Source {
    /// A file of this text.
    pub fn new(file: &str, text: &str) -> Self {
        let tokens: TokenStream = text.parse().unwrap_or_else(|error| panic!("{file}: {error}"));
        let syntax = syn::parse2(tokens.clone()).unwrap_or_else(|error| panic!("{file}: {error}"));
        let mut found = Found::default();
        found.visit_file(&syntax);
        let Found { uses, paths, traits } = found;
        Self {
            file: file.to_owned(),
            module: module_of(file),
            words: words(tokens),
            uses,
            paths,
            traits,
            lines: text.lines().count(),
        }
    }

    /// Every path of the file, imported or written in its code.
    pub fn all_paths(&self) -> impl Iterator<Item = &Vec<String>> {
        self.uses.iter().map(|one| &one.path).chain(&self.paths)
    }

    /// The folder or file right below `src`, or `src/solver`, that it belongs to.
    pub fn link(&self) -> &str {
        self.file.trim_start_matches("solver/").split('/').next().unwrap_or_default().trim_end_matches(".rs")
    }

    /// Whether it is the reading guide of a folder.
    pub fn is_guide(&self) -> bool {
        self.file.ends_with("/mod.rs")
    }
}

fn module_of(file: &str) -> Vec<String> {
    // The solver is a crate of its own, whose modules are passed on by the suite's.
    let file = file.trim_start_matches("solver/").trim_end_matches(".rs");
    let mut names: Vec<String> = file.split('/').map(str::to_owned).collect();
    if names.last().is_some_and(|last| last == "mod" || last == "lib") {
        names.pop();
    }
    names
}

/// All files below `src`, in the order of their paths.
pub fn all() -> &'static [Source] {
    static ALL: LazyLock<Vec<Source>> = LazyLock::new(read_all);
    &ALL
}

fn read_all() -> Vec<Source> {
    let root = root().join("src");
    let mut files = files_in(&root);
    files.sort();
    let read = |path: PathBuf| {
        let inside = path.strip_prefix(&root).expect("it was found below src");
        let text = fs::read_to_string(&path).expect("a source can be read");
        Source::new(&inside.to_string_lossy().replace('\\', "/"), &text)
    };
    files.into_iter().map(read).collect()
}

fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(folder).expect("src can be read").map(|entry| entry.expect("an entry can be read").path());
    let below = entries.flat_map(|path| if path.is_dir() { files_in(&path) } else { vec![path] });
    below.filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect()
}

/// Identifiers, signs and brackets in order; a literal is an empty word.
pub fn words(tokens: TokenStream) -> Vec<String> {
    tokens.into_iter().flat_map(words_of).collect()
}

fn words_of(token: TokenTree) -> Vec<String> {
    match token {
        TokenTree::Ident(name) => vec![name.to_string()],
        TokenTree::Punct(sign) => vec![sign.as_char().to_string()],
        TokenTree::Literal(_) => vec![String::new()],
        TokenTree::Group(group) => {
            let [open, close] = match group.delimiter() {
                Delimiter::Parenthesis => ["(", ")"],
                Delimiter::Brace => ["{", "}"],
                Delimiter::Bracket => ["[", "]"],
                Delimiter::None => ["", ""],
            };
            [vec![open.to_owned()], words(group.stream()), vec![close.to_owned()]].concat()
        }
    }
}

/// Paths among the words of a macro, which has no syntax of its own.
fn paths_among(words: &[String]) -> Vec<Vec<String>> {
    let mut paths: Vec<Vec<String>> = Vec::new();
    for (at, word) in words.iter().enumerate().filter(|(_, word)| is_name(word)) {
        let joined = at >= 2 && words[at - 2..at] == [":", ":"];
        match paths.last_mut() {
            Some(path) if joined => path.push(word.clone()),
            _ => paths.push(vec![word.clone()]),
        }
    }
    paths
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

#[derive(Default)]
struct Found {
    uses: Vec<Use>,
    paths: Vec<Vec<String>>,
    traits: Vec<String>,
}

impl Found {
    fn imported(&mut self, before: &[String], tree: &syn::UseTree, public: bool) {
        let longer = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            syn::UseTree::Path(path) => self.imported(&longer(&path.ident), &path.tree, public),
            syn::UseTree::Group(group) => group.items.iter().for_each(|one| self.imported(before, one, public)),
            syn::UseTree::Glob(_) => self.brought([before, &["*".to_owned()]].concat(), "*", public),
            syn::UseTree::Rename(one) => self.brought(longer(&one.ident), &one.rename.to_string(), public),
            syn::UseTree::Name(one) if one.ident == "self" => {
                let name = before.last().cloned().unwrap_or_default();
                self.brought(before.to_vec(), &name, public);
            }
            syn::UseTree::Name(one) => self.brought(longer(&one.ident), &one.ident.to_string(), public),
        }
    }

    fn brought(&mut self, path: Vec<String>, name: &str, public: bool) {
        self.uses.push(Use { path, name: name.to_owned(), public });
    }
}

impl Visit<'_> for Found {
    fn visit_item_use(&mut self, item: &syn::ItemUse) {
        self.imported(&[], &item.tree, !matches!(item.vis, syn::Visibility::Inherited));
    }

    fn visit_path(&mut self, path: &syn::Path) {
        self.paths.push(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_item_trait(&mut self, item: &syn::ItemTrait) {
        self.traits.push(item.ident.to_string());
        visit::visit_item_trait(self, item);
    }

    fn visit_macro(&mut self, mac: &syn::Macro) {
        self.paths.extend(paths_among(&words(mac.tokens.clone())));
    }

    fn visit_meta_list(&mut self, list: &syn::MetaList) {
        self.paths.extend(paths_among(&words(list.tokens.clone())));
    }

    // `pub(super)` names a module and imports nothing.
    fn visit_visibility(&mut self, _: &syn::Visibility) {}
}

//! Which file of the crate imports which, with what a `mod.rs` passes on resolved to the file it comes from.

use std::collections::{BTreeMap, BTreeSet};

use super::source::{Source, Use};

/// How the binary names the library.
const LIBRARY: &str = "contact_vv";

/// Steps of passing a name on, from `mod.rs` to `mod.rs`, that are followed.
const PASSED_ON: usize = 8;

/// A path from the root of the crate, seen from a module; none where it begins with a name of the module's own.
pub fn from_root(module: &[String], path: &[String]) -> Option<Vec<String>> {
    let (first, rest) = path.split_first()?;
    let around = match first.as_str() {
        "crate" | LIBRARY => &[],
        "self" => module,
        "super" => {
            let (_, parent) = module.split_last()?;
            let ups = rest.iter().take_while(|name| *name == "super").count();
            return Some([parent.get(..parent.len().checked_sub(ups)?)?, &rest[ups..]].concat());
        }
        _ => return None,
    };
    Some([around, rest].concat())
}

/// The files of a crate by the module that each is.
pub struct Tree<'a> {
    files: BTreeMap<&'a [String], &'a Source>,
}

/// Where a path leads.
struct Target<'a> {
    source: &'a Source,
    /// Whether the path names the module itself instead of something in it.
    is_module: bool,
}

impl<'a> Tree<'a> {
    /// The tree of these files; the binary's own is no module of the library.
    pub fn new(sources: &'a [Source]) -> Self {
        let files = sources.iter().filter(|source| source.file != "main.rs");
        Self { files: files.map(|source| (source.module.as_slice(), source)).collect() }
    }

    /// The files that each file imports, by their paths.
    pub fn graph(&self) -> BTreeMap<&'a str, BTreeSet<&'a str>> {
        let modules = self.files.values().filter(|source| !source.module.is_empty());
        modules.map(|source| (source.file.as_str(), self.imports(source))).collect()
    }

    fn imports(&self, source: &'a Source) -> BTreeSet<&'a str> {
        let used = source.uses.iter().filter(|one| !self.is_passed_on(source, one));
        let used = used.filter_map(|one| self.target(&source.module, &one.path, PASSED_ON));
        // A folder that is only named is not imported: what is taken from it stands in the code.
        let used = used.filter(|target| !(target.is_module && target.source.is_guide()));
        let written = source.paths.iter().filter_map(|path| self.target(&source.module, path, PASSED_ON));
        // Alone, the name of a module is that of a variable.
        let written = written.filter(|target| !target.is_module);
        let files = used.chain(written).map(|target| target.source.file.as_str());
        files.filter(|file| *file != source.file).collect()
    }

    /// Whether a `mod.rs` only passes a name of a file below it on.
    fn is_passed_on(&self, source: &Source, one: &Use) -> bool {
        let target = self.target(&source.module, &one.path, PASSED_ON);
        source.is_guide() && one.public && target.is_some_and(|t| t.source.module.starts_with(&source.module))
    }

    /// What a path means in a module: a child, a name imported there, or nothing of this crate.
    fn target(&self, module: &[String], path: &[String], left: usize) -> Option<Target<'a>> {
        if let Some(path) = from_root(module, path) {
            return self.walk(&[], &path, left);
        }
        let (first, _) = path.split_first()?;
        let known = self.child(module, first).is_some() || self.imported(module, first).is_some();
        if known { self.walk(module, path, left) } else { None }
    }

    /// Follows the names of a path from a module on.
    fn walk(&self, from: &[String], names: &[String], left: usize) -> Option<Target<'a>> {
        let mut module = from.to_vec();
        for (index, name) in names.iter().enumerate() {
            if self.child(&module, name).is_some() {
                module.push(name.clone());
                continue;
            }
            if let Some(one) = self.imported(&module, name) {
                let path = [one.path.as_slice(), &names[index + 1..]].concat();
                let itself = one.path.first() == Some(name) && from_root(&module, &one.path).is_none();
                return if left == 0 || itself { None } else { self.target(&module, &path, left - 1) };
            }
            return self.files.get(module.as_slice()).map(|source| Target { source, is_module: false });
        }
        self.files.get(module.as_slice()).map(|source| Target { source, is_module: true })
    }

    fn child(&self, module: &[String], name: &str) -> Option<&'a Source> {
        self.files.get([module, &[name.to_owned()]].concat().as_slice()).copied()
    }

    fn imported(&self, module: &[String], name: &str) -> Option<&'a Use> {
        self.files.get(module)?.uses.iter().find(|one| one.name == name)
    }
}

/// Groups of files that import one another, directly or through others.
pub fn circles<'a>(graph: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> Vec<Vec<&'a str>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> = graph.keys().map(|file| (*file, reached_from(graph, file))).collect();
    let together = |a: &str, b: &str| reached[a].contains(b) && reached.get(b).is_some_and(|back| back.contains(a));
    let groups = graph.keys().map(|a| graph.keys().copied().filter(|b| together(a, b)).collect::<Vec<_>>());
    let groups: BTreeSet<Vec<&str>> = groups.filter(|group| !group.is_empty()).collect();
    groups.into_iter().collect()
}

fn reached_from<'a>(graph: &BTreeMap<&'a str, BTreeSet<&'a str>>, from: &'a str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut open = vec![from];
    while let Some(next) = open.pop().and_then(|file| graph.get(file)) {
        open.extend(next.iter().filter(|file| reached.insert(**file)));
    }
    reached
}

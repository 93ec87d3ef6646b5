//! One page of the report, by the name of its case or study.

use contact_vv::checkout::root;
use std::path::Path;

use crate::program::{Folder, ended, program};

#[test]
fn one_page_of_a_case_is_that_of_the_report_and_a_mistyped_name_is_told_with_its_like() {
    let folder = Folder::made();
    // A checkout with what pages are made from, and none of them.
    folder.with("Cargo.toml", "");
    let own = root();
    for (inside, of) in
        [("tests/cases", "toml"), ("tests/cases/meshes", "msh"), ("snapshots", "csv"), ("snapshots", "json")]
    {
        std::fs::create_dir_all(folder.path().join(inside)).expect("made");
        for file in std::fs::read_dir(own.join(inside)).expect("a folder").map(|file| file.expect("a file").path()) {
            if file.extension().is_some_and(|ending| ending == of) {
                let name = file.file_name().expect("a name");
                std::fs::copy(&file, folder.path().join(inside).join(name)).expect("copied");
            }
        }
    }
    for inside in ["pages", "charts", "sheets"] {
        std::fs::create_dir_all(folder.path().join("snapshots").join(inside)).expect("made");
    }
    let report = |name: &str| ended(program(&["report", "--only", name]).current_dir(folder.path()));
    for (name, page) in [
        ("blocks.toml", "case-blocks-toml"),
        ("tests/cases/moment.toml", "case-moment-toml"),
        ("press-fit", "case-press-fit"),
    ] {
        let (code, shown, error) = report(name);
        let file = format!("snapshots/pages/{page}.md");
        let read = |root: &Path| std::fs::read_to_string(root.join(&file)).expect("a page");
        let committed = read(&own);
        assert_eq!(code, Some(0), "{name}: {error}");
        assert!(read(folder.path()) == committed && shown.starts_with(committed.trim_end()), "{name}: {shown:.300}");
        assert!(shown.trim_end().ends_with(&file), "{name}");
    }
    let (code, shown, error) = report("blocs.toml");
    assert_eq!((code, shown.as_str()), (Some(2), ""));
    assert!(error.contains("did you mean `blocks.toml`?") && error.contains("fitted"), "{error}");
}

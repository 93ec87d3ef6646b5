//! Where everything else breaks: one row a limit, then the tables that show more, then the requirements.

use crate::markdown;
use crate::report::checks;
use crate::study::limits;
use crate::study::unsorted::{Finding, Table};

/// The section of the page.
pub fn section(findings: &[Finding]) -> String {
    let members: Vec<&Finding> = findings.iter().filter(|finding| finding.case == limits::CASE).collect();
    let tables = |summary: bool| {
        let all = members.iter().flat_map(|finding| &finding.tables);
        all.filter(move |table| (table.title == limits::SUMMARY) == summary).collect::<Vec<&Table>>()
    };
    let rows: Vec<Vec<String>> = tables(true).iter().flat_map(|table| table.rows.clone()).collect();
    let mut text = String::from(
        "## Where everything else breaks\n\n\
         Each row pushes one thing until something gives. What the user sees is what the program said in that run.\n\n",
    );
    text += &markdown::table(&limits::HEAD.map(String::from), &rows);
    for table in tables(false) {
        text += &format!("\n{}", crate::study::unsorted::folded_table(table));
    }
    text + &checks::table(&members)
}

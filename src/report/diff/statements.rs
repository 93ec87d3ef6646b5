//! Statements of the paper whose judgement changed, that came or that went.

use super::told::Told;
use super::words::counted;
use crate::report::record::StatementRow;

/// Changed judgements, then what went and came; a statement with another sentence and the same numbers was reworded.
pub fn told(before: &[StatementRow], after: &[StatementRow]) -> Option<Told> {
    let find =
        |rows: &'_ [StatementRow], one: &StatementRow| rows.iter().position(|row| row.statement == one.statement);
    let same = |one: &StatementRow, row: &StatementRow| row.judgement == one.judgement && row.measured == one.measured;
    let mut rows = Vec::new();
    let mut gone: Vec<&StatementRow> = before.iter().filter(|one| find(after, one).is_none()).collect();
    for new in after {
        match find(before, new).map(|index| &before[index]) {
            Some(old) if old.judgement != new.judgement => {
                rows.push(format!("“{}”: {} → {}", new.statement, old.judgement, new.judgement));
            }
            Some(old) if old.measured != new.measured => {
                rows.push(format!("“{}”, still {}: {} → {}", new.statement, new.judgement, old.measured, new.measured));
            }
            Some(_) => (),
            None => match gone.iter().position(|old| same(old, new)) {
                Some(index) => rows.push(format!("reworded: “{}” → “{}”", gone.remove(index).statement, new.statement)),
                None => rows.push(format!("new: “{}”: {}", new.statement, new.judgement)),
            },
        }
    }
    rows.extend(gone.iter().map(|old| format!("GONE: “{}”: {}", old.statement, old.judgement)));
    (!rows.is_empty()).then(|| Told::new(format!("Statements of the paper: {}", counted(rows.len(), "change")), rows))
}

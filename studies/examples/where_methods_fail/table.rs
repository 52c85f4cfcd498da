//! Text output of all cases, and the table of the book.

use testbed::where_methods_fail::row::Row;

/// Formats all claims of all cases.
pub(crate) fn text(rows: &[Row]) -> String {
    let mut text = String::new();
    for row in rows {
        text += &format!("{}\n", row.case);
        for claim in &row.claims {
            let mark = if claim.holds { "" } else { "   <- does not hold" };
            text += &format!(
                "  {:<76} {:>22} {:>22}{mark}\n",
                claim.what, claim.predicted, claim.observed
            );
        }
        text += &format!("  survives: {}\n\n", row.survives);
    }
    let head = format!("{:<78} {:>22} {:>22}\n\n", "", "predicted", "observed");
    head + &text
}

/// Formats the table of the book: the first claim of some cases.
pub(crate) fn markdown(rows: &[Row]) -> String {
    let mut lines = vec![
        "| case | | predicted | observed | methods that succeed |".to_owned(),
        "|---|---|---:|---:|---|".to_owned(),
    ];
    for row in rows.iter().filter(|row| row.in_book) {
        if let Some(claim) = row.claims.first() {
            let cells = [row.case, &claim.what, &claim.predicted, &claim.observed, row.survives];
            lines.push(format!(
                "| {} |",
                cells.map(|cell| cell.replace('|', "\\|")).join(" | ")
            ));
        }
    }
    lines.join("\n") + "\n"
}

//! EVALUATION.md: what all systems measured, as a page.

use super::{Line, figure};
use std::collections::BTreeMap;
use std::fmt::Write;

/// What one system told.
pub(crate) struct Chapter {
    pub(crate) system: String,
    pub(crate) lines: Vec<Line>,
    pub(crate) seconds: f64,
    /// What went wrong, where it did not come to its end, and what it said beside its rows.
    pub(crate) notes: Vec<String>,
}

/// The page. Of rows without a paper's figure, a peer's or an aim, there is only the number: they are in what
/// `evaluate SYSTEM` prints.
pub(crate) fn markdown(chapters: &[Chapter], machine: &str) -> String {
    let mut page = String::from("# Evaluation\n\nThe papers' figures beside ours. ");
    let total: f64 = chapters.iter().map(|chapter| chapter.seconds).sum();
    let _ = writeln!(
        page,
        "Written by `cargo run --release -p evaluate -- all` in {} minutes on {machine}; one system alone by its name.\n",
        figure((total / 6.0).round() / 10.0)
    );
    summary(&mut page, chapters);
    for chapter in chapters {
        of_system(&mut page, chapter);
    }
    page
}

fn summary(page: &mut String, chapters: &[Chapter]) {
    page.push_str("| system | aims that hold | of | seconds |\n|---|---|---|---|\n");
    for chapter in chapters {
        let with_aim = chapter.lines.iter().filter(|line| line.holds.is_some());
        let held = with_aim.clone().filter(|line| line.holds == Some(true)).count();
        let _ = writeln!(
            page,
            "| [{0}](#{0}) | {held} | {1} | {2} |",
            chapter.system,
            with_aim.count(),
            chapter.seconds.round()
        );
    }
    let missed: Vec<&Line> = chapters
        .iter()
        .flat_map(|chapter| &chapter.lines)
        .filter(|line| line.holds == Some(false))
        .collect();
    if missed.is_empty() {
        page.push_str("\nNo aim was missed.\n");
        return;
    }
    let (explained, plain): (Vec<&Line>, Vec<&Line>) =
        missed.into_iter().partition(|line| line.why.is_some());
    if !plain.is_empty() {
        page.push_str(
            "\nMissed:\n\n| system | case | figure | ours | aim | off |\n|---|---|---|---|---|---|\n",
        );
    }
    for line in plain {
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} {} | {} | {} |",
            line.system,
            cell(&line.case),
            cell(&line.metric),
            line.ours.map_or("NaN".into(), figure),
            line.unit,
            line.aim.as_deref().unwrap_or_default(),
            line.off.as_deref().unwrap_or_default()
        );
    }
    reasons(page, &explained);
}

/// Rows that miss for a known reason, by it: there are many of the same.
fn reasons(page: &mut String, lines: &[&Line]) {
    let mut by: BTreeMap<(&str, &str), Vec<String>> = BTreeMap::new();
    for line in lines {
        let key = (line.system.as_str(), line.why.as_deref().unwrap_or_default());
        by.entry(key).or_default().push(format!("{}: {}", line.case, line.metric));
    }
    if by.is_empty() {
        return;
    }
    page.push_str("\nMissed for a reason:\n\n| system | rows | because |\n|---|---|---|\n");
    for ((system, why), rows) in by {
        let which = if rows.len() <= 3 { rows.join("; ") } else { rows.len().to_string() };
        let _ = writeln!(page, "| {system} | {} | {} |", cell(&which), cell(why));
    }
}

fn of_system(page: &mut String, chapter: &Chapter) {
    let _ = writeln!(page, "\n## {}\n", chapter.system);
    for note in &chapter.notes {
        let _ = writeln!(page, "> {}\n", cell(note));
    }
    let told = |line: &&Line| line.paper.is_some() || line.peer.is_some() || line.aim.is_some();
    let rows: Vec<&Line> = chapter.lines.iter().filter(told).collect();
    if !rows.is_empty() {
        page.push_str("| case | figure | paper | peer | ours | unit | aim | holds |\n");
        page.push_str("|---|---|---|---|---|---|---|---|\n");
    }
    let optional = |value: Option<f64>| value.map_or(String::new(), figure);
    for line in &rows {
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} | {} | {} | {} | {} |",
            cell(&line.case),
            cell(&line.metric),
            optional(line.paper),
            optional(line.peer),
            line.ours.map_or("NaN".into(), figure),
            line.unit,
            line.aim.as_deref().unwrap_or_default(),
            line.verdict()
        );
    }
    let left_out = chapter.lines.len() - rows.len();
    if left_out > 0 {
        let _ = writeln!(page, "\nAnd {left_out} rows for information.");
    }
}

/// Text that stays in its cell.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{Aim, Row};

    fn line(ours: f64, aim: Aim) -> Line {
        let row = Row { case: "a|b", metric: "m", paper: None, peer: None, ours, unit: "s", aim };
        Line::of("system", &row)
    }

    #[test]
    fn a_page_tells_what_was_missed_and_by_how_much() {
        let lines = vec![
            line(2.0, Aim::AtMost(1.0)),
            line(0.9, Aim::AtLeast(1.0)),
            line(3.0, Aim::AtMost(0.0)),
            line(5.0, Aim::Within(1.0, 4.0)),
            line(1.0, Aim::AtMost(1.0)),
            line(7.0, Aim::None),
            Line { why: Some("of a fault".into()), ..line(9.0, Aim::AtMost(8.0)) },
        ];
        let off: Vec<_> = lines.iter().map(Line::verdict).collect();
        assert_eq!(
            off,
            ["NO, by 100 %", "NO, by 10 %", "NO, by 3", "NO, by 25 %", "yes", "", "NO, by 12.50 %"]
        );
        let chapter =
            Chapter { system: "system".into(), lines, seconds: 3.0, notes: vec!["skipped".into()] };
        let page = markdown(&[chapter], "a machine");
        assert!(page.contains("| [system](#system) | 1 | 6 | 3 |"), "{page}");
        assert!(page.contains("| a\\|b | m |  |  | 5 | s | 1 to 4 | NO, by 25 % |"), "{page}");
        assert!(page.contains("| system | a\\|b: m | of a fault |"), "{page}");
        assert!(
            page.contains("> skipped") && page.contains("And 1 rows for information"),
            "{page}"
        );
    }
}

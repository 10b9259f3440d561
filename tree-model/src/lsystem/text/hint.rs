//! "Did you mean": the known name that is nearest to a mistyped one.

/// Names that differ by more single-character edits than this are not proposed.
const MOST_EDITS: usize = 2;
/// Longer names are not compared: the comparison is quadratic.
const LONGEST: usize = 64;

/// A hint that proposes the nearest of the known names, or an empty text.
pub(crate) fn did_you_mean<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let n = name.chars().count();
    if n > LONGEST {
        return String::new();
    }
    let best = known
        .filter(|other| other.len() <= LONGEST && *other != name)
        .map(|other| (edits(name, other), other.len(), other))
        .filter(|&(edits, ..)| edits <= MOST_EDITS && edits < n)
        .min();
    best.map_or_else(String::new, |(.., other)| format!("did you mean '{other}'?"))
}

/// Insertions, deletions and exchanges between two names, upper and lower case being equal.
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().flat_map(char::to_lowercase).collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().flat_map(char::to_lowercase).enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let exchanged = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = exchanged.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_proposed_and_far_ones_not() {
        let known = || ["length", "width", "angle"].into_iter();
        assert_eq!(did_you_mean("lenght", known()), "did you mean 'length'?");
        assert_eq!(did_you_mean("Angle", known()), "did you mean 'angle'?");
        assert_eq!(did_you_mean("zz", known()), "");
    }
}

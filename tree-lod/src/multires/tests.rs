//! The paper's example, and what must hold for any tree.

use super::*;
use proptest::prelude::*;
use tree_core::{Control, Seed};

/// Chain (3) of the paper: a letter for each module Cn.
const CHAIN: &str = "1[2[3[4][5[6][7]]][9[b][a]][8]][c[d][e][f[g]]]";

fn adt(chain: &str) -> Adt {
    Adt::of_tokens(chain.chars().map(|c| match c {
        '[' => Token::Push,
        ']' => Token::Pop,
        _ => Token::Module(1.0),
    }))
    .unwrap()
}

fn multi(chain: &str, metric: &Metric) -> String {
    let adt = adt(chain);
    let paths = paths(&adt, metric, &Control::default()).unwrap();
    let multi = MultiChain::new(&adt, &paths).unwrap();
    let name = |place| chain.chars().nth(place as usize).unwrap().to_string();
    multi.text(multi.n_levels(), name).replace("SAVE", "S").replace("RESTORE", "R")
}

#[test]
fn branching_lengths_are_those_of_figure_1() {
    let adt = adt(CHAIN);
    let mut left = adt.lengths().to_vec();
    metric::upwards(&adt, |child, parent| left[parent] += left[child]);
    let expected = [16, 10, 5, 1, 3, 1, 1, 3, 1, 1, 1, 5, 1, 1, 2, 1].map(f64::from);
    assert_eq!(left, expected);
}

/// Derived by hand from section 4.1.3; the paper's chain (4) is missing in the text. What is left after each
/// path, where it matters:
/// 1-2-3-5-6; C2 6 > C12 5, in it C9 3; C12 5 > C2 4; C2 4 > C12 2, in it C3 2, C4 = C5 1; C2 3, C5 1; C2 = C12 2,
/// C9 1; C12 2, C13 1; C2 = C12 1, C8; C14.
#[test]
fn the_papers_chain_gives_the_multi_chain_derived_by_hand() {
    let expected = "1S(0)2S(1)3S(2)5S(3)6R(1)9S(4)bR(0)cS(5)fgR(2)4R(3)7R(4)aR(5)dR(1)8R(5)e";
    assert_eq!(multi(CHAIN, &Metric::BranchingLength), expected);
}

#[test]
fn branches_that_go_on_past_their_forks_are_saved_at_the_bracket() {
    // The trunk is a path of its own; its laterals stem from states within it.
    let expected = "FS(0)FS(1)FR(0)+FR(1)-F";
    assert_eq!(multi("F[+F]F[-F]F", &Metric::BranchingLength), expected);
}

#[test]
fn undone_derivations_go_order_by_order() {
    let expected = "1S(0)R(0)2S(1)R(0)cS(2)R(1)3R(1)4R(2)d";
    assert_eq!(multi("1[2[3][4]][c[d]]", &Metric::Generation), expected);
}

#[test]
fn brackets_that_do_not_match_and_bad_lengths_are_named() {
    use Token::{Module, Pop, Push};
    let at = |tokens: &[Token]| match Adt::of_tokens(tokens.iter().copied()) {
        Err(crate::LodError::Chain { module, .. }) => module,
        other => panic!("{other:?}"),
    };
    assert_eq!(at(&[Module(1.0), Pop]), 1);
    assert_eq!(at(&[Push, Module(1.0)]), 3);
    assert_eq!(at(&[Module(0.0), Module(f64::NAN)]), 1);
    assert_eq!(at(&[Module(-1.0)]), 0);
}

#[test]
fn a_million_brackets_do_not_overflow_the_stack() {
    let n = 1_000_000;
    let deep = std::iter::repeat_n([Token::Push, Token::Module(1.0)], n).flatten();
    let adt = Adt::of_tokens(deep.chain(std::iter::repeat_n(Token::Pop, n))).unwrap();
    for metric in [Metric::BranchingLength, Metric::Density] {
        let paths = paths(&adt, &metric, &Control::default()).unwrap();
        assert_eq!((paths.len(), paths.path(0).len()), (1, n + 1));
    }
}

#[test]
fn a_bush_of_many_branches_is_quick() {
    let chain = std::iter::repeat_n([Token::Push, Token::Module(1.0), Token::Pop], 200_000);
    let adt = Adt::of_tokens(chain.flatten()).unwrap();
    for metric in [Metric::BranchingLength, Metric::Density] {
        let paths = paths(&adt, &metric, &Control::default()).unwrap();
        assert_eq!(paths.len(), 200_000);
    }
}

#[test]
fn worths_must_fit_the_branches() {
    let adt = adt(CHAIN);
    for metric in [Metric::Branching, Metric::DensityOf] {
        let try_worths = |worths| paths(&adt, &metric(worths), &Control::default());
        assert!(matches!(try_worths(vec![1.0]), Err(crate::LodError::Length { .. })));
        assert!(matches!(try_worths(vec![f64::NAN; 16]), Err(crate::LodError::Parameter(_))));
    }
}

#[test]
fn paths_of_another_tree_are_refused() {
    let control = Control::default();
    let (small, large) = (adt("1[2]"), adt(CHAIN));
    let paths = |adt: &Adt| paths(adt, &Metric::default(), &control).unwrap();
    for (adt, other) in [(&small, &large), (&large, &small)] {
        let result = MultiChain::new(adt, &paths(other));
        assert!(matches!(result, Err(crate::LodError::Order { .. })));
    }
    let mut builder = tree_core::Skeleton::builder(glam::Vec3::ZERO, 1.0).unwrap();
    builder.add(0, glam::Vec3::Y, 1.0).unwrap();
    let tree = tree_core::Tree::bare(builder.finish(), tree_core::Species::default());
    for chain in ["12[][]", "1[3]2", "123"] {
        let adt = adt(chain);
        let result = Multires::of_paths(&tree, &adt, &paths(&adt));
        assert!(matches!(result, Err(crate::LodError::Order { .. })), "{chain}");
    }
}

/// A random bracketed chain, from numbers: 0 opens, 1 closes, others are modules.
fn chain_of(numbers: &[u8]) -> Vec<Token> {
    let mut depth = 0;
    let mut tokens = Vec::new();
    for &number in numbers {
        match number % 4 {
            0 => {
                depth += 1;
                tokens.push(Token::Push);
            }
            1 if depth > 0 => {
                depth -= 1;
                tokens.push(Token::Pop);
            }
            _ => tokens.push(Token::Module(f64::from(number / 4))),
        }
    }
    tokens.extend(std::iter::repeat_n(Token::Pop, depth));
    tokens
}

proptest! {
    #[test]
    fn every_module_is_there_once_and_states_are_saved_before_they_are_needed(
        numbers in proptest::collection::vec(any::<u8>(), 0..300), which in 0..7_usize,
    ) {
        let tokens = chain_of(&numbers);
        let adt = Adt::of_tokens(tokens.iter().copied()).unwrap();
        let metrics = [
            Metric::Children, Metric::Descendants, Metric::LongestPath, Metric::BranchingLength,
            Metric::Generation, Metric::Random(Seed(3)), Metric::Density,
        ];
        let paths = paths(&adt, &metrics[which], &Control::default()).unwrap();
        let mut branches = paths.branches().to_vec();
        branches.sort_unstable();
        prop_assert!(branches.iter().copied().eq(0..adt.len() as u32));
        let multi = MultiChain::new(&adt, &paths).unwrap();
        let mut modules: Vec<u32> = Vec::new();
        let mut saved = vec![false; multi.n_states() as usize];
        for item in multi.items() {
            match *item {
                Item::Module(place) => modules.push(place),
                Item::Save(state) => {
                    prop_assert!(!saved[state as usize]);
                    saved[state as usize] = true;
                }
                Item::Restore(state) => prop_assert!(saved[state as usize]),
            }
        }
        modules.sort_unstable();
        let is_module = |(_, token): &(u32, &Token)| matches!(token, Token::Module(_));
        let plain: Vec<u32> = (0..).zip(&tokens).filter(is_module).map(|(place, _)| place).collect();
        prop_assert_eq!(modules, plain);
        // SAVE and RESTORE take the place of brackets.
        prop_assert!(multi.items().len() <= tokens.len());
    }
}

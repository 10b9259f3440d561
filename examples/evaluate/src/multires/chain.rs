//! The paper's multi-chain, and what levels cost in bytes.

use super::trees::Case;
use super::{Outcome, information};
use crate::table::{Aim, Row, Table};
use tree_core::Control;
use tree_lod::multires::stream::{StreamParams, encode, encode_chain};
use tree_lod::multires::{Adt, Metric, MultiChain, Multires, Token, paths};

/// Chain (3) of the paper: a letter for each module Cn.
const CHAIN: &str = "1[2[3[4][5[6][7]]][9[b][a]][8]][c[d][e][f[g]]]";
/// What section 4.1.3 gives for it, by hand: S(n) is SAVE, R(n) RESTORE.
const BY_HAND: &str = "1S(0)2S(1)3S(2)5S(3)6R(1)9S(4)bR(0)cS(5)fgR(2)4R(3)7R(4)aR(5)dR(1)8R(5)e";
/// Bytes of a stream against those of the plain chain.
const LARGEST: f64 = 1.1;
/// Precision of streams for the eye in metres.
const MILLIMETRE: f32 = 1e-3;

pub(super) fn evaluate(table: &mut Table, trees: &[Case]) -> Outcome {
    table.row(&Row {
        case: "chain (3) of the paper",
        metric: "multi-chain as by hand (1)",
        paper: Some(1.0),
        peer: None,
        ours: f64::from(u8::from(of_paper()? == BY_HAND)),
        unit: "",
        aim: Aim::AtLeast(1.0),
    });
    for Case { name, tree } in trees {
        let multires = Multires::new(tree, &Metric::default(), &Control::default())?;
        for (how, precision) in [("exact", 0.0), ("1 mm", MILLIMETRE)] {
            let params = StreamParams { precision };
            let levels = encode(&multires, multires.n_levels(), &params)?.len() as f64;
            let plain = encode_chain(&multires, &params)?.len() as f64;
            table.row(&Row {
                case: &format!("stream of {name}"),
                metric: &format!("bytes / plain chain, {how}"),
                paper: None,
                peer: None,
                ours: levels / plain,
                unit: "",
                aim: Aim::AtMost(LARGEST),
            });
            if precision > 0.0 {
                let n = tree.skeleton().len() + tree.foliage().len();
                let case = format!("stream of {name}: {} levels", multires.n_levels());
                information(table, &case, "bytes a node or leaf, 1 mm", levels / n as f64, "bytes");
            }
        }
    }
    Ok(())
}

fn of_paper() -> Outcome<String> {
    let adt = Adt::of_tokens(CHAIN.chars().map(|c| match c {
        '[' => Token::Push,
        ']' => Token::Pop,
        _ => Token::Module(1.0),
    }))?;
    let paths = paths(&adt, &Metric::BranchingLength, &Control::default())?;
    let multi = MultiChain::new(&adt, &paths)?;
    let name = |place| CHAIN.chars().nth(place as usize).map_or(String::new(), String::from);
    let text = multi.text(multi.n_levels(), name);
    Ok(text.replace("SAVE", "S").replace("RESTORE", "R"))
}

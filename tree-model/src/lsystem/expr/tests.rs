//! Values, faults and mistakes of expressions.

use super::*;
use crate::ModelError;
use crate::lsystem::text::{Cursor, Source};
use std::collections::BTreeMap;
use tree_core::Seed;

fn compile(text: &str) -> crate::error::Result<Expr> {
    let source = Source::new(text)?;
    let mut cursor = Cursor::new(&source, 0..text.len());
    let constants = BTreeMap::from([("half".to_owned(), 0.5)]);
    let mut draws = 0;
    let scope =
        &mut Scope { constants: &constants, params: &[("x", 0), ("y", 1)], draws: &mut draws };
    let expr = parse(&mut cursor, scope)?;
    cursor.finish()?;
    Ok(expr)
}

fn eval(text: &str) -> Result<f64, Fault> {
    let expr = compile(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let env = Env { step: 2.0, steps: 5.0, stream: Seed(1), module: 3 };
    expr.eval(&[3.0, 0.0], &env, &mut Vec::new())
}

fn mistake(text: &str) -> (usize, String) {
    match compile(text) {
        Err(ModelError::Grammar { column, problem, hint, .. }) => {
            (column, format!("{problem}; {hint}"))
        }
        other => panic!("{text}: {other:?}"),
    }
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, value) in [
        ("1+2*3", 7.0),
        ("(1+2)*3", 9.0),
        ("2^3^2", 512.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("7-2-1", 4.0),
        ("7%4*2", 6.0),
        ("-7%4", -3.0),
        ("1+x*half", 2.5),
        ("x-1=2", 1.0),
        ("1 < 2 == 2 > 1", 1.0),
        ("1 || 0 && 0", 1.0),
        ("not x == 3", 0.0),
        ("!0 and x >= 3", 1.0),
        ("x ≠ 3 | y ≤ 0", 1.0),
        ("1e-1 + .5 + 2.", 2.6),
        ("itNum/maxIt", 0.4),
        ("--3 + +2", 5.0),
    ] {
        assert_eq!(eval(text).unwrap(), value, "{text}");
    }
}

#[test]
fn functions_take_degrees_and_are_exact_at_right_angles() {
    for (text, value) in [
        ("sin(90)", 1.0),
        ("cos(90)", 0.0),
        ("cos(-180)", -1.0),
        ("sin(450)", 1.0),
        ("max(min(x,5),4)", 4.0),
        ("pow(x,2)", 9.0),
        ("floor(-0.5)+ceil(0.5)", 0.0),
        ("sign(-x)", -1.0),
        ("abs(-x)", 3.0),
        ("if(x>2,10,20)+1", 11.0),
        ("if(x<2,10,if(y,1,2))", 2.0),
        ("sqrt(x+1)", 2.0),
    ] {
        assert_eq!(eval(text).unwrap(), value, "{text}");
    }
    for (text, value) in
        [("sin(30)", 0.5), ("atan2(x,x)", 45.0), ("log(exp(2))", 2.0), ("acos(0)", 90.0)]
    {
        assert!((eval(text).unwrap() - value).abs() < 1e-12, "{text}");
    }
}

#[test]
fn what_is_not_needed_is_not_computed() {
    assert_eq!(eval("y != 0 && 1/y > 2").unwrap(), 0.0);
    assert_eq!(eval("y == 0 || 1/y > 2").unwrap(), 1.0);
    assert_eq!(eval("if(y, 1/y, 7)").unwrap(), 7.0);
}

#[test]
fn faults_name_the_operation() {
    let fault = |text| eval(text).unwrap_err().0.into_string();
    assert_eq!(fault("1/y"), "division by zero");
    assert_eq!(fault("x%y"), "division by zero");
    assert_eq!(fault("1/(1/y)"), "division by zero");
    assert_eq!(fault("1/0"), "division by zero");
    assert_eq!(fault("sqrt(-x)"), "sqrt(-3) is NaN");
    assert_eq!(
        fault("x*1e300*1e300"),
        "3e300 * 1e300 is inf"
            .replace("3e300", &format!("{}", 3e300))
            .replace("1e300", &format!("{}", 1e300))
    );
    assert_eq!(fault("log(y)"), "log(0) is -inf");
}

#[test]
fn random_numbers_stay_in_their_range_and_differ_by_module() {
    let expr = compile("ran(x)").unwrap();
    let mut values: Vec<f64> = (0..1000)
        .map(|module| {
            let env = Env { step: 1.0, steps: 1.0, stream: Seed(1), module };
            expr.eval(&[3.0, 0.0], &env, &mut Vec::new()).unwrap()
        })
        .collect();
    assert!(values.iter().all(|x| (0.0..3.0).contains(x)));
    values.sort_by(f64::total_cmp);
    values.dedup();
    assert_eq!(values.len(), 1000);
}

#[test]
fn normal_numbers_have_their_mean_and_deviation() {
    let expr = compile("nran(10, x)").unwrap();
    let n = 20_000;
    let draw = |module| {
        let env = Env { step: 1.0, steps: 1.0, stream: Seed(1), module };
        expr.eval(&[3.0, 0.0], &env, &mut Vec::new()).unwrap()
    };
    let mean = (0..n).map(draw).sum::<f64>() / n as f64;
    let squared = |x: f64| x * x;
    let variance = (0..n).map(|i| squared(draw(i) - mean)).sum::<f64>() / n as f64;
    assert!((mean - 10.0).abs() < 0.06 && (variance - 9.0).abs() < 0.3, "{mean} {variance}");
}

#[test]
fn mistakes_are_placed_and_explained() {
    for (text, column, says) in [
        ("1 + z", 5, "nothing is named 'z'"),
        ("1 + halv", 5, "did you mean 'half'?"),
        ("sinn(3)", 1, "did you mean 'sin'?"),
        ("sin", 1, "lacks its arguments"),
        ("max(1)", 1, "1 argument(s), 2 are needed"),
        ("sin(1,2)", 1, "too many arguments"),
        ("(1,2)", 3, "',' in parentheses that belong to no function"),
        ("1 +", 4, "the statement ends where a number"),
        ("(1", 3, "an operator or ')'"),
        ("1e999", 1, "too large"),
        ("* 2", 1, "'*' where a number"),
        ("x 2", 3, "'2' where the end of the statement was expected"),
    ] {
        let (at, problem) = mistake(text);
        assert!(at == column && problem.contains(says), "{text}: {at} {problem}");
    }
}

#[test]
fn deep_expressions_are_refused_without_recursion() {
    let text = format!("{}1{}", "(".repeat(100_000), ")".repeat(100_000));
    assert!(mistake(&text).1.contains("nested more than 256 deep"));
    assert!(mistake(&"-".repeat(100_000)).1.contains("nested more than 256 deep"));
    let long = vec!["x"; 10_000].join("+");
    assert_eq!(eval(&long).unwrap(), 30_000.0);
}

//! The order of a list. Rust's own sort may panic when a comparison contradicts itself; this one ends with some order, and
//! says so where two neighbours in it are in no order.

use crate::rules::script::Interpreter;
use crate::rules::script::data::Data;
use crate::rules::script::stop::{Stop, fail};

/// Sorts a list by the order of its numbers or texts, or by a function that says whether the first of two values goes
/// before the second: `true`, or a number below 0. What is equal keeps its order; after an error everything does.
///
/// # Errors
/// If two items have no order, or the function fails or contradicts itself.
pub fn sort(interpreter: &mut Interpreter, items: &mut Vec<Data>, function: Option<&Data>) -> Result<(), Stop> {
    interpreter.meter.values(items.len())?;
    let mut order: Vec<usize> = (0..items.len()).collect();
    let mut merged = Vec::with_capacity(items.len());
    let mut width = 1;
    while width < order.len() {
        merged.clear();
        for run in order.chunks(2 * width) {
            let (left, right) = run.split_at(width.min(run.len()));
            merge(left, right, &mut merged, |a, b| goes_before(interpreter, &items[a], &items[b], function))?;
        }
        std::mem::swap(&mut order, &mut merged);
        width *= 2;
    }
    if function.is_some() {
        check(interpreter, items, &order, function)?;
    }
    let mut old: Vec<Data> = std::mem::take(items);
    items.extend(order.iter().map(|index| std::mem::take(&mut old[*index])));
    Ok(())
}

/// Asks a function about neighbours once more: the second must not go before the first, unless the first goes before the
/// second as well, as equal ones do to a function that says `a <= b`.
fn check(interpreter: &mut Interpreter, items: &[Data], order: &[usize], function: Option<&Data>) -> Result<(), Stop> {
    for (a, b) in order.iter().zip(order.iter().skip(1)) {
        if goes_before(interpreter, &items[*b], &items[*a], function)?
            && !goes_before(interpreter, &items[*a], &items[*b], function)?
        {
            return Err(fail(
                "sort's function contradicts itself: of the same two values now one goes first, now the other",
            ));
        }
    }
    Ok(())
}

/// Appends two sorted runs as one: an item of the right one goes first only where it must.
fn merge(
    left: &[usize],
    right: &[usize],
    merged: &mut Vec<usize>,
    mut goes_before: impl FnMut(usize, usize) -> Result<bool, Stop>,
) -> Result<(), Stop> {
    let (mut left, mut right) = (left, right);
    while let ([a, left_rest @ ..], [b, right_rest @ ..]) = (left, right) {
        if goes_before(*b, *a)? {
            merged.push(*b);
            right = right_rest;
        } else {
            merged.push(*a);
            left = left_rest;
        }
    }
    merged.extend_from_slice(left);
    merged.extend_from_slice(right);
    Ok(())
}

fn goes_before(interpreter: &mut Interpreter, a: &Data, b: &Data, function: Option<&Data>) -> Result<bool, Stop> {
    // The step of the merge itself.
    interpreter.meter.charge(2)?;
    let Some(function) = function else {
        let order = a.order(b, interpreter.meter)?;
        let unfit = || fail(format!("a {} and a {} have no order", a.type_name(), b.type_name()));
        return Ok(order.ok_or_else(unfit)?.is_lt());
    };
    let Data::Function(number) = function else { return Err(fail("sort takes a function of two values")) };
    let arguments = vec![a.copy(interpreter.meter)?, b.copy(interpreter.meter)?];
    match interpreter.call(*number, arguments, None)? {
        Data::Bool(before) => Ok(before),
        Data::Int(sign) => Ok(sign < 0),
        other => Err(fail(format!("sort's function must give true, false or a number, not a {}", other.type_name()))),
    }
}

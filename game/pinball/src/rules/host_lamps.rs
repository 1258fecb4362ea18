//! The functions by which a script commands lamps.

use super::host_function::Searched::Lamps;
use super::host_function::{Arguments, HostFunction, ScriptContext, function, time_ms};
use super::script::Data;
use crate::lamps::{LampEffect, Mode, TimedOverride};

pub static FUNCTIONS: [HostFunction; 4] = [
    function("lamp", (2, 4), Lamps, |context, arguments| {
        let name = arguments.text(0)?;
        if arguments.count() == 2 && arguments.is_int(1) {
            let mode = Mode::Steady(permille(arguments.int(1)?)?);
            return set(context, name, LampEffect { mode, ..LampEffect::OFF });
        }
        let period = (arguments.count() > 2).then(|| arguments.int(2)).transpose()?;
        let shift = if arguments.count() > 3 { arguments.int(3)? } else { 0 };
        set(context, name, effect(arguments.text(1)?, period, shift)?)
    }),
    function("lamp_color", (1, 2), Lamps, |context, arguments| {
        let color = color(arguments, 1)?;
        for lamp in context.names.lamps(arguments.text(0)?)? {
            context.lamps.paint(lamp, color);
        }
        Ok(Data::Unit)
    }),
    function("flash", (2, 3), Lamps, |context, arguments| {
        let effect = effect("on", None, 0)?;
        override_lamps(context, arguments.text(0)?, effect, arguments.int(1)?, color(arguments, 2)?)
    }),
    function("show", (5, 6), Lamps, |context, arguments| {
        let effect = effect(arguments.text(1)?, Some(arguments.int(2)?), arguments.int(3)?)?;
        override_lamps(context, arguments.text(0)?, effect, arguments.int(4)?, color(arguments, 5)?)
    }),
];

fn set(context: &mut ScriptContext, name: &str, effect: LampEffect) -> Result<Data, String> {
    for lamp in context.names.lamps(name)? {
        context.lamps.set(lamp, effect);
    }
    Ok(Data::Unit)
}

fn override_lamps(
    context: &mut ScriptContext,
    name: &str,
    mut effect: LampEffect,
    ms: i64,
    color: Option<[u8; 3]>,
) -> Result<Data, String> {
    let delay = std::mem::take(&mut effect.shift_ms);
    let since = context.script.now + u64::from(delay);
    let until = since + time_ms(ms)?;
    for lamp in context.names.lamps(name)? {
        context.lamps.set_override(lamp, (ms > 0).then_some(TimedOverride { effect, color, since, until }));
    }
    Ok(Data::Unit)
}

/// What a lamp does in this mode.
///
/// # Errors
/// A sentence if there is no such mode or time.
pub fn effect(mode: &str, period: Option<i64>, shift: i64) -> Result<LampEffect, String> {
    let unknown = || format!("a lamp cannot do \"{mode}\"; it can do {}", Mode::NAMES.join(", "));
    let mode = Mode::named(mode).ok_or_else(unknown)?;
    let period_ms = match period {
        None => mode.usual_period_ms(),
        Some(period) => time_ms(period)?.max(1) as u32,
    };
    Ok(LampEffect { mode, period_ms, shift_ms: time_ms(shift)? as u32 })
}

fn permille(level: i64) -> Result<u16, String> {
    match u16::try_from(level) {
        Ok(level) if level <= 1000 => Ok(level),
        _ => Err(format!("a lamp's level is from 0 to 1000, not {level}")),
    }
}

/// The colour `#rrggbb` at this place, if there is one.
fn color(arguments: &Arguments, place: usize) -> Result<Option<[u8; 3]>, String> {
    if arguments.count() <= place {
        return Ok(None);
    }
    read_color(arguments.text(place)?).map(Some)
}

/// Whether this is a colour.
///
/// # Errors
/// A sentence if not.
pub fn check_color(text: &str) -> Result<(), String> {
    read_color(text).map(|_| ())
}

fn read_color(text: &str) -> Result<[u8; 3], String> {
    let wrong = || format!("a colour is written \"#rrggbb\", not \"{text}\"");
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6).ok_or_else(wrong)?;
    if !digits.chars().all(|digit| digit.is_ascii_hexdigit()) {
        return Err(wrong());
    }
    let number = u32::from_str_radix(digits, 16).map_err(|_| wrong())?;
    let [_, red, green, blue] = number.to_be_bytes();
    Ok([red, green, blue])
}

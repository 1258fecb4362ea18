//! Goes along a chain, `a.b[c].d(e)`, in place: only what stands at its end is copied.

use super::data::Data;
use super::interpreter::{Frame, Interpreter};
use super::node::{Step, StepKind};
use super::place::{self, Key};
use super::stop::{Answer, Stop, fail};

/// What a step is given, evaluated before the chain is entered.
pub enum Given {
    /// A property's name, or an index.
    Key(Key),
    /// A call's arguments.
    Arguments(Vec<Data>),
}

impl Interpreter<'_> {
    /// What the steps are given, in the order of the script.
    ///
    /// # Errors
    /// If one cannot be evaluated.
    pub fn given(&mut self, steps: &[Step], frame: &mut Frame) -> Result<Vec<Given>, Stop> {
        let mut all = Vec::with_capacity(steps.len());
        for step in steps {
            self.meter.charge(1)?;
            all.push(match &step.kind {
                StepKind::Property(name) => Given::Key(Key::Property(name.clone())),
                StepKind::Index(index) => Given::Key(Key::Index(self.eval(index, frame)?)),
                StepKind::Script(_, nodes)
                | StepKind::Library(_, nodes)
                | StepKind::Host(_, nodes)
                | StepKind::Call(nodes) => Given::Arguments(self.values(nodes, frame)?),
            });
        }
        Ok(all)
    }

    /// The keys of a place: of steps that are properties and indices.
    ///
    /// # Errors
    /// If one cannot be evaluated, or is a call.
    pub fn keys(&mut self, steps: &[Step], frame: &mut Frame) -> Result<Vec<Key>, Stop> {
        let given = self.given(steps, frame)?.into_iter();
        let key = |given| match given {
            Given::Key(key) => Ok(key),
            Given::Arguments(_) => Err(fail("what a function gives cannot be changed: put it into a variable first")),
        };
        given.map(key).collect()
    }

    /// The value at the end of the steps from a place.
    ///
    /// # Errors
    /// Why there is none.
    pub fn follow(&mut self, place: &mut Data, steps: &[Step], given: Vec<Given>) -> Answer {
        let mut given = given.into_iter();
        let mut place = place;
        for (index, step) in steps.iter().enumerate() {
            if step.stops_at_unit && matches!(place, Data::Unit) {
                return Ok(Data::Unit);
            }
            match given.next() {
                Some(Given::Key(key)) => {
                    match place::enter_mut(place, &key, self.meter).map_err(|e| e.at(step.line))? {
                        place::Found::Place(next) => place = next,
                        place::Found::Value(value) => {
                            return self.follow_value(value, &steps[index + 1..], given.collect());
                        }
                    }
                }
                Some(Given::Arguments(arguments)) => {
                    let value = self.step(place, step, arguments).map_err(|stop| stop.at(step.line))?;
                    return self.follow_value(value, &steps[index + 1..], given.collect());
                }
                None => break,
            }
        }
        place.copy(self.meter)
    }

    /// The value at the end of the steps from a value that has no place.
    ///
    /// # Errors
    /// Why there is none.
    pub fn follow_value(&mut self, mut value: Data, steps: &[Step], given: Vec<Given>) -> Answer {
        if steps.is_empty() { Ok(value) } else { self.follow(&mut value, steps, given) }
    }

    /// The value at the end of the steps from a constant: what would change it gets a copy, or is refused.
    ///
    /// # Errors
    /// Why there is none.
    pub fn follow_constant(&mut self, constant: &Data, steps: &[Step], given: Vec<Given>) -> Answer {
        let mut given = given.into_iter();
        let mut place = constant;
        for (index, step) in steps.iter().enumerate() {
            if step.stops_at_unit && matches!(place, Data::Unit) {
                return Ok(Data::Unit);
            }
            let value = match (given.next(), &step.kind) {
                (Some(Given::Key(key)), _) => {
                    match place::enter(place, &key, self.meter).map_err(|e| e.at(step.line))? {
                        place::Found::Place(next) => {
                            place = next;
                            continue;
                        }
                        place::Found::Value(value) => value,
                    }
                }
                (Some(Given::Arguments(arguments)), StepKind::Library(function, _)) => {
                    function.call_on_constant(self, place, arguments).map_err(|stop| stop.at(step.line))?
                }
                (Some(Given::Arguments(arguments)), _) => {
                    let mut copy = place.copy(self.meter).map_err(|stop| stop.at(step.line))?;
                    self.step(&mut copy, step, arguments).map_err(|stop| stop.at(step.line))?
                }
                (None, _) => break,
            };
            return self.follow_value(value, &steps[index + 1..], given.collect());
        }
        place.copy(self.meter)
    }

    /// Calls what a step calls.
    fn step(&mut self, place: &mut Data, step: &Step, arguments: Vec<Data>) -> Answer {
        match &step.kind {
            StepKind::Script(number, _) => self.call(*number, arguments, Some(place)),
            StepKind::Library(function, _) => function.call(self, place, arguments),
            StepKind::Host(function, _) => {
                let mut all = vec![place.copy(self.meter)?];
                all.extend(arguments);
                self.call_host(function, &all)
            }
            StepKind::Call(_) => match place {
                Data::Function(number) => self.call(*number, arguments, None),
                other => Err(fail(format!("a function can be called, a {} cannot", other.type_name()))),
            },
            StepKind::Property(_) | StepKind::Index(_) => Err(fail("this is not a call")),
        }
    }
}

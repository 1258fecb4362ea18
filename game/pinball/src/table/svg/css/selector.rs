//! Which elements of a drawing a selector means: the words that the library of browsers' selectors asks for.

use cssparser::{ParseError, Parser, ToCss};
use precomputed_hash::PrecomputedHash;
use roxmltree::{Node, NodeId};
use selectors::attr::{
    AttrSelectorOperation, AttrSelectorOperator, CaseSensitivity, NamespaceConstraint, ParsedCaseSensitivity,
};
use selectors::bloom::BloomFilter;
use selectors::matching::{
    self, ElementSelectorFlags, MatchingContext, MatchingForInvalidation, MatchingMode, NeedsSelectorFlags, QuirksMode,
    SelectorCaches,
};
use selectors::parser::{self, Combinator, Component, ParseRelative, Selector, SelectorList, SelectorParseErrorKind};
use selectors::{Element, OpaqueElement};
use std::fmt;

/// A list of selectors, as a rule begins with.
pub(super) type Selectors = SelectorList<Svg>;

/// Reads a list of selectors.
pub(super) fn read(input: &mut Parser) -> Result<Selectors, ParseError<()>> {
    SelectorList::parse(&SelectorParser, input, ParseRelative::No).map_err(|_| ParseError::custom(()))
}

/// The greatest specificity of those of `selectors` that mean the element, if any does; each of them is noted in `used`.
pub(super) fn specificity(
    selectors: &Selectors,
    element: Instance,
    caches: &mut SelectorCaches,
    used: &mut [bool],
) -> Option<u32> {
    let mut context = MatchingContext::new(
        MatchingMode::Normal,
        None,
        caches,
        QuirksMode::NoQuirks,
        NeedsSelectorFlags::No,
        MatchingForInvalidation::No,
    );
    let mut greatest = None;
    for (selector, used) in selectors.slice().iter().zip(used) {
        if matching::matches_selector(selector, 0, None, element, &mut context) {
            *used = true;
            greatest = greatest.max(Some(selector.specificity()));
        }
    }
    greatest
}

/// The words of a selector, by what they name.
#[derive(Default)]
pub(super) struct Words {
    pub classes: Vec<String>,
    pub ids: Vec<String>,
    pub elements: Vec<String>,
}

/// What a selector names, and cannot do without: of what is beside or around an element too, and of its attributes; of the
/// selectors in it only those that have no other choice.
pub(super) fn words(selector: &Selector<Svg>) -> Words {
    let mut words = Words::default();
    words.add(selector);
    words
}

impl Words {
    fn add(&mut self, selector: &Selector<Svg>) {
        for part in selector.iter_raw_match_order() {
            match part {
                Component::Class(word) => self.classes.push(word.0.clone()),
                Component::ID(word) => self.ids.push(word.0.clone()),
                Component::LocalName(word) => self.elements.push(word.name.0.clone()),
                Component::AttributeInNoNamespace { local_name, operator, value, case_sensitivity }
                    if *case_sensitivity != ParsedCaseSensitivity::AsciiCaseInsensitive =>
                {
                    match (local_name.0.as_str(), operator) {
                        ("id", AttrSelectorOperator::Equal) => self.ids.push(value.0.clone()),
                        ("class", AttrSelectorOperator::Equal | AttrSelectorOperator::Includes) => {
                            self.classes.extend(value.0.split_ascii_whitespace().map(str::to_string));
                        }
                        _ => {}
                    }
                }
                Component::Is(list) | Component::Where(list) => {
                    if let [only] = list.slice() {
                        self.add(only);
                    }
                }
                _ => {}
            }
        }
    }
}

/// How far a selector may look around an element.
#[derive(Clone, Copy)]
pub(super) struct Around {
    /// Elements beside it.
    pub beside: usize,
    /// Elements that it lies in.
    pub above: usize,
}

/// How many comparisons it takes at most to find whether a selector means an element.
pub(super) fn comparisons(selector: &Selector<Svg>, around: Around) -> usize {
    let sum = |all: usize, one: usize| all.saturating_add(one);
    let each = selector.iter_raw_match_order().map(|part| {
        let inner = inner(part).iter().map(|inner| comparisons(inner, around).saturating_mul(around.above));
        inner.fold(1, sum)
    });
    let is_beside = selector.iter_raw_match_order().any(looks_beside);
    each.fold(0, sum).saturating_mul(if is_beside { around.beside } else { 1 })
}

/// The selectors in a part of a selector.
fn inner(part: &Component<Svg>) -> &[Selector<Svg>] {
    match part {
        Component::Is(list) | Component::Where(list) | Component::Negation(list) => list.slice(),
        Component::NthOf(nth) => nth.selectors(),
        _ => &[],
    }
}

/// Whether a part of a selector is looked for among all elements beside one.
fn looks_beside(part: &Component<Svg>) -> bool {
    matches!(part, Component::Combinator(Combinator::LaterSibling) | Component::Nth(_) | Component::NthOf(_))
}

/// An element where it is drawn: where it stands, or in the copy that a `<use>` makes of it or of what is around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instance<'a, 'i> {
    pub node: Node<'a, 'i>,
    /// What the `<use>` copies. In a copy nothing is around it: selectors look no farther (SVG 2, 5.6.1).
    pub root: Option<NodeId>,
}

impl<'a, 'i> Instance<'a, 'i> {
    fn is_copied(&self) -> bool {
        self.root == Some(self.node.id())
    }

    fn beside(&self, node: Option<Node<'a, 'i>>) -> Option<Self> {
        let node = node.filter(|_| !self.is_copied())?;
        Some(Instance { node, root: self.root })
    }
}

impl Element for Instance<'_, '_> {
    type Impl = Svg;

    fn opaque(&self) -> OpaqueElement {
        // No two elements begin at one byte.
        OpaqueElement::new(&self.node.document().input_text().as_bytes()[self.node.range().start])
    }

    fn parent_element(&self) -> Option<Self> {
        self.beside(self.node.parent_element())
    }

    fn parent_node_is_shadow_root(&self) -> bool {
        self.is_copied()
    }

    fn containing_shadow_host(&self) -> Option<Self> {
        None
    }

    fn is_pseudo_element(&self) -> bool {
        false
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.beside(self.node.prev_sibling_element())
    }

    fn next_sibling_element(&self) -> Option<Self> {
        self.beside(self.node.next_sibling_element())
    }

    fn first_element_child(&self) -> Option<Self> {
        let node = self.node.first_element_child()?;
        Some(Instance { node, root: self.root })
    }

    fn is_html_element_in_html_document(&self) -> bool {
        false
    }

    fn has_local_name(&self, name: &Word) -> bool {
        self.node.tag_name().name() == name.0
    }

    fn has_namespace(&self, namespace: &Word) -> bool {
        self.node.tag_name().namespace().unwrap_or("") == namespace.0
    }

    fn is_same_type(&self, other: &Self) -> bool {
        self.node.tag_name() == other.node.tag_name()
    }

    fn attr_matches(
        &self,
        namespace: &NamespaceConstraint<&Word>,
        name: &Word,
        operation: &AttrSelectorOperation<&Word>,
    ) -> bool {
        self.node.attributes().any(|attribute| {
            let there = match namespace {
                NamespaceConstraint::Any => true,
                NamespaceConstraint::Specific(wanted) => attribute.namespace().unwrap_or("") == wanted.0,
            };
            there && attribute.name() == name.0 && operation.eval_str(attribute.value())
        })
    }

    fn match_non_ts_pseudo_class(&self, _: &StateClass, _: &mut MatchingContext<Svg>) -> bool {
        false
    }

    fn match_pseudo_element(&self, element: &PseudoElement, _: &mut MatchingContext<Svg>) -> bool {
        match *element {}
    }

    fn apply_selector_flags(&self, _: ElementSelectorFlags) {}

    fn is_link(&self) -> bool {
        false
    }

    fn is_html_slot_element(&self) -> bool {
        false
    }

    fn has_id(&self, id: &Word, case: CaseSensitivity) -> bool {
        self.node.attribute("id").is_some_and(|own| case.eq(own.as_bytes(), id.0.as_bytes()))
    }

    fn has_class(&self, name: &Word, case: CaseSensitivity) -> bool {
        let classes = self.node.attribute("class").unwrap_or("");
        classes.split_ascii_whitespace().any(|class| case.eq(class.as_bytes(), name.0.as_bytes()))
    }

    fn has_custom_state(&self, _: &Word) -> bool {
        false
    }

    fn imported_part(&self, _: &Word) -> Option<Word> {
        None
    }

    fn is_part(&self, _: &Word) -> bool {
        false
    }

    fn is_empty(&self) -> bool {
        self.node.children().all(|child| !child.is_element() && child.text().unwrap_or("").is_empty())
    }

    fn is_root(&self) -> bool {
        self.node.parent_element().is_none()
    }

    fn add_element_unique_hashes(&self, _: &mut BloomFilter) -> bool {
        false
    }
}

/// What selectors are made of in a drawing: words. A drawing is a still picture, so no pointer is over an element and
/// nothing comes before it.
#[derive(Clone, Debug)]
pub(crate) struct Svg;

impl parser::SelectorImpl for Svg {
    type ExtraMatchingData<'a> = ();
    type AttrValue = Word;
    type Identifier = Word;
    type LocalName = Word;
    type NamespaceUrl = Word;
    type NamespacePrefix = Word;
    type BorrowedNamespaceUrl = Word;
    type BorrowedLocalName = Word;
    type NonTSPseudoClass = StateClass;
    type PseudoElement = PseudoElement;
}

struct SelectorParser;

impl<'i> parser::Parser<'i> for SelectorParser {
    type Impl = Svg;
    type Error = SelectorParseErrorKind;

    fn parse_is_and_where(&self) -> bool {
        true
    }

    fn parse_nth_child_of(&self) -> bool {
        true
    }

    fn parse_non_ts_pseudo_class(&self, name: &str) -> Result<StateClass, ParseError<SelectorParseErrorKind>> {
        let known = STATES.iter().find(|state| state.eq_ignore_ascii_case(name));
        known
            .map(|state| StateClass(state))
            .ok_or_else(|| ParseError::custom(SelectorParseErrorKind::UnsupportedPseudoClassOrElement))
    }
}

/// A word of a selector.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Word(String);

impl From<&str> for Word {
    fn from(word: &str) -> Word {
        Word(word.to_string())
    }
}

impl AsRef<str> for Word {
    fn as_ref(&self) -> &str {
        &self.0
    }
}

impl ToCss for Word {
    fn to_css<W: fmt::Write>(&self, out: &mut W) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl PrecomputedHash for Word {
    fn precomputed_hash(&self) -> u32 {
        // Of filters that are not used here; FNV-1a, for the trait's sake.
        self.0.bytes().fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
    }
}

/// States that an element of a page may be in, and one of a drawing never is.
const STATES: [&str; 9] =
    ["hover", "active", "focus", "focus-visible", "focus-within", "link", "visited", "any-link", "target"];

/// A class like `:hover`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StateClass(&'static str);

impl parser::NonTSPseudoClass for StateClass {
    fn is_active_or_hover(&self) -> bool {
        matches!(self.0, "active" | "hover")
    }

    fn is_user_action_state(&self) -> bool {
        matches!(self.0, "active" | "hover" | "focus" | "focus-visible" | "focus-within")
    }
}

impl ToCss for StateClass {
    fn to_css<W: fmt::Write>(&self, out: &mut W) -> fmt::Result {
        write!(out, ":{}", self.0)
    }
}

/// An element like `::before`: there is none in a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum PseudoElement {}

impl parser::PseudoElement for PseudoElement {}

impl ToCss for PseudoElement {
    fn to_css<W: fmt::Write>(&self, _: &mut W) -> fmt::Result {
        match *self {}
    }
}

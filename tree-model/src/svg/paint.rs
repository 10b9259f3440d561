//! What a shape of an SVG drawing is painted with: its own attributes and style, or its groups'.

use roxmltree::Node;
use std::collections::BTreeMap;
use std::str::FromStr;

/// Longest chain of gradients that take their colours from one another.
const MAX_CHAIN: u32 = 8;

/// Opacity below which nothing is seen.
const UNSEEN: f64 = 0.01;

/// What an area or a line is covered with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// A colour (red, green, blue), or the mean of a gradient's.
    Plain([u8; 3]),
    /// A pattern, or something unknown.
    Texture,
}

/// Fill and stroke; `None` where there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Paint {
    pub(crate) fill: Option<Ink>,
    pub(crate) stroke: Option<Ink>,
    /// The value of `currentColor`.
    current: [u8; 3],
    /// Whether it or a group it is in is fully transparent.
    unseen: bool,
}

impl Default for Paint {
    /// As SVG has it: a black fill and no stroke.
    fn default() -> Self {
        let black = [0; 3];
        Self { fill: Some(Ink::Plain(black)), stroke: None, current: black, unseen: false }
    }
}

impl Paint {
    /// The paint of an element in a group that has this paint. What cannot be read is as if it were not there.
    pub(super) fn within(&self, node: Node<'_, '_>, inks: &Inks) -> Self {
        let zero = |name: &str| property(node, name).and_then(number).is_some_and(|n| n < UNSEEN);
        let mut paint = *self;
        if let Some(color) = property(node, "color").and_then(plain) {
            paint.current = color;
        }
        paint.unseen |= zero("opacity");
        paint.fill = inks.resolve(property(node, "fill"), self.fill, paint.current);
        paint.stroke = inks.resolve(property(node, "stroke"), self.stroke, paint.current);
        if zero("fill-opacity") {
            paint.fill = None;
        }
        if zero("stroke-opacity") || property(node, "stroke-width").and_then(number) == Some(0.0) {
            paint.stroke = None;
        }
        paint
    }

    /// Whether anything is seen of it.
    pub(crate) fn is_seen(&self) -> bool {
        !self.unseen && (self.fill.is_some() || self.stroke.is_some())
    }
}

/// The gradients of a drawing by id: their mean colour, or `None` where they fade out to nothing, as shadows do.
pub(super) struct Inks(BTreeMap<String, Option<Ink>>);

impl Inks {
    pub(super) fn of(root: Node<'_, '_>) -> Self {
        let gradients: BTreeMap<&str, Node<'_, '_>> = root
            .descendants()
            .filter(|n| matches!(n.tag_name().name(), "linearGradient" | "radialGradient"))
            .filter_map(|n| Some((n.attribute("id")?, n)))
            .collect();
        let ink = |(&id, &node): (&&str, &Node<'_, '_>)| {
            let mut holder = node;
            for _ in 0..MAX_CHAIN {
                if holder.children().any(|child| child.tag_name().name() == "stop") {
                    break;
                }
                let link = holder.attributes().find(|a| a.name() == "href");
                let link = link.and_then(|a| gradients.get(a.value().trim_start_matches('#')));
                let Some(&next) = link else { break };
                holder = next;
            }
            (id.to_string(), mean(holder))
        };
        Self(gradients.iter().map(ink).collect())
    }

    fn resolve(&self, text: Option<&str>, outer: Option<Ink>, current: [u8; 3]) -> Option<Ink> {
        use svgtypes::Paint as P;
        let Some(text) = text else { return outer };
        match P::from_str(text) {
            Ok(P::None) => None,
            Ok(P::CurrentColor) => Some(Ink::Plain(current)),
            Ok(P::Color(c)) => (c.alpha > 0).then_some(Ink::Plain([c.red, c.green, c.blue])),
            Ok(P::FuncIRI(id, _)) => self.0.get(id).copied().unwrap_or(Some(Ink::Texture)),
            Ok(P::ContextFill | P::ContextStroke) => Some(Ink::Texture),
            Ok(P::Inherit) | Err(_) => outer,
        }
    }
}

/// The mean colour of a gradient's stops; `None` where one of them is fully transparent.
fn mean(gradient: Node<'_, '_>) -> Option<Ink> {
    let mut sum = [0_u32; 3];
    let mut n = 0;
    for stop in gradient.children().filter(|child| child.tag_name().name() == "stop") {
        if property(stop, "stop-opacity").and_then(number).is_some_and(|n| n < UNSEEN) {
            return None;
        }
        let color = property(stop, "stop-color").and_then(plain).unwrap_or([0; 3]);
        sum = std::array::from_fn(|i| sum[i] + u32::from(color[i]));
        n += 1;
    }
    if n == 0 {
        return Some(Ink::Texture);
    }
    Some(Ink::Plain(sum.map(|channel| (channel / n) as u8)))
}

fn plain(text: &str) -> Option<[u8; 3]> {
    svgtypes::Color::from_str(text).ok().map(|c| [c.red, c.green, c.blue])
}

/// A number, also with a percent sign or a unit of pixels.
fn number(text: &str) -> Option<f64> {
    let share = text.strip_suffix('%').map(|text| (text, 0.01));
    let (text, factor) = share.unwrap_or((text.trim_end_matches("px"), 1.0));
    text.trim().parse::<f64>().ok().map(|n| n * factor)
}

/// A presentation property: from `style` or else the attribute of this name.
pub(super) fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let style = node.attribute("style").unwrap_or("");
    let mut declarations = style.rsplit(';').filter_map(|part| part.split_once(':'));
    let styled = declarations.find(|(key, _)| key.trim().eq_ignore_ascii_case(name));
    let value = styled.map(|(_, value)| value).or_else(|| node.attribute(name))?;
    Some(value.trim().trim_end_matches("!important").trim())
}

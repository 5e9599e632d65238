//! Damage: changed values of saved data.

use super::tree::Tree;

/// Variants of all enums of the engine without data, and an unknown one.
const VARIANTS: [&str; 22] = [
    "Enabled",
    "Disabled",
    "DisabledByParent",
    "DisabledByAttachedBody",
    "Dynamic",
    "Fixed",
    "Kinematic",
    "KinematicPositionBased",
    "KinematicVelocityBased",
    "Average",
    "Min",
    "Max",
    "Multiply",
    "And",
    "Or",
    "LinX",
    "LinY",
    "AngX",
    "AccelerationBased",
    "ForceBased",
    "Density",
    "Unheard",
];

/// Returns the changed versions of a value.
pub fn changes(tree: &Tree) -> Vec<Tree> {
    match tree {
        Tree::Unit => vec![Tree::Some(Box::new(Tree::Unsigned(0)))],
        Tree::Bool(value) => vec![Tree::Bool(!value)],
        Tree::Unsigned(value) => {
            let max = [u128::from(u32::MAX), u128::from(u64::MAX)];
            let near = [value.wrapping_add(1), value.wrapping_sub(1)];
            let numbers =
                [0, 1, max[0], max[0] - 1, max[1], near[0], near[1], value ^ 0x10, value ^ 2];
            numbers.into_iter().filter(|number| number != value).map(Tree::Unsigned).collect()
        }
        Tree::Signed(value) => [0, -1, i128::from(i32::MIN), i128::from(i32::MAX), value + 1]
            .into_iter()
            .map(Tree::Signed)
            .collect(),
        Tree::Float(value) => {
            let single = f64::from(f32::MAX);
            [
                0.0,
                -1.0,
                f64::NAN,
                f64::INFINITY,
                f64::NEG_INFINITY,
                single,
                -single,
                2.0 * value,
                -value,
            ]
            .into_iter()
            .map(Tree::Float)
            .collect()
        }
        Tree::Text(name) => {
            let others = VARIANTS.into_iter().filter(|other| other != name);
            others.map(|other| Tree::Text(other.into())).collect()
        }
        Tree::Some(_) => vec![Tree::Unit],
        Tree::List(items) => changed_lists(items),
        Tree::Map(_) | Tree::Variant(..) => Vec::new(),
    }
}

fn changed_lists(items: &[Tree]) -> Vec<Tree> {
    let Some(first) = items.first() else { return Vec::new() };
    let (mut longer, mut turned) = (items.to_vec(), items.to_vec());
    longer.push(first.clone());
    turned.reverse();
    [items[1..].to_vec(), items[..items.len() - 1].to_vec(), Vec::new(), longer, turned]
        .map(Tree::List)
        .to_vec()
}

/// Calls `visit_one` for each value of a tree, from the root down. The path identifies the value.
pub fn visit(tree: &mut Tree, path: &str, visit_one: &mut impl FnMut(&mut Tree, &str)) {
    visit_one(tree, path);
    match tree {
        Tree::Some(inner) => visit(inner, path, visit_one),
        Tree::Variant(name, inner) => visit(inner, &format!("{path}.{name}"), visit_one),
        Tree::List(items) => {
            let items = items.iter_mut().enumerate();
            items.for_each(|(at, item)| visit(item, &format!("{path}[{at}]"), visit_one));
        }
        Tree::Map(entries) => entries.iter_mut().for_each(|(key, value)| {
            let key = match key {
                Tree::Text(key) => key.clone(),
                other => format!("{other:?}"),
            };
            visit(value, &format!("{path}.{key}"), visit_one);
        }),
        _ => {}
    }
}

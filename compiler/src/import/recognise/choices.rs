//! Choices of PDOs that a file gives names to: configurations of a description.

use super::super::read::Alternative;
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::clocks::Carriers;
use super::draft::Block;
use crate::model::Role;
use crate::model::ids::Siblings;

/// `[configurations]`, one for each choice.
pub(super) fn configurations(
    alternatives: &[Alternative],
    carriers: &Carriers<'_>,
    ids: &mut Siblings,
    report: &mut Report,
) -> Vec<Block> {
    let mut blocks = Vec::new();
    for alternative in alternatives {
        match keys(alternative, carriers) {
            Ok(keys) => {
                let id = ids.claim(&alternative.name);
                blocks.push(Block::new("configurations", Some(id), keys));
            }
            Err(why) => {
                let what = format!("AlternativeSmMapping `{}`", alternative.name);
                report.lose(alternative.at, alternative.facts, what, why);
            }
        }
    }
    blocks
}

/// What is assigned to outputs and inputs; or why a configuration cannot say it.
fn keys(alternative: &Alternative, carriers: &Carriers<'_>) -> Result<Keys, &'static str> {
    let mut keys = Keys::new();
    set(&mut keys, "name", Toml::text(&alternative.name));
    for (role, key) in [(Role::Outputs, "outputs"), (Role::Inputs, "inputs")] {
        let of_role = |number: u8| {
            carriers.managers.iter().find(|it| it.number == number).is_some_and(|it| it.role == role)
        };
        let mut assigned = alternative.managers.iter().filter(|(number, _)| of_role(*number));
        let Some((number, pdos)) = assigned.next() else { continue };
        if assigned.next().is_some() {
            return Err("it chooses for several sync managers of a direction");
        }
        let known = carriers.carried(*number);
        if pdos.iter().any(|index| !known.iter().any(|pdo| pdo.index == *index)) {
            return Err("it names a PDO that is not there");
        }
        set(&mut keys, key, Toml::texts(pdos.iter().map(|index| format!("0x{index:04X}"))));
    }
    Ok(keys)
}

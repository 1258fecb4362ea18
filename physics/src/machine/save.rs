//! The state as bytes, and its fingerprints.

use crate::machine::Hashes;
use crate::machine::fingerprint::fingerprint;
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::rigid_mechanisms::RigidMechanisms;
use xxhash_rust::xxh3::xxh3_64;

/// Raised whenever the bytes mean something else.
const VERSION: u8 = 2;
/// Version, fingerprint of the layout, fingerprint of what follows.
const HEAD: usize = 1 + 8 + 8;

pub(crate) fn hashes(state: &State, rigid: &RigidMechanisms) -> Hashes {
    Hashes { balls: fingerprint(&state.balls), mechanisms: fingerprint(&(&state.mechanisms, rigid.motion())) }
}

/// The bytes of a machine whose layout has the fingerprint `layout`.
pub(crate) fn write(layout: u64, state: &State, rigid: &RigidMechanisms) -> Vec<u8> {
    let body = postcard::to_stdvec(&(state, rigid.save())).unwrap_or_default();
    let mut bytes = vec![VERSION];
    bytes.extend(layout.to_le_bytes());
    bytes.extend(xxh3_64(&body).to_le_bytes());
    bytes.extend(body);
    bytes
}

/// What [`write`] wrote for this model, whose layout has the fingerprint `layout`.
pub(crate) fn read(layout: u64, model: &Model, bytes: &[u8]) -> Result<(State, RigidMechanisms), String> {
    let (head, body) = bytes.split_at_checked(HEAD).ok_or("the saved machine is cut off")?;
    if head[0] != VERSION {
        return Err(format!("the saved machine has version {}, this one has {VERSION}", head[0]));
    }
    if head[1..9] != layout.to_le_bytes() {
        return Err("the machine was saved on another layout".into());
    }
    if head[9..] != xxh3_64(body).to_le_bytes() {
        return Err("the saved machine is damaged".into());
    }
    let (state, rigid): (State, Vec<u8>) =
        postcard::from_bytes(body).map_err(|error| format!("the saved machine cannot be read: {error}"))?;
    let rigid = RigidMechanisms::restore(&model.mechanisms, &rigid).filter(|_| state.fits(model));
    let rigid = rigid.ok_or("the saved machine has other parts than this layout")?;
    Ok((state, rigid))
}

//! What has the same key together.

use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Groups in the order in which their keys first come.
pub fn in_order<K: PartialEq, T>(all: impl IntoIterator<Item = (K, T)>) -> Vec<(K, Vec<T>)> {
    let mut groups: Vec<(K, Vec<T>)> = Vec::new();
    for (key, one) in all {
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, members)) => members.push(one),
            None => groups.push((key, vec![one])),
        }
    }
    groups
}

/// Keys once each with the number of times that they come, in the order in which they first come.
pub fn counted<K: PartialEq>(all: impl IntoIterator<Item = K>) -> Vec<(K, usize)> {
    in_order(all.into_iter().map(|key| (key, ()))).into_iter().map(|(key, members)| (key, members.len())).collect()
}

/// Groups in the order of their keys.
pub fn sorted<K: Ord, T>(all: impl IntoIterator<Item = (K, T)>) -> BTreeMap<K, Vec<T>> {
    let mut groups: BTreeMap<K, Vec<T>> = BTreeMap::new();
    for (key, one) in all {
        groups.entry(key).or_default().push(one);
    }
    groups
}

/// Groups, the largest first, those of one size in the order of their keys.
pub fn largest_first<K: Ord, T>(all: impl IntoIterator<Item = (K, T)>) -> Vec<(K, Vec<T>)> {
    let mut groups: Vec<(K, Vec<T>)> = sorted(all).into_iter().collect();
    groups.sort_by_key(|(_, members)| Reverse(members.len()));
    groups
}

/// Two versions by key, side by side; none where a version has no such key.
pub fn joined<K: Ord, V>(versions: [impl IntoIterator<Item = (K, V)>; 2]) -> BTreeMap<K, [Option<V>; 2]> {
    let mut both: BTreeMap<K, [Option<V>; 2]> = BTreeMap::new();
    for (side, version) in versions.into_iter().enumerate() {
        for (key, one) in version {
            both.entry(key).or_insert([None, None])[side] = Some(one);
        }
    }
    both
}

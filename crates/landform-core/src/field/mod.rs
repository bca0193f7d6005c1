//! Named, typed values per node.

pub mod names;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{Error, Result};

/// The name of a field with its type, unit and meaning: a misspelt field is a compile error.
#[derive(Debug)]
pub struct Key<T> {
    /// Name in recipes and files.
    pub name: &'static str,
    /// Unit of the stored values.
    pub unit: &'static str,
    /// What it means, in a phrase.
    pub meaning: &'static str,
    kind: std::marker::PhantomData<T>,
}

impl<T> Key<T> {
    /// A key; used by [`names`] only.
    pub const fn new(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self { name, unit, meaning, kind: std::marker::PhantomData }
    }
}

/// Values of one field, of one of the types that fields may have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Values {
    /// Real numbers.
    F64(Vec<f64>),
    /// Identifiers.
    U32(Vec<u32>),
}

/// A type that fields may have.
pub trait Element: Copy + Send + Sync + 'static {
    /// The values, if they are of this type.
    fn of(values: &Values) -> Option<&Vec<Self>>;
    /// The values, if they are of this type.
    fn of_mut(values: &mut Values) -> Option<&mut Vec<Self>>;
    /// Wraps values.
    fn wrap(values: Vec<Self>) -> Values;
}

macro_rules! element {
    ($type:ty, $variant:ident) => {
        impl Element for $type {
            fn of(values: &Values) -> Option<&Vec<Self>> {
                if let Values::$variant(v) = values { Some(v) } else { None }
            }
            fn of_mut(values: &mut Values) -> Option<&mut Vec<Self>> {
                if let Values::$variant(v) = values { Some(v) } else { None }
            }
            fn wrap(values: Vec<Self>) -> Values {
                Values::$variant(values)
            }
        }
    };
}
element!(f64, F64);
element!(u32, U32);

impl Values {
    /// Number of values.
    pub fn len(&self) -> usize {
        match self {
            Self::F64(v) => v.len(),
            Self::U32(v) => v.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The values as real numbers.
    pub fn to_f64(&self) -> Vec<f64> {
        match self {
            Self::F64(v) => v.clone(),
            Self::U32(v) => v.iter().map(|&x| f64::from(x)).collect(),
        }
    }
}

/// The optional fields of a terrain, by name, in the order of their names.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Fields(BTreeMap<String, Values>);

impl Fields {
    /// The field of a key.
    ///
    /// # Errors
    /// [`Error::MissingField`], naming `needed_by`.
    pub fn get<T: Element>(&self, key: &Key<T>, needed_by: &str) -> Result<&[T]> {
        self.0.get(key.name).and_then(T::of).map(Vec::as_slice).ok_or_else(|| self.missing(key.name, needed_by))
    }

    /// The field of a name as real numbers.
    ///
    /// # Errors
    /// [`Error::MissingField`], naming `needed_by`.
    pub fn by_name(&self, name: &str, needed_by: &str) -> Result<Vec<f64>> {
        self.0.get(name).map(Values::to_f64).ok_or_else(|| self.missing(name, needed_by))
    }

    /// Puts a field, replacing one of the same name.
    pub fn insert<T: Element>(&mut self, key: &Key<T>, values: Vec<T>) {
        self.0.insert(key.name.into(), T::wrap(values));
    }

    /// Puts a field under a name that no key has: a user's own.
    pub fn insert_values(&mut self, name: &str, values: Values) {
        self.0.insert(name.into(), values);
    }

    /// Takes a field out.
    pub fn remove(&mut self, name: &str) -> Option<Values> {
        self.0.remove(name)
    }

    /// Names, sorted.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// Names and values, sorted by name.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Values)> {
        self.0.iter().map(|(n, v)| (n.as_str(), v))
    }

    fn missing(&self, name: &str, needed_by: &str) -> Error {
        Error::MissingField {
            name: name.into(),
            needed_by: needed_by.into(),
            available: std::iter::once("elevation").chain(self.names()).map(String::from).collect(),
        }
    }
}

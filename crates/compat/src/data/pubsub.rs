//! A queue of messages with several readers.

use core::marker::PhantomData;

/// A reader of the messages of a [`PubSub`].
#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Subscription<T> {
    reader: usize,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    messages: PhantomData<T>,
}

/// A queue of messages. Each message stays until all readers have acknowledged it.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct PubSub<T> {
    messages: Vec<T>,
    /// Number of removed messages.
    removed: usize,
    /// Number of messages that each reader has acknowledged.
    acknowledged: Vec<usize>,
}

impl<T> Default for PubSub<T> {
    fn default() -> Self {
        Self { messages: Vec::new(), removed: 0, acknowledged: Vec::new() }
    }
}

impl<T> PubSub<T> {
    /// A queue without messages and readers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a message. Without readers it is lost.
    pub fn publish(&mut self, message: T) {
        if !self.acknowledged.is_empty() {
            self.messages.push(message);
        }
    }

    /// Adds a reader of the messages from now on.
    pub fn subscribe(&mut self) -> Subscription<T> {
        self.acknowledged.push(self.removed + self.messages.len());
        Subscription { reader: self.acknowledged.len() - 1, messages: PhantomData }
    }

    /// The new messages of a reader, the oldest first.
    pub fn read(&self, sub: &Subscription<T>) -> impl Iterator<Item = &T> {
        self.messages[self.acknowledged[sub.reader] - self.removed..].iter()
    }

    /// One of the new messages of a reader.
    pub fn read_ith(&self, sub: &Subscription<T>, i: usize) -> Option<&T> {
        self.read(sub).nth(i)
    }

    /// Acknowledges all messages of a reader.
    pub fn ack(&mut self, sub: &Subscription<T>) {
        self.acknowledged[sub.reader] = self.removed + self.messages.len();
        let first = self.acknowledged.iter().min().copied().unwrap_or(0);
        self.messages.drain(..first - self.removed);
        self.removed = first;
    }
}

//! Twigs and leaves on any skeleton.

//! The finish, told by what it does.

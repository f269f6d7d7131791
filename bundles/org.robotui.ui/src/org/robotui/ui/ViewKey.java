package org.robotui.ui;

/**
 * A key that does something while its view has the focus, for the list of shortcuts.
 *
 * @param keys as they are written on the keyboard, such as {@code F} or {@code Ctrl+F, /}
 * @param does what they do, a short imperative
 */
public record ViewKey(String keys, String does) {}

package org.robotui.player.layout;

/** The body of a message that has none. */
public record Empty() {}

package org.robotui.player.interfaces;

/**
 * On or off.
 *
 * @param on true for on
 */
public record Switch(boolean on) {}

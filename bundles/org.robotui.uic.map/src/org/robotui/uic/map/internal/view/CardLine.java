package org.robotui.uic.map.internal.view;

/**
 * A line about what is under the pointer.
 *
 * @param text a few words
 * @param strong true where something new begins
 */
record CardLine(String text, boolean strong) {}

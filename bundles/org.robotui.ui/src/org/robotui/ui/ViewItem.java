package org.robotui.ui;

/**
 * Something that a view lists and that users look for by its name, for example a parameter.
 *
 * @param kind what it is, a noun with a capital letter, for example {@code Parameter}
 * @param name its full name
 * @param detail its type or value in a few words; empty for none
 * @param show shows it in the view, which is in front by then; display thread
 */
public record ViewItem(String kind, String name, String detail, Runnable show) {}

package org.robotui.workbench.internal.model;

/**
 * Something that the search finds and does.
 *
 * @param group where it belongs: a menu, a view, or what kind of thing it is
 * @param label what it does
 * @param keys which keys do the same, or what kind of data it is; empty for none
 * @param run does it; display thread
 */
public record SearchEntry(String group, String label, String keys, Runnable run) {}

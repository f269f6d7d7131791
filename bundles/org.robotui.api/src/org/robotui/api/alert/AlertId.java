package org.robotui.api.alert;

/**
 * Which alert of a RUIC.
 *
 * @param view the id of the view that watches
 * @param name what users call it, unique in the view
 */
public record AlertId(String view, String name) {}

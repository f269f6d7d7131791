package org.robotui.uic.diagnostics.internal.model;

/**
 * A line of the tree.
 *
 * @param key what identifies it
 * @param depth 0 at the top
 * @param label the last step of the name
 * @param group whether others are below it
 * @param open whether these are shown
 * @param level how it is, at the moment looked at
 * @param message what it says; for a group that says nothing, what is wrong below
 * @param strip how it was
 */
public record DiagnosticsRow(String key, int depth, String label, boolean group, boolean open, Level level,
    String message, Strip strip) {}

package org.robotui.xbot;

/**
 * What a supervisor answers.
 *
 * @param ok whether it did what was asked
 * @param text why not, or what it says
 */
public record Answer(boolean ok, String text) {}

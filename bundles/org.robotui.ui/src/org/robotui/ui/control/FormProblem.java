package org.robotui.ui.control;

/**
 * Something that is wrong in a form.
 *
 * @param path the field, for example {@code linear.x}
 * @param sentence what is wrong and what to write
 */
public record FormProblem(String path, String sentence) {}

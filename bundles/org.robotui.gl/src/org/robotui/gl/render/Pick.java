package org.robotui.gl.render;

import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Part;

/**
 * What was hit.
 *
 * @param display key of the display
 * @param part the part
 * @param element which of its elements
 * @param place where, in the fixed frame, metres
 */
public record Pick(Object display, Part part, int element, Vector3 place) {}

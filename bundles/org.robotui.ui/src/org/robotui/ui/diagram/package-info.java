/**
 * Diagrams of boxes and wires: values that any thread makes and lays out, a canvas that shows them, and their form as
 * SVG. All lengths are points at a zoom of 1, x to the right, y down.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.ui.diagram;

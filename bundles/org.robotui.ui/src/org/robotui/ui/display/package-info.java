/**
 * The list of what a view shows, as the displays of a scene or the layers of a map: how it is written in settings,
 * where each takes its data from, and the control by which users add, order, colour and hide.
 */
@org.osgi.annotation.versioning.Version("2.1.0")
package org.robotui.ui.display;

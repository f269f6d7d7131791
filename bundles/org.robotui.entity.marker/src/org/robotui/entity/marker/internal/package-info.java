/** Markers of robots as parts of a scene. */
package org.robotui.entity.marker.internal;

/**
 * What can be drawn in space, as immutable values: entities make them on any thread, a renderer keeps them on the
 * graphics card. Metres and radians, right-handed, x forward, z up (REP 103). Nothing here touches OpenGL.
 */
@org.osgi.annotation.versioning.Version("2.1.0")
package org.robotui.gl.shape;
